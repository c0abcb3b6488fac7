# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Unexpected messages and peers, failing renders, forced ends."""

import asyncio
import os
import pathlib
import resource
import signal
import socket
import tempfile
import time
import urllib.parse
import urllib.request

from tests.focus import harness
from tests.focus.client import EXPECTED, PLANE, WORDS, ClientTest, page_at
from tests.focus.harness import SCENE
from tests.waiting import PATIENCE


class Messages(ClientTest):
    def test_what_the_page_does_not_send_ends_the_line(self):
        address = self.start(self.scene(), *WORDS)
        many = "1" * 400

        async def code(send):
            async with page_at(address) as page:
                await page.told("preview", "done")
                await send(page)
                return await page.closed()

        async def check():
            for name, send in {
                "Arabic digits in a block": lambda page: page.render(block="tilt_lens { f_stop \u0663 }"),
                "Arabic digits in an item": lambda page: page.render(items={"angle": "\u0663"}),
                "a long number": lambda page: page.socket.send_str('{"do": "preview", "clock": %s}' % many),
                "a longer number": lambda page: page.socket.send_str('{"do": "preview", "clock": %s}' % (20 * many)),
                "a long number in a block": lambda page: page.render(block=f"tilt_lens {{ f_stop {many} }}"),
                "a number beyond all": lambda page: page.socket.send_str('{"do": "preview", "clock": 1e999}'),
                "an end of line behind a block": lambda page: page.render(block=PLANE + "\n"),
                "half a quality": lambda page: page.render(quality=0.5),
                "a quality that is none": lambda page: page.render(quality=3),
                "a quality of words": lambda page: page.render(quality=[0]),
                "nothing expected": lambda page: page.write(expect={}),
                "a part of what is expected": lambda page: page.write(expect={"block": {"family": "plane"}, "camera": page.camera()}),
                "a wrong type": lambda page: page.write(expect={"block": {**EXPECTED, "fStop": "2"}, "camera": page.camera()}),
                "a wrong family": lambda page: page.write(expect={"block": {**EXPECTED, "family": "points"}, "camera": page.camera()}),
                "half a camera": lambda page: page.ask("preview", camera={"location": [0, 0, 0]}),
                "a camera that is none": lambda page: page.ask("preview", chosen=-1),
                "more than is asked for": lambda page: page.ask("undo", more=1),
                "deep JSON": lambda page: page.socket.send_str("[" * 30000),
                "no JSON": lambda page: page.socket.send_str("{"),
                "no name": lambda page: page.socket.send_str('{"do": ["preview"]}'),
            }.items():  # fmt: skip
                with self.subTest(name):
                    self.assertEqual(await code(send), 1008)

        asyncio.run(check())
        self.assertEqual(self.evidence(), "")

    def test_whole_numbers_may_have_a_point(self):
        address = self.start(self.scene(), *WORDS)

        async def render():
            async with page_at(address) as page:
                await page.told("preview", "done")
                await page.render(quality=1.0, size=[16.0, 9.0])
                return await page.told("picture", "done", "failed")

        self.assertEqual(asyncio.run(render())["state"], "done")
        self.assertEqual(self.evidence(), "")

    def test_next_render_after_a_failed_one(self):
        scene = self.scene()
        address = self.start(scene, *WORDS)

        async def render():
            async with page_at(address) as page:
                await page.told("refined")  # the preview has read the scene for the last time
                scene.rename(self.folder / "away")
                await page.render()
                failed = await page.told("picture", "done", "failed")
                (self.folder / "away").rename(scene)
                await page.render()
                return failed, await page.told("picture", "done", "failed")

        failed, done = asyncio.run(render())
        self.assertEqual((failed["state"], done["state"]), ("failed", "done"))
        self.assertIn("No such file", failed["message"])


class Peers(ClientTest):
    def ask(self, address, request):
        parts = urllib.parse.urlsplit(address)
        with socket.create_connection((parts.hostname, parts.port), timeout=60) as line:
            line.sendall(request)
            return line.makefile("rb").readline()

    def test_an_address_of_any_bytes_is_not_found(self):
        address = self.start(self.scene(), *WORDS)
        host = urllib.parse.urlsplit(address).netloc.encode()
        for path in (b"/\xe4/", b"/%E4/", b"/%F0%9F%98%80/", b"/\xc3\xa4/", b"/%00/"):
            with self.subTest(path):
                line = self.ask(address, b"GET " + path + b" HTTP/1.1\r\nHost: " + host + b"\r\nConnection: close\r\n\r\n")
                self.assertRegex(line, rb"^HTTP/1.1 40[04] ")
        self.assertEqual(self.evidence(), "")

    def test_endless_requests_block_no_other(self):
        limits = resource.getrlimit(resource.RLIMIT_NOFILE)
        self.addCleanup(resource.setrlimit, resource.RLIMIT_NOFILE, limits)
        resource.setrlimit(resource.RLIMIT_NOFILE, (1024, limits[1]))  # of the program
        address = self.start(self.scene(), *WORDS)
        resource.setrlimit(resource.RLIMIT_NOFILE, (min(4096, limits[1]), limits[1]))  # of this test
        parts = urllib.parse.urlsplit(address)

        async def ask():
            async with page_at(address) as page:
                await page.told("preview", "done")
                await page.render()  # needs files of its own
                return await page.told("picture", "done", "failed")

        for _ in range(1100):
            line = socket.create_connection((parts.hostname, parts.port), timeout=60)
            self.addCleanup(line.close)
            line.sendall(b"GET / HTTP/1.1\r\nHost")
        with urllib.request.urlopen(address, timeout=60) as answer:
            self.assertEqual(answer.status, 200)
        self.assertEqual(asyncio.run(ask())["state"], "done")
        self.assertEqual(self.evidence(), "")

    def test_slow_page_delays_no_other(self):
        address = self.start(self.scene(), "+W1200", "+H675")  # more than the buffers between the two programs hold
        deaf = socket.create_connection(urllib.parse.urlsplit(address).netloc.split(":"), timeout=60)
        self.addCleanup(deaf.close)
        deaf.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
        parts = urllib.parse.urlsplit(address)
        deaf.sendall(
            f"GET {parts.path}socket HTTP/1.1\r\nHost: {parts.netloc}\r\nOrigin: http://{parts.netloc}\r\nUpgrade: websocket\r\n"
            "Connection: Upgrade\r\nSec-WebSocket-Version: 13\r\nSec-WebSocket-Key: MDEyMzQ1Njc4OWFiY2RlZg==\r\n\r\n".encode()
        )
        self.assertIn(b"101", deaf.recv(100))

        async def render():
            async with page_at(address) as page:
                await page.told("preview", "done")
                await page.render()
                return await page.told("picture", "done")

        self.assertEqual(asyncio.run(render())["state"], "done")


class Ends(ClientTest):
    def test_ctrl_c_again_and_again_leaves_nothing(self):
        self.start(self.scene(), "+W800", "+H450")
        end = time.monotonic() + PATIENCE
        while self.process.poll() is None and time.monotonic() < end:
            os.killpg(self.process.pid, signal.SIGINT)
            time.sleep(0.003)
        self.assertEqual(self.process.poll(), 0, self.evidence())
        self.assertEqual(self.left(), [])
        self.assertEqual(self.evidence(), "")

    def test_what_a_kill_left_goes_at_the_next_start(self):
        scene = self.scene()
        self.start(scene, *WORDS)
        alive, first = self.process, self.scratch()
        self.start(scene, *WORDS)
        self.assertTrue(first.exists(), "the folder of a program that runs")
        self.assertEqual(self.end(signal.SIGINT), 0)
        self.process = alive
        self.end(signal.SIGKILL)
        self.assertEqual(self.left(), [first])
        other = self.folder / "tmp" / "focus-of-another-program"
        other.mkdir()
        self.start(scene, *WORDS)
        self.assertFalse(first.exists())
        self.assertTrue(other.exists())


class Names(ClientTest):
    def test_a_name_with_both_quotation_marks(self):
        folder = self.folder / 'it\'s "here"'
        folder.mkdir()
        scene = folder / "a'b\"c.pov"
        scene.write_text(SCENE + '#include "more.inc"\n')
        (folder / "more.inc").write_text("sphere { 0, 1 }\n")
        address = self.start(scene, *WORDS)

        async def use():
            async with page_at(address) as page:
                await page.told("preview", "done")
                await page.render()
                picture = await page.told("picture", "done", "failed")
                await page.write()
                written = await page.told("file")
                await page.told("preview", "done")
                (folder / "more.inc").write_text("sphere { 0, 2 }\n")
                changed = await page.told("changed")
                scene.write_text(SCENE + "sphere { 0, Wrong }\n")
                try:
                    await page.told("never")
                except AssertionError as error:
                    return picture, written, changed, str(error)

        picture, written, changed, error = asyncio.run(use())
        self.assertEqual((picture["state"], written["state"]), ("done", "written"), (picture, written))
        self.assertEqual(changed["files"], ["more.inc"])
        self.assertIn("Wrong", error)

    def test_files_elsewhere(self):
        with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
            (pathlib.Path(name) / "other.inc").write_text("sphere { 0, 1 }\n")
            scene = self.scene(SCENE + f'#include "{name}/other.inc"\n')

            async def use(address):
                async with page_at(address) as page:
                    return await page.told("preview", "done")

            with self.assertRaisesRegex(AssertionError, "Not permitted: reading"):
                asyncio.run(use(self.start(scene, *WORDS)))
            self.end()
            asyncio.run(use(self.start(scene, *WORDS, "--unrestricted")))


if __name__ == "__main__":
    harness.main()

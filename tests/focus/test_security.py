# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Accepted peers and refused requests."""

import asyncio
import http.client
import pathlib
import signal
import time
import urllib.parse

from tests.focus import harness
from tests.focus.client import ClientTest
from tests.focus.harness import SMALL


class Security(ClientTest):
    def ask(self, address, path=None, method="GET", **headers):
        """http.client sends the path unchanged."""
        parts = urllib.parse.urlsplit(address)
        connection = http.client.HTTPConnection(parts.hostname, parts.port, timeout=20)
        self.addCleanup(connection.close)
        connection.putrequest(method, parts.path if path is None else path, skip_host=True)
        headers.setdefault("Host", parts.netloc)
        for name, value in headers.items():
            connection.putheader(name, value)
        connection.endheaders()
        answer = connection.getresponse()
        return answer.status, dict(answer.getheaders()), answer.read()

    def test_only_the_page_with_the_secret_gets_an_answer(self):
        address = self.start(self.scene(), *SMALL)
        secret = urllib.parse.urlsplit(address).path
        status, headers, body = self.ask(address)
        self.assertEqual(status, 200)
        self.assertIn(b"<title>Focus</title>", body)
        policy = headers["Content-Security-Policy"]
        self.assertTrue(policy.startswith("default-src 'none'; script-src 'self';"), policy)
        self.assertNotIn("unsafe", policy)
        self.assertNotIn("Access-Control-Allow-Origin", headers)
        self.assertGreaterEqual(len(secret), 24)
        for path in ("/", "/x/", secret[:-2] + "/", secret.upper(), "/page/app.js"):
            with self.subTest(path):
                self.assertEqual(self.ask(address, path)[0], 404)
        for path in ("page/../focus.py", "page/..%2fserver.py", "page/%2e%2e/%2e%2e/etc/passwd", "../../etc/passwd", "page//etc/passwd",
                     "page/index.html%00", "scene.pov", "picture.png"):  # fmt: skip
            with self.subTest(path):
                self.assertEqual(self.ask(address, secret + path)[0], 404)
        for headers in ({"Host": "evil.example"}, {"Host": "127.0.0.1:1"}, {"Origin": "http://evil.example"}):
            with self.subTest(headers):
                self.assertEqual(self.ask(address, **headers)[0], 403)
        for method in ("POST", "PUT", "DELETE"):
            self.assertIn(self.ask(address, method=method)[0], (404, 405))
        self.assertEqual(self.ask(address, secret + "socket")[0], 403, "a socket without an origin")

    def test_it_listens_on_the_loopback_address_alone(self):
        address = self.start(self.scene(), *SMALL)
        port = urllib.parse.urlsplit(address).port
        lines = pathlib.Path("/proc/net/tcp").read_text() + pathlib.Path("/proc/net/tcp6").read_text()
        listening = [line.split()[1] for line in lines.splitlines() if f":{port:04X} " in line and " 0A " in line]
        self.assertEqual(listening, [f"0100007F:{port:04X}"])

    def test_bad_messages_end_the_connection_and_nothing_else(self):
        address = self.start(self.scene(), *SMALL)

        async def closes(message):
            import aiohttp

            origin = address.rsplit("/", 2)[0]
            async with aiohttp.ClientSession() as client:
                async with client.ws_connect(address + "socket", headers={"Origin": origin}, max_msg_size=0) as socket:
                    await socket.send_str(message)
                    while True:
                        got = await socket.receive(timeout=20)
                        if got.type in (aiohttp.WSMsgType.CLOSE, aiohttp.WSMsgType.CLOSED):
                            return socket.close_code

        block = "tilt_lens { f_stop 2 }"
        camera = '{"location": [0,0,0], "direction": [0,0,1], "right": [1,0,0], "up": [0,1,0]}'
        render = '{{"do": "render", "size": [{size}], "quality": 0, "camera": {camera}, "items": {items}, "block": "{block}"}}'

        def rendering(size="8, 8", camera=camera, items="{}", block=block):
            return render.format(size=size, camera=camera, items=items, block=block)

        for message in (
            "no JSON", "[]", '{"do": "eval"}', '{"do": "__init__"}', '{"do": "preview", "camera": {}}', '{"do": "preview", "clock": "1"}',
            '{"do": "preview", "chosen": 99}', '{"do": "write"}', rendering(size="8, 999999"), rendering(size="8.5, 8"), rendering(camera="{}"),
            rendering(camera=camera.replace("[0,0,0]", "[0,0,NaN]")), rendering(items='{"location": "<1, 1, 1>"}'),
            rendering(items='{"focal_point": "<1, 1, 1> } #include x"}'), rendering(block="tilt_lens { f_stop 2 } } sphere { 0, 1 }"),
            rendering(block="tilt_lens { #include 1 }"), rendering(block="tilt_lens { f_stop rand }"),
            rendering(block="tilt_lens { " + 20 * "focal_points " + "# }"), "x" * 100_000,
        ):  # fmt: skip
            with self.subTest(message[:90]):
                self.assertIn(asyncio.run(closes(message)), (1008, 1009, 1006))
        self.assertEqual(self.ask(address)[0], 200)
        self.assertNotIn("Traceback", self.evidence())

    def test_ctrl_c_leaves_no_process_and_no_file(self):
        slow = harness.SCENE.replace("plane { y", "media { scattering { 1, 1 } intervals 50 samples 100 } plane { y")
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            with self.subTest(number):
                self.start(self.scene(slow), "+W800", "+H450")
                time.sleep(0.7)
                self.assertTrue(self.left())
                begun = time.monotonic()
                self.assertEqual(self.end(number), 0, self.evidence())
                self.assertLess(time.monotonic() - begun, 15)
                self.assertEqual(self.left(), [])

    def test_it_ends_when_the_page_was_closed_for_a_while(self):
        address = self.start(self.scene(), *SMALL, idle=1)

        async def visit():
            import aiohttp

            async with aiohttp.ClientSession() as client:
                async with client.ws_connect(address + "socket", headers={"Origin": address.rsplit("/", 2)[0]}, max_msg_size=0):
                    await asyncio.sleep(2)
                    self.assertIsNone(self.process.poll(), "it ended while a page was open")

        asyncio.run(visit())
        self.until("the end", lambda: self.process.poll() is not None)
        self.assertEqual(self.process.returncode, 0)
        self.assertEqual(self.left(), [])


if __name__ == "__main__":
    harness.main()

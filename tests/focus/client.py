# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""A client of the page's socket."""

import asyncio
import contextlib
import json
import os
import pathlib

from tests.focus.harness import SCENE, FocusTest

SIZE = [16, 9]
WORDS = ("+W16", "+H9")
PATIENCE = 120  # seconds
PLANE = "tilt_lens {\n  f_stop 2\n  focal_plane { <0, 0, 1>, 2 }\n}"
EXPECTED = {
    "family": "plane", "filmWidth": 36, "focalLength": None, "sceneUnit": 1000, "shift": [0, 0], "fStop": 2, "blades": 0,
    "bladesAngle": 0, "planeNormal": [0, 0, 1], "planeDistance": 2,
}  # fmt: skip


class Page:
    def __init__(self, socket):
        self.socket = socket
        self.tiles = 0
        self.kinds = []  # of the messages so far
        self.view = None  # the scene's camera

    async def ask(self, what, **parts):
        await self.socket.send_str(json.dumps({"do": what, **parts}))

    async def told(self, kind, *states):
        async with asyncio.timeout(PATIENCE):
            while True:
                message = await self.socket.receive()
                if message.type.name == "BINARY":
                    self.tiles += 1
                    continue
                assert message.type.name == "TEXT", f"the line has ended: {message}"
                found = json.loads(message.data)
                self.kinds.append(found["type"])
                if found["type"] == "scene":
                    self.view = found["view"]
                if found["type"] == "error" and found["message"]:
                    raise AssertionError(found["message"])
                if found["type"] == kind and (not states or found["state"] in states):
                    return found

    async def closed(self):
        async with asyncio.timeout(PATIENCE):
            while (await self.socket.receive()).type.name in ("TEXT", "BINARY"):
                pass
        return self.socket.close_code

    def camera(self):
        return {name: self.view[name] for name in ("location", "direction", "right", "up")}

    def render(self, **parts):
        whole = {"size": SIZE, "quality": 0, "camera": self.camera(), "block": PLANE, "items": {}}
        return self.ask("render", **{**whole, **parts})

    def write(self, **parts):
        expect = {"block": EXPECTED, "camera": self.camera()}
        whole = {"block": PLANE, "items": {}, "expect": expect, "behind": {"block": PLANE, "expect": expect}}
        return self.ask("write", **{**whole, **parts})


@contextlib.asynccontextmanager
async def page_at(address, **options):
    import aiohttp

    async with aiohttp.ClientSession() as client:
        headers = {"Origin": address.rsplit("/", 2)[0]}
        async with client.ws_connect(address + "socket", headers=headers, max_msg_size=0, **options) as socket:
            yield Page(socket)


class ClientTest(FocusTest):
    def gated(self, text=SCENE):
        """The parse waits while the file `closed` exists."""
        gate = self.folder / "closed"
        return text + f'#while (file_exists("{gate}")) #end\n', gate

    def scratch(self):
        (found,) = (self.folder / "tmp").glob("focus-*")
        return found

    def left(self):
        found = list((self.folder / "tmp").iterdir())
        for name in filter(str.isdigit, os.listdir("/proc")):
            with contextlib.suppress(OSError):
                words = pathlib.Path(f"/proc/{name}/cmdline").read_bytes()
                if str(self.folder).encode() in words and b"chrom" not in words:
                    found.append(words)
        return found

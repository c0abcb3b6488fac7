# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later

import asyncio

from tools.focus.tasks import started, stopped

DEADLINE = 30  # seconds within which a message must be sent


class Peer:
    """Messages wait in a queue, so that a slow page delays no other. If too slow it is disconnected, and asks again."""

    def __init__(self, socket, transport):
        self.socket, self.transport = socket, transport
        self.queue = asyncio.Queue()
        self.task = started(self.write())

    def put(self, message):
        self.queue.put_nowait((asyncio.get_running_loop().time() + DEADLINE, message))

    async def write(self):
        try:
            while True:
                deadline, message = await self.queue.get()
                send = self.socket.send_str if isinstance(message, str) else self.socket.send_bytes
                async with asyncio.timeout_at(deadline):
                    await send(message)
        except (TimeoutError, ConnectionError, RuntimeError):
            self.transport.abort()

    async def close(self, code, words=b""):
        await stopped(self.task)
        try:
            async with asyncio.timeout(1):
                await self.socket.close(code=code, message=words)
        except (TimeoutError, ConnectionError):
            self.transport.abort()

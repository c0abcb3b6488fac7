# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Static files, and a socket for tiles and requests.

On the loopback address only. All addresses begin with a secret; other requests, or those for another host's name, are refused without
information. Files are read at start: no request names a file."""

import asyncio
import contextlib
import hmac
import pathlib
import secrets
import time

from aiohttp import WSMsgType, web

from tools.focus import messages, session as sessions
from tools.focus.peer import Peer

ADDRESS = "127.0.0.1"
PAGE = pathlib.Path(__file__).resolve().parent / "page"
TYPES = {".html": "text/html", ".css": "text/css", ".js": "text/javascript", ".svg": "image/svg+xml"}
LONGEST_MESSAGE = 64 * 1024
MOST_CONNECTIONS = 100  # that are not pages; far below a process's limit of open files
POLICY = (
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' blob: data:; connect-src 'self' {socket}; "
    "base-uri 'none'; form-action 'none'; frame-ancestors 'none'"
)


def page_files():
    return {path.name: (path.read_bytes(), TYPES[path.suffix]) for path in PAGE.iterdir() if path.suffix in TYPES}


class Server:
    def __init__(self, session, port):
        self.session, self.port = session, port
        self.secret = secrets.token_urlsafe(24)
        self.files = page_files()
        self.peers = set()
        self.last_seen = None  # time when the last page left; None before the first
        self.runner = self.listener = None

    async def start(self):
        """Returns the page's address."""
        app = web.Application(client_max_size=LONGEST_MESSAGE, middlewares=[self.guard])
        app.router.add_get("/{secret}/", self.index)
        app.router.add_get("/{secret}/page/{name}", self.page)
        app.router.add_get("/{secret}/socket", self.socket)
        app.router.add_get("/{secret}/picture.png", self.picture)
        self.runner = web.AppRunner(app, access_log=None, handle_signals=False)
        await self.runner.setup()
        self.listener = await asyncio.get_running_loop().create_server(self.connection, ADDRESS, self.port)
        self.port = self.listener.sockets[0].getsockname()[1]
        return f"http://{ADDRESS}:{self.port}/{self.secret}/"

    def connection(self):
        """Beyond the limit, closes the oldest that is not a page."""
        pages = [peer.transport for peer in self.peers]
        transports = [handler.transport for handler in self.runner.server.connections]
        others = [each for each in transports if each and each not in pages and not each.is_closing()]
        if len(others) >= MOST_CONNECTIONS:
            others[0].abort()
        return self.runner.server()

    async def stop(self):
        self.listener.close()
        await asyncio.gather(*(peer.close(1001) for peer in self.peers))
        for handler in self.runner.server.connections:
            if handler.transport:
                handler.transport.abort()
        with contextlib.suppress(TimeoutError):
            async with asyncio.timeout(2):
                await self.runner.cleanup()

    async def until_left(self, idle):
        """No page open for `idle` seconds after the first."""
        while True:
            await asyncio.sleep(0.2)
            if not self.peers and self.last_seen and time.monotonic() - self.last_seen > idle:
                return

    def own_host(self, value):
        return value in (f"{ADDRESS}:{self.port}", f"localhost:{self.port}")

    @web.middleware
    async def guard(self, request, handler):
        if not self.own_host(request.headers.get("Host", "")):
            return web.Response(status=403, text="Not this host.\n")
        secret = request.match_info.get("secret", "")
        if not hmac.compare_digest(secret.encode(errors="replace"), self.secret.encode()):
            return web.Response(status=404, text="Nothing here.\n")
        origin = request.headers.get("Origin")
        if origin is not None and not self.own_host(origin.removeprefix("http://")):
            return web.Response(status=403, text="Not from there.\n")
        response = await handler(request)
        if not response.prepared:
            response.headers["Content-Security-Policy"] = POLICY.format(socket=f"ws://{request.headers['Host']}")
            response.headers["X-Content-Type-Options"] = "nosniff"
            response.headers["Referrer-Policy"] = "no-referrer"
            response.headers["Cross-Origin-Resource-Policy"] = "same-origin"
            response.headers["Cross-Origin-Opener-Policy"] = "same-origin"
            response.headers["Cache-Control"] = "no-store"
        return response

    async def index(self, _request):
        return web.Response(body=self.files["index.html"][0], content_type="text/html", charset="utf-8")

    async def page(self, request):
        found = self.files.get(request.match_info["name"])
        if not found:
            raise web.HTTPNotFound(text="Nothing here.\n")
        return web.Response(body=found[0], content_type=found[1], charset="utf-8")

    async def picture(self, _request):
        path = self.session.picture.file
        if not path or not path.exists():
            raise web.HTTPNotFound(text="There is no finished picture.\n")
        name = pathlib.Path(self.session.settings.scene).stem
        safe = "".join(c if c.isascii() and (c.isalnum() or c in "-_.") else "_" for c in name)
        headers = {"Content-Disposition": f'attachment; filename="{safe}.png"'}
        return web.Response(body=path.read_bytes(), content_type="image/png", headers=headers)

    @staticmethod
    def put(message, peer):
        peer.put(message if isinstance(message, bytes) else sessions.as_text(message))

    async def socket(self, request):
        if request.headers.get("Origin") is None:
            return web.Response(status=403, text="Not from there.\n")
        socket = web.WebSocketResponse(max_msg_size=LONGEST_MESSAGE, heartbeat=20, compress=False)
        await socket.prepare(request)
        peer = Peer(socket, request.transport)
        view = self.session.connect(lambda message: self.put(message, peer))
        self.peers.add(peer)
        try:
            async for message in socket:
                if message.type != WSMsgType.TEXT:
                    break
                await self.obey(peer, view, message.data)
        finally:
            self.session.disconnect(view)
            self.peers.discard(peer)
            self.last_seen = time.monotonic()
            await peer.close(1000)
        return socket

    async def obey(self, peer, view, text):
        try:
            what, message = messages.read(text)
            getattr(self, f"do_{what}")(message, view)
        except messages.BadRequest:
            await peer.close(1008, b"bad request")

    def do_preview(self, message, view):
        view.ask(message)

    def do_render(self, message, view):
        messages.need(view.record)
        self.session.picture.start(messages.picture(message, view.record.kept_in_picture(view.chosen)), view)

    def do_stop(self, _message, _view):
        self.session.picture.stop()

    def do_write(self, message, view):
        messages.need(view.record)
        self.session.editor.start(message, view)

    def do_try(self, message, view):
        messages.need(view.record)
        self.session.editor.start_trial(message, view)

    def do_pull(self, message, view):
        messages.need(view.record)
        self.session.editor.start_pull(message, view)

    def do_undo(self, _message, _view):
        self.session.editor.start_undo()

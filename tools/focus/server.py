# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The page's server: the files of the page, and a socket that carries tiles and requests.

It listens on the loopback address only. All addresses begin with a secret; a request without it, or for another
host's name, learns nothing. What is served was read into memory before: no name in a request ever names a file."""

import asyncio
import hmac
import pathlib
import secrets
import time

from aiohttp import WSMsgType, web

from tools.focus import messages, session as sessions

ADDRESS = "127.0.0.1"
PAGE = pathlib.Path(__file__).resolve().parent / "page"
TYPES = {".html": "text/html", ".css": "text/css", ".js": "text/javascript", ".svg": "image/svg+xml"}
LONGEST_MESSAGE = 64 * 1024
POLICY = (
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' blob: data:; connect-src 'self' {socket}; "
    "base-uri 'none'; form-action 'none'; frame-ancestors 'none'"
)


def page_files():
    """Name -> (contents, type) of all that belongs to the page."""
    return {path.name: (path.read_bytes(), TYPES[path.suffix]) for path in PAGE.iterdir() if path.suffix in TYPES}


class Server:
    """Serves one session."""

    def __init__(self, session, port):
        self.session, self.port = session, port
        self.secret = secrets.token_urlsafe(24)
        self.files = page_files()
        self.sockets = set()
        self.locks = {}
        self.last_seen = None  # when the last page left; None before there was one
        session.send = self.send
        self.runner = None

    # ---- life ----

    async def start(self):
        """Begins to listen; returns the address of the page."""
        app = web.Application(client_max_size=LONGEST_MESSAGE, middlewares=[self.guard])
        app.router.add_get("/{secret}/", self.index)
        app.router.add_get("/{secret}/page/{name}", self.page)
        app.router.add_get("/{secret}/socket", self.socket)
        app.router.add_get("/{secret}/picture.png", self.picture)
        self.runner = web.AppRunner(app, access_log=None, handle_signals=False)
        await self.runner.setup()
        site = web.TCPSite(self.runner, ADDRESS, self.port)
        await site.start()
        self.port = site._server.sockets[0].getsockname()[1]  # pylint: disable=protected-access
        return f"http://{ADDRESS}:{self.port}/{self.secret}/"

    async def stop(self):
        """Lets all pages go and stops listening."""
        for socket in list(self.sockets):
            await socket.close(code=1001)
        await self.runner.cleanup()

    async def until_left(self, idle):
        """Returns when no page has been open for so many seconds, after there was one."""
        while True:
            await asyncio.sleep(0.2)
            if not self.sockets and self.last_seen and time.monotonic() - self.last_seen > idle:
                return

    # ---- who may ask ----

    def own_host(self, value):
        """Whether a request's Host is this server's, under its numeric address or as localhost."""
        return value in (f"{ADDRESS}:{self.port}", f"localhost:{self.port}")

    @web.middleware
    async def guard(self, request, handler):
        """Refuses what does not come from the page, and dresses the answers."""
        if not self.own_host(request.headers.get("Host", "")):
            return web.Response(status=403, text="Not this host.\n")
        secret = request.match_info.get("secret", "")
        if not hmac.compare_digest(secret.encode(), self.secret.encode()):
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

    # ---- answers ----

    async def index(self, _request):
        """The page."""
        return web.Response(body=self.files["index.html"][0], content_type="text/html", charset="utf-8")

    async def page(self, request):
        """A file of the page."""
        found = self.files.get(request.match_info["name"])
        if not found:
            raise web.HTTPNotFound(text="Nothing here.\n")
        return web.Response(body=found[0], content_type=found[1], charset="utf-8")

    async def picture(self, _request):
        """The true picture, to be saved."""
        path = self.session.picture.file
        if not path or not path.exists():
            raise web.HTTPNotFound(text="There is no finished picture.\n")
        name = pathlib.Path(self.session.settings.scene).stem
        safe = "".join(c if c.isascii() and (c.isalnum() or c in "-_.") else "_" for c in name)
        headers = {"Content-Disposition": f'attachment; filename="{safe}.png"'}
        return web.Response(body=path.read_bytes(), content_type="image/png", headers=headers)

    # ---- the socket ----

    async def send(self, message, only=None):
        """Sends a message to one page or to all."""
        for socket in list(self.sockets) if only is None else [only]:
            try:
                async with self.locks.setdefault(socket, asyncio.Lock()):
                    if isinstance(message, bytes):
                        await socket.send_bytes(message)
                    else:
                        await socket.send_str(sessions.as_text(message))
            except (ConnectionError, RuntimeError):
                self.sockets.discard(socket)

    async def socket(self, request):
        """Speaks with one page."""
        if request.headers.get("Origin") is None:
            return web.Response(status=403, text="Not from there.\n")
        socket = web.WebSocketResponse(max_msg_size=LONGEST_MESSAGE, heartbeat=20, compress=False)
        await socket.prepare(request)
        self.sockets.add(socket)  # first: a tile that comes meanwhile is sent to it, or is in what is sent now
        try:
            for message in self.session.everything():
                await self.send(message, only=socket)
            async for message in socket:
                if message.type == WSMsgType.TEXT:
                    await self.obey(socket, message.data)
                else:
                    break
        finally:
            self.sockets.discard(socket)
            self.locks.pop(socket, None)
            self.last_seen = time.monotonic()
        return socket

    async def obey(self, socket, text):
        """Does what a page asks for, or closes the socket."""
        try:
            what, message = messages.read(text)
            handler = getattr(self, f"do_{what}", None) if what.isidentifier() else None
            messages.need(handler)
            await handler(message)
        except messages.BadRequest:
            await socket.close(code=1008, message=b"bad request")

    async def do_preview(self, message):
        """A preview with this camera, this clock, or the scene's own."""
        session = self.session
        frame = message.get("camera")
        chosen = message.get("chosen")
        if "clock" in message:
            session.clock = messages.number(message["clock"])
        if chosen is not None:
            messages.need(session.record and isinstance(chosen, int) and 0 <= chosen < len(session.record["cameras"]))
            session.chosen = chosen
        session.start_preview(None if frame is None else messages.camera(frame))

    async def do_render(self, message):
        """The true picture."""
        messages.need(self.session.record)
        self.session.picture.start(messages.picture(message, self.session.kept_in_picture()))

    async def do_stop(self, _message):
        """Stops the true picture."""
        self.session.picture.stop()

    async def do_write(self, message):
        """Writes the block into the scene."""
        messages.need(self.session.record)
        await self.session.editor.write(messages.change(message))

    async def do_undo(self, _message):
        """Takes the last change of the scene back."""
        await self.session.editor.undo()

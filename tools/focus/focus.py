# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The command `focus`: a local page that shows a scene's focus live and puts it where one clicks."""

import argparse
import asyncio
import logging
import os
import re
import signal
import sys
import webbrowser

from tools import povray_run
from tools.focus import temporary
from tools.focus.options import Options
from tools.focus.tasks import stopped

ENDING = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)
HELP = """Options of POV-Ray may follow, as for ./render: +W1280 +H720 Declare=Tilt=4
Press Ctrl-C to end. See docs/focus.md."""


def port(text):
    if not text.isdigit() or int(text) > 65535:
        raise argparse.ArgumentTypeError(f"{text!r}: expected a whole number from 0 to 65535")
    return int(text)


def seconds(text):
    try:
        value = float(text)
    except ValueError:
        value = -1
    if not 0 < value < 1e9:
        raise argparse.ArgumentTypeError(f"{text!r}: expected a number of seconds, more than 0")
    return value


def parser():
    top = argparse.ArgumentParser(prog="focus", allow_abbrev=False, epilog=HELP, description=__doc__.split("`: ")[1].capitalize())
    top.add_argument("scene", help="the scene file")
    top.add_argument("--no-browser", action="store_true", help="only print the address")
    top.add_argument("--port", type=port, default=0, help="where to listen (default: any that is free)")
    top.add_argument(
        "--idle", type=seconds, default=60, metavar="SECONDS", help="end when the page has been closed for so long (default: 60)"
    )
    top.add_argument("--povray", default=os.environ.get("FOCUS_POVRAY"), metavar="PROGRAM", help=argparse.SUPPRESS)
    return top


def real_lenses():
    """{"lenses": [...], "films": [...]} of tilt_lens.inc, millimetres and degrees."""
    text = (povray_run.INCLUDE / "tilt_lens.inc").read_text(encoding="utf-8")
    number = r"\s*([\d.]+)\s*"
    lenses = re.findall(rf"#declare Tilt_Lens_\w+\s*= array\[4\] {{{number},{number},{number},{number}}}\s*// (.+)", text)
    films = re.findall(rf"#declare Tilt_Lens_Film_(\w+)\s*= array\[2\] {{{number},{number}}}", text)
    return {
        "lenses": [
            {"name": name.strip(), "focalLength": float(f), "fStop": float(n), "tilt": float(t), "shift": float(s)}
            for f, n, t, s, name in lenses
        ],
        "films": [{"name": name.replace("_", " "), "size": [float(a), float(b)]} for name, a, b in films],
    }


async def serve_until_ended(settings, folder):
    ended, loop = asyncio.Event(), asyncio.get_running_loop()

    def end(*_):
        if not loop.is_closed():
            loop.call_soon_threadsafe(ended.set)

    # handlers of add_signal_handler() go when the loop closes: the next signal would kill the program before its folder is removed
    for number in ENDING:
        signal.signal(number, end)
    signal.pthread_sigmask(signal.SIG_UNBLOCK, ENDING)
    return await serve(settings, folder, ended)


async def serve(settings, folder, ended):
    # aiohttp loads slowly, and help needs none of it
    from tools.focus.server import Server  # pylint: disable=import-outside-toplevel
    from tools.focus.session import Session  # pylint: disable=import-outside-toplevel

    session = Session(settings, folder)
    server = Server(session, settings.port)
    try:
        address = await server.start()
    except OSError as error:
        print(f"focus: cannot listen on port {settings.port}: {os.strerror(error.errno)}", file=sys.stderr)
        return 1
    session.start_preview()
    print(f"Focus of {settings.scene}\n  {address}\nCtrl-C ends it.", flush=True)
    if not settings.no_browser and (os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY")):
        webbrowser.open(address)
    tasks = [asyncio.create_task(coroutine) for coroutine in (ended.wait(), server.until_left(settings.idle), session.watch())]
    try:
        await asyncio.wait(tasks, return_when=asyncio.FIRST_COMPLETED)
    finally:
        for task in tasks:
            await stopped(task)
        await session.end()
        await server.stop()
    return 0


def main(words):
    settings, options = parser().parse_known_args(words)
    logging.basicConfig(level=logging.WARNING)
    unknown = [word for word in options if word.startswith("--") and word != "--unrestricted"]
    if unknown:
        parser().error(f"unknown option {unknown[0]}")
    if not settings.povray:
        parser().error("no program: call ./focus of the repository.")
    settings.scene = os.path.abspath(settings.scene)
    if not os.access(settings.scene, os.R_OK) or not os.path.isfile(settings.scene):
        print(f"focus: there is no readable scene file {settings.scene}", file=sys.stderr)
        return 1
    settings.options = Options(options)
    settings.program = os.path.abspath(settings.povray)
    settings.lenses = real_lenses()
    # an earlier signal would leave the folder behind
    signal.pthread_sigmask(signal.SIG_BLOCK, ENDING)
    try:
        with temporary.folder() as folder:
            return asyncio.run(serve_until_ended(settings, folder))
    except OSError as error:
        print(f"focus: {error.filename or 'the folder for pictures'}: {os.strerror(error.errno)}", file=sys.stderr)
        return 1
    finally:
        for number in ENDING:
            signal.signal(number, signal.SIG_IGN)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

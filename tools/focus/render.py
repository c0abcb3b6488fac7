# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""One run of POV-Ray in the background."""

import asyncio
import contextlib
import json
import os
import re
import signal

from tools import povray_run
from tools.focus import tiles
from tools.povray_run import quoted

OWN = ("+FN", "Output_to_File=on", "-C", "+SP1", "+EP1", "+KFI1", "+KFF1")
STEP = 0.05  # seconds between looks at a render's files
BACKGROUND = 10  # niceness of a render that nobody waits for


class RenderError(Exception):
    def __init__(self, message, file=None, line=None):
        super().__init__(message)
        self.message, self.file, self.line = message, file, line


def error_in(text):
    text = text.replace("\r", "\n")
    found = re.search(
        r"^(?:File '(?P<file>(?:(?!'\s+line\s+\d)[\s\S])+)'\s+line\s+(?P<line>\d+):\s+)?"
        r"(?P<kind>[A-Z]\w*\s+Error|Fatal error[^:\n]*|Error):\s?"
        r"(?P<rest>.*(?:\n(?!Fatal error|Render failed|POV-Ray finished|=|-|\s*$).*)*)",
        text,
        re.MULTILINE,
    )
    if not found:
        lines = [line for line in text.splitlines() if line.strip()]
        return RenderError("POV-Ray ended without a picture. " + " ".join(lines[-3:]))
    message = re.sub(r"\s*\n\s*", " ", found["rest"]).strip()
    if not found["file"]:
        return RenderError(message)
    name = found["file"].replace("\n", "")  # POV-Ray breaks lines even within names
    return RenderError(message, name, int(found["line"]))


def nameable(path, folder, link):
    """A path with both kinds of quotation marks gets a link in our folder."""
    if not {'"', "'"} <= set(str(path)):
        return path
    made = folder / link
    if not made.is_symlink():
        made.symlink_to(path)
    return made


def with_quotes(option):
    """The shell removed the quotation marks of a user's option."""
    if not re.search(r"\s", option) or re.search(r"[\"']", option):
        return option
    head = re.match(r"[-+][IiLlOo]|\w+_(?:Name|Path)=", option)
    return head.group() + quoted(option[head.end() :]) if head else option


class Render:
    def __init__(self, program, folder, name, background=False):
        self.program, self.folder, self.name = program, folder, name
        self.niceness = BACKGROUND if background else 0
        self.process = None
        self.stopped = False
        self.file_list = None
        self.picture = folder / f"{name}.png"
        self.record = folder / f"{name}.camera.json"

    def words(self, scene, options, size):
        scene = nameable(scene, self.folder, "scene-link.pov")
        return povray_run.command(self.program, scene, self.picture, size, *OWN, before=map(with_quotes, options))

    def environment(self, preview):
        env = povray_run.user_environment((*povray_run.DISPLAYS, "TILT_LENS_PREVIEW"))
        if preview:
            self.record.unlink(missing_ok=True)
            env["TILT_LENS_PREVIEW"] = str(self.record)
        if self.file_list:
            self.file_list.unlink(missing_ok=True)
            env["TILT_LENS_FILE_LIST"] = str(self.file_list)
        return env

    async def run(self, words, preview, on_tile, on_camera=None):
        """Returns the output. @throws RenderError unless the run finished or was stopped"""
        state = tiles.StateFile(self.folder / f"{self.name}.pov-state")
        log = self.folder / f"{self.name}.log"
        try:
            with open(log, "wb") as stream:
                self.process = await asyncio.create_subprocess_exec(
                    "nice",
                    f"-n{self.niceness}",
                    "setpriv",
                    "--pdeathsig",
                    "KILL",
                    *words,
                    stdin=asyncio.subprocess.DEVNULL,
                    stdout=stream,
                    stderr=stream,
                    env=self.environment(preview),
                )
            camera_told = False
            over = False
            while not over:
                with contextlib.suppress(TimeoutError):
                    async with asyncio.timeout(STEP):
                        await self.process.wait()
                        over = True
                if preview and not camera_told and self.camera() is not None:
                    camera_told = True
                    if on_camera:
                        await on_camera(self.camera())
                for tile in state.tiles():
                    if not self.stopped:
                        await on_tile(tile)
            said = log.read_text(encoding="utf-8", errors="replace")
            if self.process.returncode != 0 and not self.stopped:
                raise error_in(said)
            return said
        finally:
            state.close()
            await self.stop()

    def camera(self):
        """From TILT_LENS_PREVIEW; None until it is written."""
        try:
            return json.loads(self.record.read_text(encoding="utf-8"))
        except (OSError, ValueError):
            return None

    async def stop(self):
        if self.process and self.process.returncode is None:
            self.stopped = True
            with contextlib.suppress(ProcessLookupError):
                os.kill(self.process.pid, signal.SIGKILL)  # send_signal would reap the exit code that asyncio waits for
            await self.process.wait()

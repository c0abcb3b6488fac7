# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later

import atexit
import dataclasses
import os
import pathlib
import re
import shlex
import struct
import subprocess
import threading
import time

from tools.repository import ROOT

INCLUDE = ROOT / "scenes" / "include"
NO_SETTINGS = ROOT / "tools" / "no_settings.ini"
DISPLAYS = ("DISPLAY", "WAYLAND_DISPLAY")
USER_SETTINGS = ("POVINI", "POVINC", *DISPLAYS)
# seconds until a run counts as hanging
PATIENCE = 600
# upstream keeps parsed objects until the end
WITHOUT_LEAKS = {"ASAN_OPTIONS": "detect_leaks=0"}
STATE_HEADER = 512  # bytes of a state file before its first message


class Failed(Exception):
    pass


class UnreadablePicture(Exception):
    """The comparison tool cannot decode a picture."""


def quoted(name):
    name = str(name)
    if not re.search(r"[\s;#\"']", name):
        return name
    return f"'{name}'" if '"' in name else f'"{name}"'


def command(program, scene, picture, size, *options, library=(), before=()):
    """@param picture  None: none is written; "": named after the scene
    @param library  further include folders
    @param before   user's options, which must not change scene, picture or size"""
    output = ["-F"] if picture is None else [f"+O{quoted(picture)}"] if picture else []
    folders = [f"+L{quoted(folder)}" for folder in library]
    return [
        os.path.abspath(program),
        "-A",
        *before,
        f"+I{quoted(scene)}",
        *output,
        f"+W{size[0]}",
        f"+H{size[1]}",
        "-D",
        "-P",
        *folders,
        *map(str, options),
    ]


def part(left, top, width, height):
    """Options for these columns and rows of the picture, counted from 0."""
    return [f"+SC{left + 1}", f"+EC{left + width}", f"+SR{top + 1}", f"+ER{top + height}"]


def user_environment(without=USER_SETTINGS, **variables):
    return {**{name: value for name, value in os.environ.items() if name not in without}, **variables}


def environment(**variables):
    """The environment in which POV-Ray reads no INI file."""
    return user_environment(**{"POVINI": str(NO_SETTINGS), **variables})


def held_to_permissions():
    """Words before a command that subject even root to file permissions."""
    powers = "-dac_override,-dac_read_search"
    return ["setpriv", f"--bounding-set={powers}", f"--inh-caps={powers}"] if os.getuid() == 0 else []


@dataclasses.dataclass
class Done:
    command: list
    code: int | None  # exit code, or minus the signal; None: ended because of the time limit
    said: str
    cpu: float  # seconds, user and system
    seconds: float
    memory: int  # peak of resident memory, bytes

    def told(self):
        ended = (
            f"no end after {self.seconds:.0f} s"
            if self.code is None
            else f"exit code {self.code}"
            if self.code >= 0
            else f"signal {-self.code}"
        )
        return f"{shlex.join(self.command)}\n{ended}\n{self.said[-3000:]}"

    def succeeded(self):
        if self.code != 0:
            raise Failed(self.told())
        return self


def start(words, folder=None, env=None, **how):
    how = {"stdin": subprocess.DEVNULL, "stdout": subprocess.PIPE, "stderr": subprocess.STDOUT, **how}
    return subprocess.Popen([str(word) for word in words], cwd=folder, env=environment() if env is None else env, **how)


def run(words, folder=None, env=None, limit=PATIENCE, **how):
    begun = time.monotonic()
    process = start(words, folder, env, **how)
    late = threading.Event()
    timer = threading.Timer(limit or 0, lambda: (late.set(), process.kill()))
    if limit:
        timer.start()
    try:
        said = process.stdout.read().decode(errors="replace") if process.stdout else ""
        _, status, usage = os.wait4(process.pid, 0)
    except BaseException:
        process.kill()
        raise
    finally:
        timer.cancel()
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.stdout:
        process.stdout.close()
    code = None if late.is_set() else process.returncode
    return Done(process.args, code, said, usage.ru_utime + usage.ru_stime, time.monotonic() - begun, 1024 * usage.ru_maxrss)


def sources(scene, folders=()):
    """In a file's own folder or the first of `folders` that has it."""
    found = [pathlib.Path(scene)]
    for path in found:
        for name in re.findall(r'#include\s+"([^"]+)"', path.read_text()):
            included = next((folder / name for folder in (found[0].parent, *folders) if (folder / name).is_file()), None)
            if included and included not in found:
                found.append(included)
    return found


def whole_messages(data, end=None):
    """Start of messages and end of the last complete one; empty if it is no state file."""
    end = len(data) if end is None else end
    if end < STATE_HEADER or not data.startswith(b"POV-Ray Render State File"):
        return []
    at = [STATE_HEADER]
    while at[-1] + 20 <= end and data[at[-1] : at[-1] + 8] == b"POVRAYMS":
        size = struct.unpack(">i", data[at[-1] + 12 : at[-1] + 16])[0]
        if size <= 0 or at[-1] + 20 + size > end:
            break
        at.append(at[-1] + 20 + size)
    return at


class Reader:
    """Reads many pictures in one process, because its start is slow. Thread-safe."""

    def __init__(self, compare):
        self.compare = compare
        self.lock = threading.Lock()
        self.process = None

    def ask(self, path):
        """Width, height, number, type and names of the channels, and the values. Raises UnreadablePicture."""
        with self.lock:
            if self.process is None or self.process.poll() is not None:
                self.process = subprocess.Popen([self.compare, "pixels"], stdin=subprocess.PIPE, stdout=subprocess.PIPE)
                atexit.register(self.process.communicate)
            self.process.stdin.write(os.fsencode(os.path.abspath(path)) + b"\n")
            self.process.stdin.flush()
            size = self.process.stdout.readline()
            if not size.strip().isdigit():
                raise UnreadablePicture(size.decode(errors="replace") or f"{path}: the comparison tool ended")
            return self.process.stdout.read(int(size))


READERS = {}


def pixels(compare, path):
    return READERS.setdefault(str(compare), Reader(str(compare))).ask(path)

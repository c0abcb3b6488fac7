# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Runs POV-Ray on a part of a picture, with a state file fit for continuing."""

import os
import re
import shutil
import signal
import subprocess

from tools import povray_run
from tools.batch.plan import POVINC
from tools.batch.store import BatchError, boot, read_json, write_json
from tools.povray_run import STATE_HEADER

PICTURE = "picture"  # stem of POV-Ray's files in a unit's folder
KILLED = (signal.SIGKILL, signal.SIGTERM, signal.SIGINT, signal.SIGHUP, signal.SIGXCPU)  # signals from outside
PAGE = 4096


def ending_with_parent(command):
    return ["setpriv", "--pdeathsig", "KILL", *command]


def version(program):
    try:
        done = subprocess.run(
            [program, "--version"], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=True, timeout=60
        )
    except (OSError, subprocess.SubprocessError) as error:
        raise BatchError(f"cannot run {program!r}: {error}") from None
    lines = [line.strip() for line in done.stdout.decode(errors="replace").splitlines()]
    told = [line for line in lines if line.startswith(("POV-Ray 3", "Persistence", "povray-tilt-lens"))]
    return " / ".join(told) or lines[0]


def arguments(description, picture, rows, size=None):
    key = description["key"]
    words = [*key["options"], *picture["options"]]
    words += [f"+I{description['input']}", *(f"+L../../inputs/{name}" for name in description["searched"])]
    if size:
        words += [f"+W{size[0]}", f"+H{size[1]}"]
    words += [
        f"+SR{rows[0]}",
        f"+ER{rows[1]}",
        f"+O{PICTURE}.{key['extension']}",
        f"+WT{description['threads']}",
        "-D",
        "-P",
        "Output_to_File=on",
    ]
    if description["kind_option"]:
        words.append(description["kind_option"])
    frame, last = picture["frame"], description["frames"]
    if last > 1:
        words += [f"+KFI1 +KFF{last} +SF{frame} +EF{frame}".split()]
        return [*words[:-1], *words[-1]]
    return [*words, "+KFI1", "+KFF1"]


def environment(links):
    included = {"POVINC": f"../../inputs/{POVINC}"} if POVINC in links else {}
    return povray_run.user_environment(POVINI="../../inputs/povray.ini", TILT_LENS_FILE_LIST="files", **included)


def state_file(folder):
    return next(iter(sorted(folder.glob(f"{PICTURE}*.pov-state"))), None)


def whole_length(data, trusted):
    """Bytes of complete messages. If the machine has stopped (not `trusted`), zeros end them: some pages may be lost."""
    end = len(data)
    if not trusted:
        pages = (at for at in range(STATE_HEADER - STATE_HEADER % PAGE, end, PAGE) if not any(data[max(at, STATE_HEADER) : at + PAGE]))
        end = next(pages, end)
    return max(povray_run.whole_messages(data, end), default=0)


def prepare_state(folder):
    """Cuts off the unreliable end; returns the length, 0 for none."""
    path = state_file(folder)
    if path is None:
        return 0
    data = path.read_bytes()
    whole = whole_length(data, read_json(folder / "boot.json") == boot())
    if whole <= STATE_HEADER:
        path.unlink()
        return 0
    if whole < len(data):
        os.truncate(path, whole)
    return whole


def clear_output(folder, also_state=False):
    """POV-Ray would take a truncated picture for a finished one."""
    for path in folder.glob(f"{PICTURE}*"):
        if also_state or path.suffix != ".pov-state":
            path.unlink()


def start(description, folder, words, log, lock=None):
    """POV-Ray inherits the unit's lock, which excludes other tries."""
    write_json(folder / "boot.json", boot())
    with open(log, "ab") as stream:
        return subprocess.Popen(
            ending_with_parent([description["program"], *words]),
            cwd=folder,
            env=environment(description["links"]),
            stdin=subprocess.DEVNULL,
            stdout=stream,
            stderr=stream,
            pass_fds=[lock] if lock is not None else [],
        )


def outputs(folder):
    """{rest of the name after "picture" and frame number: file}."""
    found = {}
    for path in sorted(folder.glob(f"{PICTURE}*")):
        if path.suffix in (".png", ".exr"):
            found[re.sub(rf"^{PICTURE}\d*", "", path.name)] = path
    return found


def image_info(path):
    done = subprocess.run(
        ending_with_parent(["oiiotool", "--info", "--hash", path.name]),
        cwd=path.parent,
        stdin=subprocess.DEVNULL,
        capture_output=True,
        check=False,
    )
    text = done.stdout.decode(errors="replace")
    size = re.search(r":\s*(\d+) x\s*(\d+), (\d+) channel, (.*)", text)
    pixels = re.search(r"SHA-1: ([0-9A-F]{40})", text)
    if done.returncode != 0 or not size or not pixels or done.stderr.strip():
        said = (done.stderr.decode(errors="replace") + text).strip()
        raise BatchError(f"{path.name} cannot be decoded: {said[-300:]}")
    return {
        "size": [int(size.group(1)), int(size.group(2))],
        "channels": int(size.group(3)),
        "form": size.group(4).strip(),
        "pixels": pixels.group(1),
    }


def needed_programs():
    for name, package in (("setpriv", "util-linux"), ("oiiotool", "openimageio-tools")):
        if shutil.which(name) is None:
            raise BatchError(f"{name} is missing on {os.uname().nodename} (Debian package {package}).")

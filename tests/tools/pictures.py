# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Renders and compares one picture, and distinguishes every kind of failure."""

import dataclasses
import hashlib
import json
import pathlib
import re
import shutil
import subprocess

from tests.waiting import PATIENCE

OUTCOMES = {
    "same": 0,
    "failure": 1,
    "different": 2,
    "missing reference": 3,
    "no output": 4,
    "wrong size": 5,
    "unreadable": 6,
    "not finite": 7,
    "crash": 8,
    "stale reference": 9,
    "timeout": 10,
}
# meanings of the exit codes of `compare` (compare.cpp)
COMPARE_OUTCOMES = ["same", "failure", "different", "missing reference", "no output", "wrong size",
                    "unreadable", "not finite"]


class Trouble(Exception):
    """One of OUTCOMES and the reason."""

    def __init__(self, outcome, reason):
        super().__init__(reason)
        self.outcome = outcome


@dataclasses.dataclass
class Render:
    povray: str
    scene: pathlib.Path
    width: int
    height: int
    options: list = dataclasses.field(default_factory=list)


def sources(scene):
    """The scene and the files of its own folder that it includes, in order of appearance."""
    found = [scene]
    for path in found:
        for name in re.findall(r'#include\s+"([^"]+)"', path.read_text()):
            included = scene.parent / name
            if included.is_file() and included not in found:
                found.append(included)
    return found


def command_of(job, output):
    """The command line, run in the folder that holds copies of the scene's files."""
    return [job.povray, "+I" + job.scene.name, "+O" + output, f"+W{job.width}", f"+H{job.height}",
            "-D", "-V", "-GA", "-P", "-A", "+WT1", *job.options]


def render(job, folder, output):
    """Renders into the folder, which is made; returns the command. Raises Trouble.

    POV-Ray may always read and write in its working folder, whatever its permissions for others, so the scene's files are copied there.
    """
    folder.mkdir(parents=True, exist_ok=True)
    for source in sources(job.scene):
        shutil.copyfile(source, folder / source.name)
    picture = folder / output
    picture.unlink(missing_ok=True)
    (folder / (output + ".pov-state")).unlink(missing_ok=True)
    command = command_of(job, output)
    log = folder / (output + ".log")
    try:
        with log.open("wb") as messages:
            done = subprocess.run(command, cwd=folder, stdin=subprocess.DEVNULL, stdout=messages,
                                  stderr=subprocess.STDOUT, timeout=PATIENCE, check=False)
    except subprocess.TimeoutExpired:
        reason = f"no picture after {PATIENCE} s; messages in {log}"
        raise Trouble("timeout", reason) from None
    except OSError as error:
        raise Trouble("failure", f"cannot run {job.povray}: {error.strerror}") from None
    if done.returncode != 0:
        code = done.returncode
        how = f"signal {-code}" if code < 0 else f"exit code {code}"
        raise Trouble("crash", f"{job.povray} ended with {how}; messages in {log}:\n{tail(log)}")
    if not picture.is_file():
        raise Trouble("no output", f"the program ended well but wrote no {picture}; see {log}")
    return command


def tail(log, lines=12):
    return "\n".join("  " + line for line in log.read_text(errors="replace").splitlines()[-lines:])


def compare(program, picture, reference, comparison):
    kind = comparison["kind"]
    command = [str(program), kind, str(picture), str(reference)]
    for name, value in comparison.items():
        if name != "kind":
            command += ["--" + name.replace("_", "-"), repr(value)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    code = done.returncode
    outcome = COMPARE_OUTCOMES[code] if 0 <= code < len(COMPARE_OUTCOMES) else "failure"
    figures = json.loads(done.stdout) if done.stdout.strip() else {}
    if outcome != "same":
        trouble = Trouble(outcome, done.stderr.strip().removeprefix("compare: "))
        trouble.figures = figures
        raise trouble
    return figures


def pixel_hash(program, picture):
    """SHA-256 of the decoded pixels, independent of the file around them."""
    done = subprocess.run([str(program), "pixels", str(picture)], capture_output=True, check=False)
    if done.returncode != 0:
        raise Trouble("unreadable", done.stderr.decode(errors="replace").strip())
    return hashlib.sha256(done.stdout).hexdigest()


def file_hash(path):
    return hashlib.sha256(path.read_bytes()).hexdigest()

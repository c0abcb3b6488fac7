# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later

import dataclasses
import hashlib
import json
import pathlib
import shutil
import subprocess

from tools import povray_run

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
COMPARE_OUTCOMES = ["same", "failure", "different", "missing reference", "no output", "wrong size", "unreadable", "not finite"]


class Trouble(Exception):
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


def command_of(job, output):
    return povray_run.command(job.povray, job.scene.name, output, (job.width, job.height), "-V", "-GA", "+WT1", *job.options)


def render(job, folder, output):
    """POV-Ray may always use its working folder, so the scene's files are copied there."""
    folder.mkdir(parents=True, exist_ok=True)
    for source in povray_run.sources(job.scene):
        shutil.copyfile(source, folder / source.name)
    picture = folder / output
    picture.unlink(missing_ok=True)
    (folder / (output + ".pov-state")).unlink(missing_ok=True)
    command = command_of(job, output)
    try:
        done = povray_run.run(command, folder)
    except OSError as error:
        raise Trouble("failure", f"cannot run {job.povray}: {error.strerror}") from None
    if done.code is None:
        raise Trouble("timeout", f"no picture: {done.told()}")
    if done.code != 0:
        raise Trouble("crash", done.told())
    if not picture.is_file():
        raise Trouble("no output", f"the program ended well but wrote no {picture}: {done.told()}")
    return command


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
    try:
        return hashlib.sha256(povray_run.pixels(program, picture)).hexdigest()
    except povray_run.UnreadablePicture as error:
        raise Trouble("unreadable", str(error).strip()) from None


def file_hash(path):
    return hashlib.sha256(path.read_bytes()).hexdigest()

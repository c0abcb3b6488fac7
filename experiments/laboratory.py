# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Programs, folders, rendering and checked claims."""

import csv
import dataclasses
import hashlib
import json
import pathlib
import shutil
import subprocess

from tools import povray_run
from tools.povray_run import Failed
from tools.repository import ROOT

SCENES = ROOT / "scenes" / "paper"
OWN_SCENES = ROOT / "experiments" / "scenes"


@dataclasses.dataclass
class Claim:
    """A measured number: absolute value at most `limit`, or between `low` and `limit`."""

    text: str
    value: float
    limit: float
    unit: str = ""
    low: float = None

    @property
    def holds(self):
        if self.low is not None:
            return self.low <= self.value <= self.limit
        return abs(self.value) <= self.limit

    def allowed(self):
        return f"{self.limit:.3g}" if self.low is None else f"{self.low:.3g} to {self.limit:.3g}"

    def line(self):
        verdict = "ok  " if self.holds else "FAIL"
        return f"{verdict} {self.text}: {self.value:.4g} {self.unit} (limit {self.allowed()})"


@dataclasses.dataclass
class Laboratory:
    povray: pathlib.Path
    stock: pathlib.Path
    tools: pathlib.Path
    work: pathlib.Path
    results: pathlib.Path
    quick: bool = False
    threads: int = 2
    program: str = ""

    def tool(self, name):
        return str(self.tools / "tests" / "paper" / "tools" / name)

    def run(self, command, stdin=None, accept=(0,)):
        done = subprocess.run([str(part) for part in command], input=stdin, text=True, capture_output=True, check=False)
        if done.returncode not in accept:
            raise Failed(f"{' '.join(map(str, command))}\nended with {done.returncode}:\n" f"{done.stderr[-3000:]}")
        return done.stdout

    def json(self, command, stdin=None, accept=(0,)):
        return json.loads(self.run(command, stdin, accept))

    def render(self, scene, output, size, declare=(), options=()):
        """Linear OpenEXR unless the name says PNG."""
        scene, picture = pathlib.Path(scene), self.work / output
        picture.parent.mkdir(parents=True, exist_ok=True)
        kind = "N" if picture.suffix == ".png" else "E"
        command = povray_run.command(
            self.povray,
            scene,
            picture,
            size,
            f"+F{kind}",
            "-V",
            "-GA",
            f"+WT{self.threads}",
            *[f"Declare={name}={value}" for name, value in declare],
            *options,
            library=[scene.parent, SCENES],
        )
        # kept, so that an interrupted run continues
        key = self.key(command, povray_run.sources(scene, [SCENES, picture.parent]))
        note = picture.with_name(picture.name + ".key")
        if picture.is_file() and note.is_file() and note.read_text() == key:
            return picture
        for old in (note, picture, picture.with_name(picture.name + ".pov-state")):
            old.unlink(missing_ok=True)
        # the program reads and writes in its current folder
        povray_run.run(command, picture.parent, limit=None).succeeded()
        if not picture.is_file():
            raise Failed(f"{scene}: the program ended well but wrote no {picture}")
        note.write_text(key)
        return picture

    def key(self, command, sources):
        if not self.program:
            self.program = hashlib.sha256(self.povray.read_bytes()).hexdigest()
        found = hashlib.sha256((self.program + json.dumps(command)).encode())
        for path in sources:
            found.update(path.read_bytes())
        return found.hexdigest()

    def png(self, picture, *drawing):
        made = self.results / picture.with_suffix(".png").name
        made.parent.mkdir(parents=True, exist_ok=True)
        self.run(
            [
                "oiiotool",
                picture,
                "--ch",
                "R,G,B",
                "--colorconvert",
                "linear",
                "sRGB",
                *drawing,
                "--nosoftwareattrib",
                "-d",
                "uint8",
                "-o",
                made,
            ]
        )
        return made

    def moments(self, picture, windows):
        return self.json([self.tool("profile"), "moments", picture], stdin=json.dumps(windows))

    def oracle(self, name, case, scene, batches, samples):
        key = hashlib.sha256(json.dumps([case, batches, samples]).encode() + scene.read_bytes())
        folder = self.work / "oracle" / f"{name}-{key.hexdigest()[:16]}"
        picture = folder / "mean.exr"
        if not picture.is_file():
            frames = folder / "frames"
            if frames.is_dir():  # of an interrupted run
                shutil.rmtree(frames)
            frames.mkdir(parents=True)
            text = json.dumps({"name": name, "scene": scene.name, **case})
            (folder / "case.json").write_text(text)
            (folder / scene.name).write_bytes(scene.read_bytes())
            self.run(
                [
                    self.tools / "tests" / "tools" / "oracle",
                    "render",
                    folder / "case.json",
                    folder / "part.exr",
                    "--povray",
                    self.stock,
                    "--work",
                    frames,
                    "--batches",
                    batches,
                    "--samples",
                    samples,
                ]
            )
            shutil.rmtree(frames)
            (folder / "part.exr").rename(picture)
        return picture

    def table(self, name, header, rows):
        self.results.mkdir(parents=True, exist_ok=True)
        with (self.results / name).open("w", newline="") as out:
            writer = csv.writer(out, lineterminator="\n")
            writer.writerow(header)
            writer.writerows([f"{cell:.6g}" if isinstance(cell, float) else cell for cell in row] for row in rows)

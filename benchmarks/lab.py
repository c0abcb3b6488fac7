# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Programs, folders, kept runs and reference pictures of the benchmark."""

import dataclasses
import hashlib
import json
import pathlib
import re
import statistics
import subprocess

from tools import povray_run
from tools.povray_run import INCLUDE, Failed
from tools.repository import ROOT

SCENES = ROOT / "benchmarks" / "scenes"
PINHOLE, STOCK, TILT_LENS, ACCUMULATE = range(4)  # Form of scenes/camera.inc
GREATEST_NOISE = 0.1  # of a reference, in an MSE that is measured with it


def digest(*parts):
    made = hashlib.sha256()
    for part in parts:
        made.update(part if isinstance(part, bytes) else json.dumps(part, sort_keys=True).encode())
    return made.hexdigest()[:20]


def run_measured(command, cwd, low_priority=False):
    """Messages, CPU seconds (user and system), elapsed seconds."""
    done = povray_run.run(["nice", "-n4", *command] if low_priority else command, cwd, limit=None).succeeded()
    return done.said, done.cpu, done.seconds


@dataclasses.dataclass(frozen=True)
class Part:
    """Left upper corner, and the size of the whole."""

    left: int
    top: int
    columns: int
    rows: int


@dataclasses.dataclass(frozen=True)
class Shot:
    scene: str
    form: int
    tilted: int = 0
    size: tuple = (200, 150)
    declare: tuple = ()  # (name, value) pairs
    options: tuple = ()
    threads: int = 1
    part: Part = None  # the larger picture that this is a part of
    folder: pathlib.Path = SCENES

    def command(self, program, picture, *options):
        return povray_run.command(
            program, self.folder / f"{self.scene}.pov", picture, self.size, *self.settings(), *options, library=[SCENES, INCLUDE]
        )

    def settings(self):
        """A part has a camera of its own; but stock, whose lens turns with `direction`, renders rows and columns of the whole."""
        (width, height), part = self.size, self.part
        settings, options = (("Form", self.form), ("Tilted", self.tilted), *self.declare), self.options
        if part and self.form == STOCK:
            options = (*povray_run.part(part.left, part.top, width, height), *options)
            width, height = part.columns, part.rows
        elif part:
            settings += (("Columns", part.columns), ("Rows", part.rows), ("Left", part.left), ("Top", part.top))
        return [
            f"+W{width}",
            f"+H{height}",
            "-D",
            "-P",
            "-C",
            "-A",
            f"+WT{self.threads}",
            *[f"Declare={name}={value}" for name, value in settings],
            *options,
        ]

    def place(self):
        return ["--at", f"{self.part.left},{self.part.top}"] if self.part and self.form == STOCK else []

    def independent(self, number):
        """The inner part of a larger picture has other samples, by number from 1 on."""
        border, (width, height) = 8 * number, self.size
        return dataclasses.replace(
            self,
            size=(width + 2 * border, height + 2 * border),
            declare=(*self.declare, ("Batch", border)),
            options=(*self.options, *povray_run.part(border, border, width, height)),
        )

    def sources(self):
        found = povray_run.sources(self.folder / f"{self.scene}.pov", [SCENES, INCLUDE])
        return b"".join(path.read_bytes() for path in sorted(found, key=lambda path: path.name))


@dataclasses.dataclass
class Lab:
    ours: pathlib.Path
    stock: pathlib.Path
    tools: pathlib.Path
    work: pathlib.Path
    quick: bool = False

    def __post_init__(self):
        self.work.mkdir(parents=True, exist_ok=True)
        self.hashes = {path: self.hash_of(path) for path in (self.ours, self.stock)}
        self.journal = self.work / "runs.jsonl"
        self.runs = {}
        if self.journal.is_file():
            for line in self.journal.read_text().splitlines():
                record = json.loads(line)
                self.runs[record["key"], record["repetition"]] = record

    @staticmethod
    def hash_of(program):
        return digest(program.read_bytes())

    def say(self, text):
        print(text, flush=True)

    def tool(self, name, *arguments):
        done = subprocess.run([str(self.tools / name), *map(str, arguments)], capture_output=True, text=True, check=False)
        if done.returncode != 0:
            raise Failed(f"{name} {' '.join(map(str, arguments[:4]))} ...\nended with {done.returncode}:\n" f"{done.stderr[-2000:]}")
        return [json.loads(line) for line in done.stdout.splitlines()]

    def render(self, program, shot, picture, low_priority=False):
        """Linear 16-bit PNG, or OpenEXR for .exr; returns messages, CPU and elapsed seconds."""
        picture.parent.mkdir(parents=True, exist_ok=True)
        picture.unlink(missing_ok=True)
        command = shot.command(
            program, picture, *self.gathered_light(shot), *(["+FE"] if picture.suffix == ".exr" else ["+FN16", "File_Gamma=1.0"])
        )
        result = run_measured(command, picture.parent, low_priority)
        if not picture.is_file():
            raise Failed(f"{shot}: the program ended well but wrote no {picture}")
        return result

    def gathered_light(self, shot):
        """Radiosity from a file, which stock makes first; none for most scenes."""
        if b"Gather" not in shot.sources():
            return []
        wide = dataclasses.replace(shot, form=PINHOLE, tilted=0, size=(300, 225), threads=1, options=(), declare=(("Gather", 1),))
        path = self.work / "references" / f"{shot.scene}-{digest(wide.settings(), shot.sources())}.rca"
        if not path.is_file():
            path.parent.mkdir(parents=True, exist_ok=True)
            run_measured(wide.command(self.stock, f"{path}.png", "+FN", "+RFO", f"+RF{path}.part"), path.parent)
            path.with_name(path.name + ".png").unlink()
            path.with_name(path.name + ".part").rename(path)
        return ["+RFI", f"+RF{path}", "Radiosity_Vain_Pretrace=off"]

    def reference(self, shot, batches, samples, unclipped=False):
        """The mean of independent tilt_lens pictures with the same number of samples in each pixel, made once.

        Clipped at white, unless lamps matter in full."""
        if shot.form == PINHOLE:  # sharp as a pinhole
            shot = dataclasses.replace(shot, form=TILT_LENS, declare=(("Blur", 1e-7), *shot.declare))
        samples = samples // 2 if self.quick else samples
        kind, options = ("exr", ["--unclipped"]) if unclipped else ("png", [])
        name = digest(shot.settings(), shot.sources(), batches, samples, *options)
        path = self.work / "references" / f"{shot.scene}-{name}.exr"
        if path.is_file():
            return path
        self.say(f"  reference of {shot.scene}{' tilted' if shot.tilted else ''}: " f"{batches} times {samples} samples a pixel")
        width, height = shot.size
        pictures = []
        even = dataclasses.replace(shot, threads=2, declare=(*shot.declare, ("Min", samples), ("Max", samples), ("Variance", 0)))
        for batch in range(1, batches + 1):
            pictures.append(self.work / "references" / f"{path.stem}-{batch}.{kind}")
            self.render(self.ours, even.independent(batch), pictures[-1], low_priority=True)
        unfinished = path.with_suffix(".part.exr")
        self.tool("noise", "reference", unfinished, *pictures, "--size", width, height, *options)
        unfinished.rename(path)
        for picture in pictures:
            picture.unlink()
        return path

    def run(self, binary, shot, reference=None, repetition=0, **about):
        """From the journal if there. `about` goes into the record."""
        if binary not in self.hashes:
            self.hashes[binary] = self.hash_of(binary)
        key = digest(self.hashes[binary], shot.settings(), shot.sources(), str(reference.name if reference else ""))
        record = self.runs.get((key, repetition))
        if record is None:
            picture = self.work / "pictures" / f"{key}.png"
            messages, cpu, seconds = self.render(binary, shot, picture)
            record = {
                "key": key,
                "repetition": repetition,
                "cpu": round(cpu, 4),
                "seconds": round(seconds, 4),
                "rays": sum(cpu_of_rays(messages)),
                **samples_spent(messages),
            }
            if reference and repetition == 0:
                (figures,) = self.tool("noise", "errors", reference, picture, *shot.place())
                record.update({name: value for name, value in figures.items() if name != "picture"})
            picture.unlink()
            self.keep(record)
        return {**record, **about}

    def interleaved(self, programs_and_shots, repetitions, reference=None):
        rounds = [
            [self.run(binary, shot, reference, repetition) for binary, shot in programs_and_shots] for repetition in range(repetitions)
        ]
        return [
            {**records[0], **{name: statistics.median(record[name] for record in records) for name in ("cpu", "seconds", "rays")}}
            for records in zip(*rounds)
        ]

    def keep(self, record):
        self.runs[record["key"], record["repetition"]] = record
        with self.journal.open("a") as journal:
            journal.write(json.dumps(record) + "\n")

    def start_up(self, program, shot):
        return statistics.median(self.run(program, self.one_pixel(shot), repetition=i)["cpu"] for i in range(3))

    @staticmethod
    def one_pixel(shot):
        """The second, because the program reads +EC1 as 100 %."""
        return dataclasses.replace(shot, options=(*shot.options, "+SC2", "+EC2", "+SR2", "+ER2"))


def cpu_of_rays(messages):
    found = re.findall(r"^  Trace Time:.*\n\s+using 1 thread\(s\) with ([0-9.]+) CPU-seconds", messages, re.M)
    return list(map(float, found))


def standard_error(said):
    """Estimated root mean square error of several pictures by their messages, relative above white."""
    found = (re.search(r"^  Standard error\.+([\d.e-]+) of white", messages, re.M) for messages in said)
    return statistics.fmean(float(one[1]) ** 2 for one in found) ** 0.5


def samples_spent(messages):
    found = re.search(r"Samples per pixel\D+([\d.]+)\D+99\s?%\D*([\d.]+)\D+([\d.]+)", messages)
    return {} if not found else dict(zip(("samples", "samples_99", "samples_most"), map(float, found.groups())))

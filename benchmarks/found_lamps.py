# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Lamps far out of focus: in mirrors and textures, and unknown to the sampler in patterns, glass and highlights. Default settings against
fixed sampling with as many rays. Dark discs hardly change the error, hence the share of the lamps' light kept, and of dark disc pixels."""

import dataclasses
import math
import statistics

from benchmarks.lab import SCENES as SCENE_FOLDER
from benchmarks.lab import GREATEST_NOISE, TILT_LENS, Shot, digest, samples_spent, standard_error

FOLDER = SCENE_FOLDER / "found_lamps"
SIZE, QUICK_SIZE = (320, 240), (160, 120)
SEEDS = (1, 2, 3)
FIRST_SEED = 101  # of the references; no picture shares them
BATCHES = 4
LEAST_SAMPLES, MOST_SAMPLES, QUICK_MOST = 256, 16384, 1024  # of each pixel of a reference
VARIANCE = 1e-4


@dataclasses.dataclass(frozen=True)
class Scene:
    name: str
    title: str
    radii: tuple = (None,)  # of the lamps, where the scene knows them
    quick: tuple = ()  # radii of the short form, if not all: the smaller, the finer the reference

    def shots(self, quick):
        return [
            (
                radius,
                Shot(
                    self.name,
                    TILT_LENS,
                    size=QUICK_SIZE if quick else SIZE,
                    folder=FOLDER,
                    threads=2,
                    declare=(("Radius", radius),) if radius else (),
                ),
            )
            for radius in quick and self.quick or self.radii
        ]


SCENES = [
    Scene("mirror", "lamps in a mirror", (0.08, 0.16), (0.16,)),
    Scene("two_mirrors", "lamps in two mirrors", (0.08, 0.16), (0.16,)),
    Scene("sky", "suns of a sky's pigment", (0.08, 0.16), (0.16,)),
    Scene("textures", "lamps by a `texture_map`", (0.04, 0.08)),
    Scene("pigments", "lamps by colours of a pattern", (0.04, 0.08)),
    Scene("image", "windows of an `image_map`"),
    Scene("pane", "lamps behind a pane at an angle", (0.08, 0.16)),
    Scene("water", "lamps under water"),
    Scene("wet", "highlights on a wet road"),
    Scene("balls", "highlights on small balls"),
    Scene("stars", "300 stars"),
    Scene("starfield", "stars of a sky's pigment"),
]
NAMES = [scene.name for scene in SCENES]


def declared(shot, **values):
    return dataclasses.replace(shot, declare=(*shot.declare, *values.items()))


class Reference:
    def __init__(self, lab, shot):
        self.lab, self.shot = lab, declared(shot, Known=1)

    def of(self, samples):
        folder = self.lab.work / "references"
        stem = f"{self.shot.scene}-{digest(self.shot.settings(), self.shot.sources(), BATCHES, samples)}"
        path = folder / f"{stem}.exr"
        if path.is_file():
            return path
        batches = [folder / f"{stem}-{number}.exr" for number in range(BATCHES)]
        for number, batch in enumerate(batches):
            self.lab.render(
                self.lab.ours, declared(self.shot, Samples=samples, Variance=0, Seed=FIRST_SEED + number), batch, low_priority=True
            )
        unfinished = path.with_suffix(".part.exr")
        self.lab.tool("noise", "reference", unfinished, *batches, "--unclipped", "--size", *self.shot.size)
        unfinished.rename(path)
        for batch in batches:
            batch.unlink()
        return path

    def fine_enough(self, *sets):
        """A reference whose error is far below that of some pictures, and these."""
        samples, most = LEAST_SAMPLES, QUICK_MOST if self.lab.quick else MOST_SAMPLES
        while True:
            path = self.of(samples)
            errors = [mean(self.lab.tool("noise", "errors", path, *pictures)) for pictures in sets]
            least = max(1e-12, min(error["mse"] for error in errors))
            finer = errors[0]["reference_mse"] / (GREATEST_NOISE * least)
            if finer <= 1.0 or samples >= most:
                return path, errors
            # noise may fall more steeply than samples grow
            samples = min(most, samples * 2 ** max(1, min(3, round(math.log2(finer)))))


def mean(records):
    return {
        name: sum(record[name] for record in records) / len(records)
        for name, value in records[0].items()
        if isinstance(value, (int, float))
    }


def pictures(lab, shot, folder, **values):
    made = [folder / f"{values.get('Samples', 'default')}-{seed}.exr" for seed in SEEDS]
    messages = [
        lab.render(lab.ours, dataclasses.replace(declared(shot, **values, Seed=seed), options=("+N",)), picture)[0]
        for seed, picture in zip(SEEDS, made)
    ]
    return made, messages


def compared(lab, shot):
    folder = lab.work / "found_lamps" / shot.scene
    default, said = pictures(lab, shot, folder)
    samples = statistics.fmean(samples_spent(text)["samples"] for text in said)
    fixed = 4 * max(1, round(samples / 4))  # the sequence's strata are of four: other numbers have far more error
    uniform, _ = pictures(lab, shot, folder, Samples=fixed)
    reference, (error, uniform_error) = Reference(lab, shot).fine_enough(default, uniform)
    without = Reference(lab, declared(shot, Lamps=0)).of(LEAST_SAMPLES)
    kept, uniform_kept = (mean(lab.tool("noise", "lamps", reference, without, *made)) for made in (default, uniform))
    (claims,) = lab.tool("noise", "claims", reference, *default, "--variance", VARIANCE, "--more-than", 4)
    for made in default + uniform:
        made.unlink()
        made.with_suffix(".layers.exr").unlink()
    return {
        "samples": samples,
        "fixed": fixed,
        "mse": error["mse"],
        "fixed_mse": uniform_error["mse"],
        "reference_mse": error["reference_mse"],
        "kept": kept["kept"],
        "fixed_kept": uniform_kept["kept"],
        "dark": kept["dark"],
        "fixed_dark": uniform_kept["dark"],
        "disc_pixels": kept["disc_pixels"],
        "estimated": standard_error(said),
        "true": claims["true"],
    }


def work(row):
    return row["mse"] * row["samples"] / (row["fixed_mse"] * row["fixed"])


def measure(lab, names=NAMES):
    rows = []
    for scene in (scene for scene in SCENES if scene.name in names):
        for radius, shot in scene.shots(lab.quick):
            key = digest("found lamps by the summary", lab.hashes[lab.ours], shot.settings(), shot.sources(), SEEDS, BATCHES)
            record = lab.runs.get((key, 0))
            if record is None:
                record = {"key": key, "repetition": 0, **compared(lab, shot)}
                lab.keep(record)
            row = {"scene": scene.name, "radius": radius, "size": list(shot.size)}
            row |= {name: float(f"{value:.4g}") for name, value in record.items() if name not in ("key", "repetition")}
            lab.say(
                f"{scene.name}{f' {radius}' if radius else ''}: work {work(row):.2f}, {100*row['kept']:.1f} % of the light,"
                f" {100*row['dark']:.2f} % dark"
            )
            rows.append(row)
    return rows

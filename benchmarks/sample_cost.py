# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The cost of a sample with all its rays, by callgrind's instructions; with a program to compare, also by CPU seconds."""

import dataclasses
import statistics

from benchmarks import gallery, instructions, suite
from benchmarks.lab import TILT_LENS, Shot

SAMPLES = 8
EVEN = suite.limits(SAMPLES, SAMPLES, 0)
SIZE, TIMED_SIZE = (96, 54), (384, 216)
REPETITIONS = 5
OF_GALLERY = {"folder": gallery.GALLERY, "size": SIZE, "declare": (("Samples", SAMPLES),)}
SHOTS = [
    Shot("miniature_town", TILT_LENS, **OF_GALLERY),
    Shot("miniature_harbour", TILT_LENS, **OF_GALLERY),
    Shot("forest_reverse_tilt", TILT_LENS, **OF_GALLERY),
    Shot("foliage", TILT_LENS, size=SIZE, declare=EVEN),
    Shot("glass", TILT_LENS, size=SIZE, declare=EVEN),
    Shot("shadows", TILT_LENS, size=SIZE, declare=EVEN),
]
ALL, INTERSECTIONS = "tilt_lens::TileSampler::Run(*", "pov::SceneHierarchy::Intersect(*"


def seconds_over_before(lab, shot, before):
    larger = dataclasses.replace(shot, size=TIMED_SIZE)
    pairs = [[lab.run(program, larger, repetition=i)["rays"] for program in (lab.ours, before)] for i in range(REPETITIONS)]
    return statistics.median(ours / theirs for ours, theirs in pairs)


def measure(lab, before=None, count=instructions.count, seconds=seconds_over_before):
    lab.say("instructions of a sample with all its rays")
    rows = []
    for shot in SHOTS:
        samples = SAMPLES * shot.size[0] * shot.size[1]
        row = {
            "scene": shot.scene,
            "instructions": count(lab, lab.ours, shot, within=ALL) / samples,
            "intersections": count(lab, lab.ours, shot, within=INTERSECTIONS) / samples,
        }
        if before:
            row["before"] = count(lab, before, shot, within=ALL) / samples
            row["seconds"] = seconds(lab, shot, before)
        rows.append(row)
    return rows

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""A lens of glass, wide open, where rims block rays, and stopped down, beside an ideal one: callgrind's instructions in the sampling of
tiles, without tracing."""

from benchmarks import instructions, suite
from benchmarks.camera_share import ALL, RAYS
from benchmarks.lab import TILT_LENS, Shot

SCENES = ("wall", "town")
LENSES = {"ideal": 0, "glass, f/2.02": 2.02, "glass, f/8": 8}
SAMPLES = 16
SIZE = instructions.SIZE


def measure(lab, count=instructions.count):
    lab.say("cost of a lens of glass")
    rows, rays = [], SAMPLES * SIZE[0] * SIZE[1]
    for scene in SCENES[:1] if lab.quick else SCENES:
        for lens, stop in LENSES.items():
            shot = Shot(scene, TILT_LENS, size=SIZE, declare=(*suite.limits(SAMPLES, SAMPLES, 0), ("Glass", stop)))
            whole, traced = (count(lab, lab.ours, shot, within=function) for function in (ALL, RAYS))
            rows.append(
                {"scene": scene, "lens": lens, "instructions": whole / rays, "camera": (whole - traced) / rays, "share": 1 - traced / whole}
            )
    return rows

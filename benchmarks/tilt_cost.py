# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""scenes/wall.pov has the same blur with and without tilt. CPU times vary by more than the effect; instructions do not."""

import dataclasses
import shutil

from benchmarks import instructions, suite
from benchmarks.lab import TILT_LENS, Shot

SETTINGS = {"64 samples everywhere": suite.limits(64, 64, 0), "variance 1/5000": suite.limits(8, 4096, 2e-4)}


def measure(lab):
    lab.say("tilted and untilted at equal blur")
    shots = [Shot("wall", TILT_LENS, tilted, declare=declare) for declare in SETTINGS.values() for tilted in (0, 1)]
    runs = lab.interleaved([(lab.ours, shot) for shot in shots], 3 if lab.quick else 25)
    counts = (
        [instructions.count(lab, lab.ours, dataclasses.replace(shot, size=instructions.SIZE), 3) for shot in shots]
        if shutil.which("valgrind") and not lab.quick
        else None
    )
    return [
        {
            "setting": setting,
            "untilted": runs[2 * i]["cpu"],
            "tilted": runs[2 * i + 1]["cpu"],
            "times": runs[2 * i + 1]["cpu"] / runs[2 * i]["cpu"],
            "instructions": counts and counts[2 * i + 1] / counts[2 * i],
        }
        for i, setting in enumerate(SETTINGS)
    ]

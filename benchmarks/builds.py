# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The program of cmake/build-fast (link-time and profile-guided optimisation) against the usual one, with the same rays."""

from benchmarks import suite
from benchmarks.lab import TILT_LENS

EVEN = suite.limits(64, 64, 0)


def measure(lab, scenes, fast):
    lab.hashes[fast] = lab.hash_of(fast)
    rows = []
    for scene in scenes:
        lab.say(f"{scene.name}: the usual program and the fast one")
        reference = lab.reference(scene.shot(TILT_LENS), *scene.reference)
        shot = scene.shot(TILT_LENS, declare=EVEN)
        usual, other = lab.interleaved([(lab.ours, shot), (fast, shot)], 3 if lab.quick else 7, reference)
        rows.append(
            {
                "scene": scene.name,
                "usual": usual["cpu"],
                "fast": other["cpu"],
                "times": other["cpu"] / usual["cpu"],
                "same": usual["mse"] == other["mse"],
            }
        )
    return rows

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Against the build without speedups (-DSPEEDUPS=OFF): callgrind's instructions, and the median ratio of CPU seconds of successive runs."""

import statistics

from benchmarks import instructions
from benchmarks.lab import Failed
from benchmarks.sample_cost import SHOTS

PAIRS = 5
QUICK = ("miniature_town", "glass")


def cpu_ratio(lab, shot, without):
    """Both must take as many rays of the lens."""
    pairs = [[lab.run(program, shot, repetition=i) for program in (lab.ours, without)] for i in range(PAIRS)]
    if any(ours["samples"] != theirs["samples"] for ours, theirs in pairs):
        raise Failed(f"{shot}: the programs with and without speedups took different numbers of samples")
    return statistics.median(theirs["cpu"] / ours["cpu"] for ours, theirs in pairs)


def measure(lab, without, count=instructions.count, ratio=cpu_ratio):
    lab.say("this program with the speedups and without them")
    shots = [shot for shot in SHOTS if not lab.quick or shot.scene in QUICK]
    return [
        {
            "scene": shot.scene,
            "with": count(lab, lab.ours, shot),
            "without": count(lab, without, shot),
            "seconds": ratio(lab, shot, without),
        }
        for shot in shots
    ]

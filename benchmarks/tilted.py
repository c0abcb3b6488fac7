# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""tilt_lens against the accumulation buffer, tilted, at the untilted errors."""

import math

from benchmarks import accumulation, post, suite
from benchmarks.front import pareto, seconds_for
from benchmarks.lab import TILT_LENS
from benchmarks.versus_stock import repetitions, start_up


def ours(lab, scene, reference, finest):
    """From the roughest setting to one better than the finest error."""
    records = []
    for chain in suite.ours_chains(scene, 1, quick=True):
        for setting, shot in chain:
            first = lab.run(lab.ours, shot, reference)
            (run,) = lab.interleaved([(lab.ours, shot)], repetitions(first), reference)
            records.append(
                {
                    **run,
                    "cpu": scene.seconds(run),
                    "program": "tilt_lens",
                    "scene": scene.name,
                    "tilted": 1,
                    "setting": setting,
                    "start_up": start_up(lab, lab.ours, scene, scene.shot(TILT_LENS, 1)),
                    "rmse": math.sqrt(run["mse"]),
                }
            )
            if records[-1]["rmse"] < finest:
                break
    return records


def measure(lab, scene, errors):
    lab.say(f"{scene.name} tilted: accumulation buffer, blur after the fact, tilt_lens")
    reference = lab.reference(scene.shot(TILT_LENS, 1), *scene.reference)
    return [
        *accumulation.measure(lab, scene, 1),
        *([] if scene.part else post.measure(lab, scene, 1)),
        *ours(lab, scene, reference, min(errors.values())),
    ]


def compare(records, errors):
    """A lower bound where all frames do not reach an error."""
    fronts = {
        program: [(record["cpu"], record["rmse"]) for record in records if record["program"] == program]
        for program in ("accumulation", "tilt_lens")
    }
    noise = next(record["reference_mse"] for record in records if record["program"] == "tilt_lens")
    lines = []
    for target, error in sorted(errors.items()):
        took, other = (seconds_for(fronts[program], error) for program in ("tilt_lens", "accumulation"))
        at_least = other is None
        if at_least:
            other = pareto(fronts["accumulation"])[-1][0]
        lines.append(
            {
                "target": target,
                "rmse": error,
                "noise": noise / error**2,
                "accumulation": other,
                "at_least": at_least,
                "tilt_lens": took,
                "ratio": other / took if took else None,
            }
        )
    return lines

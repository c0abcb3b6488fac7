# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""What the reconstruction (`denoise`) brings at equal error, and by how much it falsifies a picture."""

import dataclasses
import math

import suite
from front import seconds_for
from lab import TILT_LENS
from versus_stock import repetitions

PICTURES = 8            # independent ones whose mean shows the bias
ROUGH = suite.limits(8, 16384, 1e-3)


def setting(shot, denoise):
    return dataclasses.replace(shot, declare=(*shot.declare, ("Denoise", denoise)))


def measure(lab, scene, errors):
    """Records with and without, in turn, from the roughest setting until both are better than all errors."""
    lab.say(f"{scene.name}: with and without reconstruction")
    reference = lab.reference(scene.shot(TILT_LENS), *scene.reference)
    records = []
    for chain in suite.ours_chains(scene, 0, lab.quick):
        for name, shot in chain:
            pair = [(lab.ours, setting(shot, denoise)) for denoise in (1, 0)]
            first = lab.interleaved(pair, 1, reference)
            runs = lab.interleaved(pair, repetitions(first[0]["cpu"], lab.quick), reference)
            records += [{**run, "program": f"denoise {denoise}", "scene": scene.name, "setting": name,
                         "rmse": math.sqrt(run["mse"])} for run, denoise in zip(runs, ("on", "off"))]
            if all(record["rmse"] < min(errors.values()) for record in records[-2:]):
                break
    return records


def compare(records, errors):
    """One line an error: seconds without over seconds with."""
    fronts = {program: [(record["cpu"], record["rmse"]) for record in records if record["program"] == program]
              for program in ("denoise on", "denoise off")}
    lines = []
    for target, error in sorted(errors.items()):
        on, off = (seconds_for(fronts[program], error) for program in fronts)
        lines.append({"target": target, "rmse": error, "on": on, "off": off, "ratio": off/on if on and off else None})
    return lines


def bias(lab, scene):
    """What independent pictures have in common besides the truth. With a squared bias b and a variance v of each,
    the error of the mean of k pictures is b + v/k, that of one b + v."""
    reference = lab.reference(scene.shot(TILT_LENS), *scene.reference)
    pictures = [lab.work / "bias" / f"{scene.name}-{number}.png" for number in range(1, PICTURES + 1)]
    for number, picture in enumerate(pictures, 1):
        lab.render(lab.ours, scene.shot(TILT_LENS, declare=ROUGH).independent(number), picture)
    of_mean, = lab.tool("noise", "prefixes", reference, *pictures, "--counts", PICTURES)
    of_each = lab.tool("noise", "errors", reference, *pictures)
    one = sum(figures["mse"] for figures in of_each)/PICTURES
    squared = max(0.0, (PICTURES*of_mean["mse"] - one)/(PICTURES - 1))
    return {"scene": scene.name, "rmse": math.sqrt(one), "bias": math.sqrt(squared)}

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""What the reconstruction (`denoise`) brings at equal error, and by how much it falsifies a picture."""

import dataclasses
import math

import suite
from front import error_after, pareto, seconds_for
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
    """One line an error: the CPU time for it without, and RMSE without over RMSE with after that time; where one of the
    two takes longer for its roughest picture, after that."""
    points = {program: [(record["cpu"], record["rmse"]) for record in records if record["program"] == program]
              for program in ("denoise on", "denoise off")}
    fastest = max(pareto(settings)[0][0] for settings in points.values())
    lines = []
    for target, error in sorted(errors.items()):
        seconds = seconds_for(points["denoise off"], error)
        line = {"target": target, "rmse": error, "seconds": None, "on": None, "off": None, "ratio": None}
        if seconds:
            seconds = max(seconds, fastest)
            on, off = (error_after(points[program], seconds) for program in ("denoise on", "denoise off"))
            line.update(seconds=seconds, on=on, off=off, ratio=off/on)
        lines.append(line)
    return lines


def bias(lab, scene):
    """What independent pictures have in common besides the truth. With a squared bias b and a variance v of each,
    the error of the mean of k pictures is b + v/k, that of one b + v."""
    reference = lab.reference(scene.shot(TILT_LENS), *scene.reference)
    figures = {"scene": scene.name}
    for program, denoise in (("on", 1), ("off", 0)):
        pictures = [lab.work / "bias" / f"{scene.name}-{program}-{number}.png" for number in range(1, PICTURES + 1)]
        for number, picture in enumerate(pictures, 1):
            rough = setting(scene.shot(TILT_LENS, declare=ROUGH), denoise)
            lab.render(lab.ours, rough.independent(number), picture)
        of_mean, = lab.tool("noise", "prefixes", reference, *pictures, "--counts", PICTURES)
        of_each = lab.tool("noise", "errors", reference, *pictures)
        one = sum(picture["mse"] for picture in of_each)/PICTURES
        squared = max(0.0, (PICTURES*of_mean["mse"] - one)/(PICTURES - 1))
        figures.update({f"rmse_{program}": math.sqrt(one), f"bias_{program}": math.sqrt(squared)})
    return figures

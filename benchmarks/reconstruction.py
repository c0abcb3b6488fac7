# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""What the reconstruction (`denoise`) brings at equal error, and by how much it falsifies a picture."""

import dataclasses
import math

import suite
from front import error_after, seconds_for
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
    on, off = ([(record["cpu"], record["rmse"]) for record in records if record["program"] == program]
               for program in ("denoise on", "denoise off"))
    fastest = max(min(settings)[0] for settings in (on, off))
    lines = []
    for target, error in sorted(errors.items()):
        seconds = seconds_for(off, error)
        if seconds:
            seconds = max(seconds, fastest)
        ratio = error_after(off, seconds)/error_after(on, seconds) if seconds else None
        lines.append({"target": target, "seconds": seconds, "ratio": ratio})
    return lines


def error_and_bias(lab, scene, denoise):
    """RMSE of one picture, and what independent pictures have in common besides the truth. With a squared bias b and a
    variance v of each, the error of the mean of k pictures is b + v/k, that of one b + v."""
    reference = lab.reference(scene.shot(TILT_LENS), *scene.reference)
    rough = setting(scene.shot(TILT_LENS, declare=ROUGH), denoise)
    pictures = [lab.work / "bias" / f"{scene.name}-{denoise}-{number}.png" for number in range(1, PICTURES + 1)]
    for number, picture in enumerate(pictures, 1):
        lab.render(lab.ours, rough.independent(number), picture)
    of_mean, = lab.tool("noise", "prefixes", reference, *pictures, "--counts", PICTURES)
    of_each = lab.tool("noise", "errors", reference, *pictures)
    one = sum(figures["mse"] for figures in of_each)/PICTURES
    squared = max(0.0, (PICTURES*of_mean["mse"] - one)/(PICTURES - 1))
    return math.sqrt(one), math.sqrt(squared)


def bias(lab, scene):
    """Errors and biases with and without."""
    (rmse_on, bias_on), (rmse_off, bias_off) = (error_and_bias(lab, scene, denoise) for denoise in (1, 0))
    return {"scene": scene.name, "rmse_on": rmse_on, "bias_on": bias_on, "rmse_off": rmse_off, "bias_off": bias_off}

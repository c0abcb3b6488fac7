# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Errors with and without `denoise` after the same work, and its bias. Instructions and several pictures show differences of 1 %."""

import math

from benchmarks import instructions, suite
from benchmarks.front import error_after, pareto
from benchmarks.lab import PINHOLE, TILT_LENS, digest

SIZE = (100, 75)  # callgrind takes fifty times as long as the program
VARIANCES = (1e-2, 3e-3, 1e-3, 3e-4, 1e-4)
PICTURES = 8  # their mean shows the bias


def setting(scene, variance, denoise):
    return scene.shot(TILT_LENS, size=SIZE, declare=(*suite.limits(8, 16384, variance), ("Denoise", denoise)))


def error_and_bias(lab, scene, shot):
    """RMSE, and the shared bias: with squared bias b and variance v, the mean of k pictures has the mean square error b + v/k."""
    reference = lab.reference(scene.shot(TILT_LENS, size=SIZE), *scene.reference)
    key = digest("bias beside the reference", lab.hashes[lab.ours], shot.settings(), shot.sources(), reference.name, PICTURES)
    record = lab.runs.get((key, 0))
    if record is None:
        pictures = [lab.work / "bias" / f"{scene.name}-{number}.png" for number in range(1, PICTURES + 1)]
        for number, picture in enumerate(pictures, scene.reference[0] + 1):
            lab.render(lab.ours, shot.independent(number), picture)
        (of_mean,) = lab.tool("noise", "prefixes", reference, *pictures, "--counts", PICTURES)
        of_each = lab.tool("noise", "errors", reference, *pictures)
        one = sum(figures["mse"] for figures in of_each) / PICTURES
        squared = max(0.0, (PICTURES * of_mean["mse"] - one) / (PICTURES - 1))
        record = {"key": key, "repetition": 0, "rmse": math.sqrt(one), "bias": math.sqrt(squared)}
        lab.keep(record)
    return record["rmse"], record["bias"]


def measure(lab, scene, count=instructions.count):
    lab.say(f"{scene.name}: with and without reconstruction")
    # by a pinhole: with a lens, one pixel needs its neighbours' samples
    start = count(lab, lab.ours, lab.one_pixel(scene.shot(PINHOLE, size=SIZE)))
    rows = []
    for variance in VARIANCES[:3] if lab.quick else VARIANCES:
        for denoise in (0, 1):
            shot = setting(scene, variance, denoise)
            work = count(lab, lab.ours, shot) - start
            rmse, bias = error_and_bias(lab, scene, shot)
            rows.append({"scene": scene.name, "variance": variance, "denoise": denoise, "instructions": work, "rmse": rmse, "bias": bias})
    return rows


def compare(rows):
    """RMSE without over with reconstruction after equal work; without a common range, after the most of one and the least of the other."""
    off, on = ([(row["instructions"], row["rmse"]) for row in rows if row["denoise"] == denoise] for denoise in (0, 1))
    least = max(pareto(points)[0][0] for points in (off, on))
    most = min(pareto(points)[-1][0] for points in (off, on))
    ratios = {}
    for row in rows:
        if not row["denoise"]:
            work = max(min(row["instructions"], most), least)
            ratios[row["variance"]] = error_after(off, work) / error_after(on, work)
    return ratios

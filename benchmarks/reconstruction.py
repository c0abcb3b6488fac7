# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The errors with and without reconstruction (`denoise`) after the same work, and the bias of the reconstruction. Work is
the number of instructions (callgrind), which does not vary, and an error is that of several independent pictures, so
that differences of 1 % show."""

import math

from benchmarks import instructions, suite
from benchmarks.front import error_after, pareto
from benchmarks.lab import PINHOLE, TILT_LENS, digest

SIZE = (100, 75)        # callgrind takes fifty times as long as the program
VARIANCES = (1e-2, 3e-3, 1e-3, 3e-4, 1e-4)
PICTURES = 8            # independent pictures, whose mean shows the bias


def setting(scene, variance, denoise):
    return scene.shot(TILT_LENS, size=SIZE, declare=(*suite.limits(8, 16384, variance), ("Denoise", denoise)))


def error_and_bias(lab, scene, shot):
    """RMSE of one picture, and the bias that all independent pictures share. With a squared bias b and a variance v of each
    picture, the mean square error of the mean of k pictures is b + v/k, and that of one picture b + v."""
    reference = lab.reference(scene.shot(TILT_LENS, size=SIZE), *scene.reference)
    key = digest("bias beside the reference", lab.hashes[lab.ours], shot.settings(), shot.sources(), reference.name, PICTURES)
    record = lab.runs.get((key, 0))
    if record is None:
        pictures = [lab.work / "bias" / f"{scene.name}-{number}.png" for number in range(1, PICTURES + 1)]
        for number, picture in enumerate(pictures, scene.reference[0] + 1):     # independent of the reference
            lab.render(lab.ours, shot.independent(number), picture)
        of_mean, = lab.tool("noise", "prefixes", reference, *pictures, "--counts", PICTURES)
        of_each = lab.tool("noise", "errors", reference, *pictures)
        one = sum(figures["mse"] for figures in of_each)/PICTURES
        squared = max(0.0, (PICTURES*of_mean["mse"] - one)/(PICTURES - 1))
        record = {"key": key, "repetition": 0, "rmse": math.sqrt(one), "bias": math.sqrt(squared)}
        lab.keep(record)
    return record["rmse"], record["bias"]


def measure(lab, scene, count=instructions.count):
    """A row for each variance, without and with reconstruction. The work does not include start and parsing, because the
    pictures are small."""
    lab.say(f"{scene.name}: with and without reconstruction")
    # of a pinhole: with a lens, one pixel needs the samples of its neighbours, too, and more of them with `denoise on`
    start = count(lab, lab.ours, lab.one_pixel(scene.shot(PINHOLE, size=SIZE)))
    rows = []
    for variance in VARIANCES[:3] if lab.quick else VARIANCES:
        for denoise in (0, 1):
            shot = setting(scene, variance, denoise)
            work = count(lab, lab.ours, shot) - start
            rmse, bias = error_and_bias(lab, scene, shot)
            rows.append({"scene": scene.name, "variance": variance, "denoise": denoise, "instructions": work,
                         "rmse": rmse, "bias": bias})
    return rows


def compare(rows):
    """For each variance: RMSE without over RMSE with reconstruction, after the work that is needed without, limited to the
    range of work that both settings cover; if there is none, what one reaches at most and the other at the least."""
    off, on = ([(row["instructions"], row["rmse"]) for row in rows if row["denoise"] == denoise] for denoise in (0, 1))
    least = max(pareto(points)[0][0] for points in (off, on))
    most = min(pareto(points)[-1][0] for points in (off, on))
    ratios = {}
    for row in rows:
        if not row["denoise"]:
            work = max(min(row["instructions"], most), least)
            ratios[row["variance"]] = error_after(off, work)/error_after(on, work)
    return ratios

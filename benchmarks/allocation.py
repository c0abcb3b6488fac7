# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The adaptive sampler's error over that of uniform sampling with as many rays, and over that of perfect knowledge.

Perfect knowledge follows from uniform pictures with 2, 4, 8, ... samples: each group of 8 by 8 pixels takes the number n that makes its
squared error plus lambda n least. Half of the pictures choose the numbers and the others judge them."""

from benchmarks import gallery, suite
from benchmarks.front import error_after
from benchmarks.lab import TILT_LENS, Part, digest, samples_spent

LARGE, SMALL = (1000, 750), (200, 150)
STRIP, QUICK_PART = (64, 376), (48, 48)  # rendered pixels; a strip has all distances in it
SAMPLES = (2, 4, 8, 16, 32, 64, 128)
VARIANCES = (3e-3, 1e-3, 3e-4, 1e-4, 3e-5)
QUICK_SAMPLES, QUICK_VARIANCES = SAMPLES[:5], VARIANCES[1:3]
QUICK_SCENES = ("checks", "foliage", "town")
PICTURES = 4  # half of them to choose by
GROUP = 8
MOST = 1024
REFERENCE = (2, 2048)  # pictures, samples a pixel of each
LAMBDAS = [10 ** (-exponent / 6) for exponent in range(12, 61)]  # squared error saved by a sample


def middle(whole, size):
    size = tuple(map(min, size, whole))
    return size, Part((whole[0] - size[0]) // 2, (whole[1] - size[1]) // 2, *whole)


def squares(lab, shot, reference):
    key = digest("squared errors of groups", lab.hashes[lab.ours], shot.settings(), shot.sources(), reference.name, PICTURES, GROUP)
    record = lab.runs.get((key, 0))
    if record is None:
        made = [lab.work / "groups" / f"{key}-{number}.png" for number in range(PICTURES)]
        spent = [
            samples_spent(lab.render(lab.ours, shot.independent(REFERENCE[0] + 1 + number), picture)[0])["samples"]
            for number, picture in enumerate(made)
        ]
        found = lab.tool("noise", "groups", reference, *made, "--side", GROUP)
        for picture in made:
            picture.unlink()
        record = {
            "key": key,
            "repetition": 0,
            "samples": sum(spent) / PICTURES,
            "squares": [line["squares"] for line in found],
            "reference_mse": found[0]["reference_mse"],
        }
        lab.keep(record)
    return record


def mean_by_group(lists):
    return [sum(values) / len(values) for values in zip(*lists)]


def ideal(even, sizes):
    """(rays of a pixel, MSE) for each lambda. `even`: squared errors by number of samples and picture."""
    points = []
    counts, half = sorted(even), PICTURES // 2
    for weight in LAMBDAS:
        rays = error = 0.0
        for chosen_by, judged_by in ((slice(half), slice(half, None)), (slice(half, None), slice(half))):
            known = {n: mean_by_group(even[n][chosen_by]) for n in counts}
            judged = {n: mean_by_group(even[n][judged_by]) for n in counts}
            for group, size in enumerate(sizes):
                best = min(counts, key=lambda n: known[n][group] + weight * n * size)
                rays += best * size / 2
                error += judged[best][group] / 2
        points.append((rays / sum(sizes), error / sum(sizes)))
    return points


def sizes_of_groups(width, height):
    return [3 * min(GROUP, width - x) * min(GROUP, height - y) for y in range(0, height, GROUP) for x in range(0, width, GROUP)]


def compare(even, adaptive, sizes):
    """Only adaptive records within the range of both curves."""
    values = sum(sizes)
    uniform = [(n, sum(mean_by_group(lists)) / values) for n, lists in even.items()]
    best = [point for point in ideal(even, sizes) if point[1] > 0]
    rows = []
    for record in adaptive:
        rays, mse = record["samples"], sum(mean_by_group(record["squares"])) / values
        if not min(even) <= rays <= max(even) or mse <= 0:
            continue
        evenly, ideally = error_after(uniform, rays), error_after(best, rays)
        if evenly and ideally:
            rows.append(
                {
                    "samples": rays,
                    "mse": mse,
                    "over_uniform": mse / evenly,
                    "over_ideal": mse / ideally,
                    "reference_mse": record["reference_mse"],
                }
            )
    return rows


def of_scene(lab, scene, whole):
    size, part = middle(whole, QUICK_PART if lab.quick else STRIP if whole == LARGE else whole)
    kept = {"size": size, "part": None if size == whole else part}
    lab.say(f"{scene.name}, {whole[0]} by {whole[1]}: where rays go")
    reference = lab.reference(scene.shot(TILT_LENS, **kept), *REFERENCE)
    even = {
        n: squares(lab, scene.shot(TILT_LENS, declare=suite.limits(n, n, 1e-3), **kept), reference)["squares"]
        for n in (QUICK_SAMPLES if lab.quick else SAMPLES)
    }
    adaptive = [
        squares(lab, scene.shot(TILT_LENS, declare=suite.limits(4, MOST, variance), **kept), reference)
        for variance in (QUICK_VARIANCES if lab.quick else VARIANCES)
    ]
    found = compare(even, adaptive, sizes_of_groups(*size))
    return [{"scene": scene.name, "whole": list(whole), **{name: float(f"{value:.4g}") for name, value in row.items()}} for row in found]


def scenes(lab, names):
    of_benchmark = [scene for scene in suite.SCENES if scene.name in names and (not lab.quick or scene.name in QUICK_SCENES)]
    of_gallery = [] if lab.quick else [suite.of_gallery(name, gallery.copy(lab, name)) for name in suite.DISPLAY if name in names]
    return [(scene, LARGE) for scene in of_benchmark + of_gallery] + [(scene, SMALL) for scene in of_benchmark]


def measure(lab, names):
    rows = [row for scene, whole in scenes(lab, names) for row in of_scene(lab, scene, whole)]
    for row in rows:
        lab.say(
            f"  {row['scene']} {row['whole'][0]}, {row['samples']:.1f} rays: {row['over_uniform']:.2f} of uniform,"
            f" {row['over_ideal']:.2f} of the ideal"
        )
    return rows

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The contract of `variance V`: mean square error at most 1.2 V, at most 5 % of the pixels off by more than 2 sqrt(V). Pixels beyond the
least samples should have at least V/4. The estimated standard error should be 0.8 to 1.2 times the true one."""

import statistics

from benchmarks import suite
from benchmarks.lab import TILT_LENS, Part, digest, samples_spent, standard_error

SIZE = (64, 48)
# part `crops`: the middle of a large picture, with fewer edges
CROP = Part(608, 336, 1280, 720)
# one picture has too few pixels that take more samples
PICTURES = {1e-2: 16, 1e-3: 16, 1e-4: 16, 1e-5: 4, 1e-6: 2}
QUICK = {1e-2: 8, 1e-3: 8, 1e-4: 4}
LEAST, MOST = 4, 262144  # no pixel should need the largest number


def claims(lab, shot, reference, first, count, variance):
    key = digest("claims and room, summary", lab.hashes[lab.ours], shot.settings(), shot.sources(), reference.name, first, count)
    record = lab.runs.get((key, 0))
    if record is None:
        pictures = [lab.work / "claims" / f"{key}-{number}.exr" for number in range(count)]
        said = [lab.render(lab.ours, shot.independent(first + number), picture)[0] for number, picture in enumerate(pictures)]
        (found,) = lab.tool("noise", "claims", reference, *pictures, "--variance", variance, "--more-than", LEAST)
        for picture in pictures:
            picture.unlink()
            picture.with_suffix(".layers.exr").unlink()
        samples = statistics.fmean(samples_spent(text).get("samples", 0.0) for text in said)
        record = {"key": key, "repetition": 0, "samples": samples, "estimated": standard_error(said), **found}
        lab.keep(record)
    return record


def measure(lab, scene, tilted, part=None):
    lab.say(f"{scene.name}{' tilted' if tilted else ''}{', cropped' if part else ''}: is the requested variance kept")
    batches, samples = scene.reference
    kept = {"size": SIZE, "part": part}
    times = max(4, scene.contract // 4) if lab.quick else scene.contract
    reference = lab.reference(scene.shot(TILT_LENS, tilted, **kept), batches, times * samples, unclipped=True)
    rows = []
    for variance, count in (QUICK if lab.quick else PICTURES).items():
        shot = scene.shot(TILT_LENS, tilted, declare=suite.limits(LEAST, MOST, variance), options=("+N",), **kept)
        found = claims(lab, shot, reference, batches + 1, count, variance)
        rows.append(
            {
                "scene": scene.name,
                "tilted": tilted,
                "variance": variance,
                "share": found["mse"] / variance,
                "more": found["share_more"],
                "share_of_more": found["mse_more"] / variance,
                "beyond": found["beyond"],
                "room": found["room"],
                "reference_mse": found["reference_mse"],
                "samples": found["samples"],
                "estimated": found["estimated"],
                "true": found["true"],
            }
        )
    return rows

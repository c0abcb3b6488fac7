# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Whether `variance V` is kept: the picture's mean square error should be at most 1.2 V, and at most 5 % of the pixels
should be off by more than 2 sqrt(V) in any channel. Over the pixels that took more than the least number of samples, the
mean square error should be at least V/4; otherwise rays were wasted."""

from statistics import mean

from benchmarks import suite
from benchmarks.lab import TILT_LENS

SIZE = (64, 48)
VARIANCES = (1e-3, 1e-4, 1e-5, 1e-6)
PICTURES = {1e-3: 16, 1e-4: 16, 1e-5: 4, 1e-6: 2}   # independent pictures: one has too few pixels that take more samples
LEAST, MOST = 8, 262144         # samples; no pixel should need the largest number


def measure(lab, scene, tilted):
    lab.say(f"{scene.name}{' tilted' if tilted else ''}: is the requested variance kept")
    batches, samples = scene.reference
    reference = lab.reference(scene.shot(TILT_LENS, tilted, size=SIZE), batches, scene.contract*samples)
    rows = []
    for variance in VARIANCES[:2] if lab.quick else VARIANCES:
        shot = scene.shot(TILT_LENS, tilted, size=SIZE, declare=suite.limits(LEAST, MOST, variance), options=("+N",))
        count = 1 if lab.quick else PICTURES[variance]
        shots = [shot, *[shot.independent(batches + number) for number in range(1, count)]]    # independent of the reference, too
        records = [lab.run(lab.ours, shot, reference, limits=(variance,), more_than=LEAST) for shot in shots]
        more = mean(record["share_more"] for record in records)
        of_more = mean(record["share_more"]*record["mse_more"] for record in records)/more if more else 0.0
        mse = mean(record["mse"] for record in records)
        rows.append({"scene": scene.name, "tilted": tilted, "variance": variance, "pictures": len(records), "mse": mse,
                     "share": mse/variance, "more": more, "share_of_more": of_more/variance,
                     "beyond": mean(record["beyond"][0] for record in records),
                     "reference_mse": records[0]["reference_mse"],
                     "samples": mean(record.get("samples", 0.0) for record in records)})
    return rows

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""A picture without blur: a narrow lens against a pinhole's anti-aliasing (+A), at equal error."""

import math

from benchmarks import suite
from benchmarks.front import seconds_for
from benchmarks.lab import PINHOLE, TILT_LENS

SCENES = ("checks", "foliage", "town")
SHARP = (("Blur", 1e-3),)
# errors compared at; the first is the default of +A
TARGETS = (("+A0.3", "+AM1", "+R3"), ("+A0.1", "+AM2", "+R3"), ("+A0.0", "+AM1", "+R3"), ("+A0.0", "+AM1", "+R6"))
OTHERS = (
    ("+A0.1", "+AM1", "+R3"),
    ("+A0.03", "+AM1", "+R4"),
    ("+A0.01", "+AM2", "+R4"),
    ("+A0.0", "+AM1", "+R2"),
    ("+A0.0", "+AM1", "+R4"),
    ("+A0.0", "+AM1", "+R9"),
    ("+A0.0", "+AM2", "+R3"),
    ("+A0.0", "+AM2", "+R4"),
)
MINIMA = (1, 2, 4, 8)


def shots(lab, scene):
    stock = [
        ("+A", " ".join(options), lab.stock, scene.shot(PINHOLE, options=options))
        for options in (TARGETS[:3] if lab.quick else TARGETS + OTHERS)
    ]
    ours = [
        ("tilt_lens", f"{least} {variance:g}", lab.ours, scene.shot(TILT_LENS, declare=(*SHARP, *suite.limits(least, 4096, variance))))
        for least in (MINIMA[2:] if lab.quick else MINIMA)
        for variance in (3e-2, 1e-2, 3e-3, 1e-3, 3e-4, 1e-4)
    ]
    longest = max(len(stock), len(ours))
    return [entry for i in range(longest) for entry in stock[i : i + 1] + ours[i : i + 1]]


def measure(lab, scene):
    lab.say(f"{scene.name}: a lens without blur, and anti-aliasing")
    reference = lab.reference(scene.shot(TILT_LENS, declare=SHARP), *scene.reference)
    chosen = shots(lab, scene)
    short = lab.run(*chosen[0][2:], reference)["cpu"] < 0.2
    runs = lab.interleaved([entry[2:] for entry in chosen], 2 if lab.quick else 25 if short else 5, reference)
    return [
        {**run, "program": program, "setting": setting, "scene": scene.name, "rmse": math.sqrt(run["mse"])}
        for (program, setting, _, _), run in zip(chosen, runs)
    ]


def compare(records):
    fronts = {
        program: [(record["cpu"], record["rmse"]) for record in records if record["program"] == program] for program in ("+A", "tilt_lens")
    }
    lines = []
    for target in TARGETS:
        for record in records:
            if record["setting"] == " ".join(target):
                stock, ours = (seconds_for(fronts[program], record["rmse"]) for program in ("+A", "tilt_lens"))
                lines.append(
                    {
                        "scene": record["scene"],
                        "target": record["setting"],
                        "rmse": record["rmse"],
                        "stock": stock,
                        "tilt_lens": ours,
                        "times": ours / stock if ours else None,
                    }
                )
    return lines

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Blur after the fact, by the depth of a pinhole picture of the unpatched program."""

import math
import re

from benchmarks.lab import PINHOLE, TILT_LENS, digest, run_measured

FOG = 12.0
# anti-aliasing misses fine edges at any threshold
EDGES = {"rough": ("+A0.0", "+AM1", "+R2"), "fine": ("+A0.0", "+AM1", "+R5")}


def lens_options(messages):
    numbers = re.search(r"^Lens: (.+)$", messages, re.MULTILINE).group(1).split()
    names = ("--width", "--distance", "--lens", "--focus", "--focus-slope")
    return [option for pair in zip(names, numbers) for option in pair]


def one(lab, scene, tilted, setting, reference):
    key = digest(
        "post of OpenEXR",
        EDGES[setting],
        lab.hashes[lab.stock],
        scene.shot(PINHOLE, tilted).sources(),
        scene.size,
        (lab.tools / "post_blur").read_bytes(),
        tilted,
        setting,
        reference.name,
    )
    record = lab.runs.get((key, 0))
    if record is None:
        folder = lab.work / "post"
        sharp, white, black, blurred = (folder / name for name in ("sharp.exr", "white.png", "black.png", "out.exr"))
        _, cpu_sharp, _ = lab.render(lab.stock, scene.shot(PINHOLE, tilted, options=EDGES[setting]), sharp)
        for brightness, picture in ((1, white), (0, black)):
            depth = scene.shot(PINHOLE, tilted, declare=(("Depth", FOG), ("White", brightness)))
            messages, cpu_depth, _ = lab.render(lab.stock, depth, picture)
        _, cpu_blur, _ = run_measured(
            [lab.tools / "post_blur", sharp, white, black, blurred, "--fog", FOG, *lens_options(messages)], folder
        )
        (figures,) = lab.tool("noise", "errors", reference, blurred)
        record = {
            "key": key,
            "repetition": 0,
            "cpu": cpu_sharp + cpu_depth + cpu_blur,
            "blur": cpu_blur,
            "mse": figures["mse"],
            "mean": figures["mean"],
        }
        lab.keep(record)
    return {
        **record,
        "program": "post-processed",
        "scene": scene.name,
        "tilted": tilted,
        "setting": setting,
        "rmse": math.sqrt(record["mse"]),
    }


def measure(lab, scene, tilted):
    reference = lab.reference(scene.shot(TILT_LENS, tilted), *scene.reference)
    return [one(lab, scene, tilted, setting, reference) for setting in (["fine"] if lab.quick else EDGES)]

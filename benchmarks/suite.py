# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The scenes and the settings that are tried."""

import dataclasses

from lab import STOCK, TILT_LENS, Shot


@dataclasses.dataclass(frozen=True)
class Scene:
    name: str
    title: str
    reference: tuple    # independent pictures, samples a pixel of each


SCENES = [
    Scene("checks", "emissive checks and spheres", (2, 2048)),
    Scene("foliage", "foliage", (2, 2048)),
    Scene("town", "town in sunlight", (2, 2048)),
    Scene("glass", "mirrors and glass", (2, 2048)),
    Scene("lights", "lights in the dark", (2, 4096)),
    Scene("shadows", "5 by 5 area light", (2, 1024)),
    Scene("landscape", "landscape", (2, 2048)),
]

# The errors compared at are those of stock with so many samples for every pixel.
TARGETS = (37, 100, 400, 1600)
# Stock at its best: a minimum that cures most of the premature stops, and a variance to go with it.
STOCK_ADAPTIVE = [(16, 100, 1e-2), (16, 400, 1e-3), (24, 200, 5e-3), (32, 400, 3e-3), (64, 800, 1e-3),
                  (64, 1600, 1e-3), (128, 1600, 3e-4), (128, 1600, 1e-4)]
STOCK_CONFIDENCE = [(32, 400, 1e-3, 0.99), (64, 1600, 3e-4, 0.99), (32, 400, 3e-3, 0.5)]
OURS_MIN = {"quick": (8,), "full": (4, 8, 16)}
OURS_VARIANCES = [3e-2, 1e-2, 4e-3, 1.5e-3, 6e-4, 2.5e-4, 1e-4, 4e-5, 1.5e-5, 6e-6, 2.5e-6, 1e-6, 4e-7]


def limits(least, most, variance, confidence=0.9):
    return (("Min", least), ("Max", most), ("Variance", variance), ("Confidence", confidence))


def stock_shots(scene, quick):
    """(name, shot) of stock focal blur, those that give the targets first."""
    for samples in TARGETS[:3] if quick else TARGETS:
        yield f"{samples}", Shot(scene, STOCK, declare=limits(samples, samples, 0))
    adaptive = [(*setting, 0.9) for setting in STOCK_ADAPTIVE] + ([] if quick else STOCK_CONFIDENCE)
    for setting in adaptive:
        if quick and setting[0] > 64:
            continue
        yield "{},{} {:g} {:g}".format(*setting), Shot(scene, STOCK, declare=limits(*setting))


def ours_shots(scene, tilted, quick):
    """(name, shot) of tilt_lens, from the roughest to the finest; lists of a minimum each."""
    for least in OURS_MIN["quick" if quick else "full"]:
        yield [(f"{least} {variance:g}",
                Shot(scene, TILT_LENS, tilted, declare=limits(least, 16384, variance)))
               for variance in OURS_VARIANCES]

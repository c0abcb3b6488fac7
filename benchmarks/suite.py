# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The scenes and the settings that are tried."""

import dataclasses

from benchmarks.lab import STOCK, TILT_LENS, Shot


@dataclasses.dataclass(frozen=True)
class Scene:
    name: str
    title: str
    reference: tuple        # independent pictures, samples a pixel of each
    frames: int = 1024      # of the accumulation buffer
    size: tuple = (200, 150)
    contract: int = 4       # times as many samples for the references of part contract, whose error must be small against 1e-6

    def shot(self, form, tilted=0, **more):
        return Shot(self.name, form, tilted, **{"size": self.size, **more})


SCENES = [
    Scene("checks", "emissive checks and spheres", (2, 1024), contract=64),
    Scene("foliage", "foliage", (2, 1024)),
    Scene("town", "town in sunlight", (2, 1024)),
    Scene("glass", "mirrors and glass", (2, 1024), contract=16),
    Scene("lights", "lights in the dark", (2, 2048)),
    Scene("shadows", "5 by 5 area light", (2, 512), 512, (100, 75)),
    Scene("interior", "room with radiosity", (2, 512), 512, (100, 75), contract=8),
    Scene("landscape", "landscape", (2, 1024)),
]

# The errors compared at are those of stock with these numbers of samples in each pixel.
TARGETS = (37, 100, 400, 1600)
# Settings for the best of stock: a minimum that prevents most early stops, and a variance that fits it.
STOCK_ADAPTIVE = [(16, 100, 1e-2), (16, 400, 1e-3), (24, 200, 5e-3), (32, 400, 3e-3), (64, 800, 1e-3),
                  (64, 1600, 1e-3), (128, 1600, 3e-4), (128, 1600, 1e-4)]
STOCK_CONFIDENCE = [(32, 400, 1e-3, 0.99), (64, 1600, 3e-4, 0.99), (32, 400, 3e-3, 0.5)]
VARIANCES = (3e-2, 1e-2, 4e-3, 1.5e-3, 6e-4, 2.5e-4, 1e-4, 4e-5, 1.5e-5, 6e-6, 2.5e-6, 1e-6, 4e-7)
# Least number of samples, variances.
OURS = {"quick": [(8, VARIANCES)], "full": [(8, VARIANCES), (2, VARIANCES[:5]), (4, VARIANCES[:7]), (16, VARIANCES[2:6])]}


def limits(least, most, variance, confidence=0.9):
    return (("Min", least), ("Max", most), ("Variance", variance), ("Confidence", confidence))


def stock_shots(scene, quick):
    """(name, shot) of stock focal blur; first those that define the errors compared at."""
    settings = [(samples, samples, 0, 0.9) for samples in (TARGETS[:3] if quick else TARGETS)]
    settings += [(*setting, 0.9) for setting in STOCK_ADAPTIVE if not quick or setting[0] <= 64]
    settings += [] if quick else STOCK_CONFIDENCE
    return [(str(setting[0]) if setting[2] == 0 else "{},{} {:g} {:g}".format(*setting),
             scene.shot(STOCK, declare=limits(*setting))) for setting in settings]


def ours_chains(scene, tilted, quick):
    """Lists of (name, shot) of tilt_lens, each from the roughest to the finest."""
    return [[(f"{least} {variance:g}", scene.shot(TILT_LENS, tilted, declare=limits(least, 16384, variance)))
             for variance in variances] for least, variances in OURS["quick" if quick else "full"]]

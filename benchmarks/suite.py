# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later

import dataclasses
import pathlib

from benchmarks.lab import SCENES as SCENE_FOLDER
from benchmarks.lab import STOCK, TILT_LENS, Part, Shot


# errors compared at: stock's with these numbers of samples
TARGETS = (37, 100, 400, 1600)


@dataclasses.dataclass(frozen=True)
class Scene:
    name: str
    title: str
    reference: tuple  # independent pictures, samples a pixel of each
    frames: int = 1024  # of the accumulation buffer
    size: tuple = (200, 150)
    contract: int = 4  # factor of samples for the references of part contract, whose error must be small against 1e-6
    quick_frames: int = 256
    targets: tuple = TARGETS
    part: Part = None  # the larger picture; the rendered one stands for it
    folder: pathlib.Path = SCENE_FOLDER

    def shot(self, form, tilted=0, **more):
        return Shot(self.name, form, tilted, **{"size": self.size, "part": self.part, "folder": self.folder, **more})

    def seconds(self, record):
        """For a part its rays', since start and parsing count for little in the whole."""
        return record["rays"] if self.part else record["cpu"]


SCENES = [
    Scene("checks", "emissive checks and spheres", (2, 1024), contract=64),
    Scene("foliage", "foliage", (2, 1024)),
    Scene("town", "town in sunlight", (2, 1024)),
    Scene("glass", "mirrors and glass", (2, 1024), contract=16),
    Scene("lights", "lights in the dark", (2, 2048)),
    Scene("dim", "lamps in the dim", (2, 2048)),
    Scene("shadows", "5 by 5 area light", (2, 512), 512, (100, 75)),
    Scene("interior", "room with radiosity", (2, 512), 512, (100, 75), contract=8),
    Scene("landscape", "landscape", (2, 1024)),
]
LAMPS = ("lights", "dim")

# A strip from the upper to the lower edge has all distances.
DISPLAY = {
    "miniature_town": "town",
    "miniature_harbour": "harbour",
    "miniature_railway": "railway",
    "miniature_stadium": "stadium",
    "facade_by_shift": "facade",
    "chess_by_swing": "chess",
    "watch_on_table": "watch",
    "city_lights": "city lights",
    "forest_reverse_tilt": "forest",
}
DISPLAY_SIZE = (1280, 720)
STRIP = (64, 360)
QUICK_DISPLAY = ("miniature_town", "chess_by_swing", "watch_on_table")  # parsed in a second or two
QUICKLY_PARSED = ("chess_by_swing", "watch_on_table", "city_lights")  # within a second, and that for each frame


def of_gallery(name, folder):
    part = Part((DISPLAY_SIZE[0] - STRIP[0]) // 2, (DISPLAY_SIZE[1] - STRIP[1]) // 2, *DISPLAY_SIZE)
    return Scene(
        name,
        DISPLAY[name],
        (2, 256),
        frames=256 if name in QUICKLY_PARSED else 64,
        size=STRIP,
        quick_frames=64,
        targets=(16, 37, 100, 400),
        part=part,
        folder=folder,
    )


# stock's best: a minimum against early stops, and its variance
STOCK_ADAPTIVE = [
    (16, 100, 1e-2),
    (16, 400, 1e-3),
    (24, 200, 5e-3),
    (32, 400, 3e-3),
    (64, 800, 1e-3),
    (64, 1600, 1e-3),
    (128, 1600, 3e-4),
    (128, 1600, 1e-4),
]
STOCK_SPARING = [(8, 37, 2e-2), (8, 100, 5e-3), (12, 64, 1e-2)]  # for the larger errors of a large picture
STOCK_CONFIDENCE = [(32, 400, 1e-3, 0.99), (64, 1600, 3e-4, 0.99), (32, 400, 3e-3, 0.5)]
VARIANCES = (3e-2, 1e-2, 4e-3, 1.5e-3, 6e-4, 2.5e-4, 1e-4, 4e-5, 1.5e-5, 6e-6, 2.5e-6, 1e-6, 4e-7)
# least number of samples, variances
OURS = {
    "quick": [(4, VARIANCES)],
    "full": [(4, VARIANCES), (2, VARIANCES[:5]), (8, VARIANCES[:8]), (16, VARIANCES[2:6])],
    "part": [(4, VARIANCES), (2, VARIANCES[:4])],
}


def limits(least, most, variance, confidence=0.9):
    return (("Min", least), ("Max", most), ("Variance", variance), ("Confidence", confidence))


def stock_shots(scene, quick):
    settings = [(samples, samples, 0, 0.9) for samples in (scene.targets[:3] if quick else scene.targets)]
    adaptive = STOCK_SPARING + STOCK_ADAPTIVE if scene.part else STOCK_ADAPTIVE
    most = 32 if quick and scene.part else 64 if quick or scene.part else 128  # minimum for the least error compared at
    settings += [(*setting, 0.9) for setting in adaptive if setting[0] <= most]
    settings += [] if quick else STOCK_CONFIDENCE
    return [
        (str(setting[0]) if setting[2] == 0 else "{},{} {:g} {:g}".format(*setting), scene.shot(STOCK, declare=limits(*setting)))
        for setting in settings
    ]


def ours_chains(scene, tilted, quick):
    return [
        [(f"{least} {variance:g}", scene.shot(TILT_LENS, tilted, declare=limits(least, 16384, variance))) for variance in variances]
        for least, variances in OURS["part" if scene.part else "quick" if quick else "full"]
    ]

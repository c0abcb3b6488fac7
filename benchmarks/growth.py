# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Cost by picture, blur, scene and threads, at constant variance."""

import os

from benchmarks import suite
from benchmarks.lab import STOCK, TILT_LENS, Shot

ASKED = suite.limits(8, 4096, 1e-3)
STOCK_ASKED = suite.limits(64, 1600, 1e-3)


def series(lab, name, unit, points):
    lab.say(f"growth with {name}")
    programs = {"tilt_lens": lab.ours, "stock": lab.stock}
    runs = lab.interleaved([(programs[program], shot) for _, program, shot in points], 1 if lab.quick else 3)
    return [
        {
            "series": name,
            "unit": unit,
            "x": x,
            "program": program,
            "cpu": run["cpu"],
            "seconds": run["seconds"],
            "samples": run.get("samples"),
            "start_up": lab.start_up(programs[program], shot),
        }
        for (x, program, shot), run in zip(points, runs)
    ]


def both(scene, x, size=(200, 150), declare=()):
    return [
        (x, "tilt_lens", Shot(scene, TILT_LENS, size=size, declare=(*declare, *ASKED))),
        (x, "stock", Shot(scene, STOCK, size=size, declare=(*declare, *STOCK_ASKED))),
    ]


def measure(lab):
    widths = (100, 200, 400) if lab.quick else (100, 200, 400, 800)
    blurs = (0.01, 0.25, 1, 4) if lab.quick else (0.01, 0.125, 0.25, 0.5, 1, 2, 4, 8)
    counts = (10, 1000, 10000) if lab.quick else (10, 100, 1000, 10000, 100000)
    threads = sorted({1, 2, 4, os.cpu_count()} & set(range(1, os.cpu_count() + 1)))
    return [
        *series(
            lab,
            "picture size",
            "pixels",
            [point for width in widths for point in both("town", width * width * 3 // 4, (width, width * 3 // 4))],
        ),
        *series(
            lab, "blur", "times the scene's aperture", [point for blur in blurs for point in both("town", blur, declare=(("Blur", blur),))]
        ),
        *series(lab, "objects", "spheres", [point for count in counts for point in both("many", count, declare=(("Count", count),))]),
        *series(
            lab,
            "threads",
            "threads",
            [(count, "tilt_lens", Shot("town", TILT_LENS, size=(400, 300), declare=ASKED, threads=count)) for count in threads],
        ),
    ]

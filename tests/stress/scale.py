# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later

import math
import pathlib
import re
import statistics
import tempfile

from tests.render import scenes
from tools import povray_run

HEAD = "#version 3.7; global_settings { assumed_gamma 1 }\n"
FULL = {"rows": (4, 8, 16, 32, 64), "samples": (100, 1000, 10_000), "objects": (10_000, 100_000, 1_000_000), "width": 16384}
QUICK = {"rows": (4, 8, 16), "samples": (100, 1000), "objects": (2000, 20_000), "width": 4096}


def render(setup, scene, size, *options):
    """Processor seconds, tests of rays, peak memory."""
    with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
        (pathlib.Path(name) / "scene.pov").write_text(HEAD + scene)
        done = povray_run.run(
            povray_run.command(setup.povray, "scene.pov", "picture.png", size, "+WT2", *options), name, limit=None
        ).succeeded()
    tests = re.findall(r"^[A-Z][\w ]+?  +(\d+) +\d+ +[\d.]+$", done.said, re.MULTILINE)
    if not tests:
        raise RuntimeError(f"no statistics\n{done.told()}")
    return {"processor_seconds": round(done.cpu, 2), "tests": sum(map(int, tests)), "peak_mib": round(done.memory / (1 << 20))}


def spheres(count):
    return (
        f"#declare R = seed(1); #for (I, 1, {count}) sphere {{ <8*rand(R)-4, rand(R), 9*rand(R)-2>, 0.02 pigment "
        "{ rgb <rand(R), rand(R), rand(R)> } } #end\n" + scenes.WORLD
    )


def slope(rows, key, of):
    xs = [math.log(row[key]) for row in rows]
    ys = [math.log(max(row[of], 0.01)) for row in rows]
    return statistics.linear_regression(xs, ys).slope


def measure(setup, size="full"):
    sizes = FULL if size == "full" else QUICK
    few = scenes.camera(samples="blur_samples 16 variance 0 ")
    width = sizes["width"]
    found = {"width": width, "rows": [], "samples": [], "objects": []}
    for rows in sizes["rows"]:
        middle = width // 2
        found["rows"].append({"rows": rows, **render(setup, few + scenes.WORLD, (width, width), f"+SR{middle}", f"+ER{middle + rows - 1}")})
    for samples in sizes["samples"]:
        camera = scenes.camera(samples=f"blur_samples {samples} variance 0 ")
        found["samples"].append({"samples": samples, **render(setup, camera + scenes.WORLD, (64, 48))})
    for objects in sizes["objects"]:
        found["objects"].append({"objects": objects, **render(setup, few + spheres(objects), (160, 120))})
    found["slopes"] = {key: slope(found[key], key, "processor_seconds") for key in ("rows", "samples", "objects")}
    found["work_slopes"] = {key: slope(found[key], key, "tests") for key in ("rows", "samples", "objects")}
    return found


def faults(result):
    """Superlinear growth; time depends on the load."""
    found = [f"{key}: work grows with the power {value:.2f}" for key, value in result["work_slopes"].items() if value > 1.15]
    objects = result["objects"]
    each = (objects[-1]["peak_mib"] - objects[0]["peak_mib"]) * 1024 / (objects[-1]["objects"] - objects[0]["objects"])
    if each > 4:
        found.append(f"objects: {each:.1f} KiB each")
    if result["samples"][-1]["peak_mib"] > result["samples"][0]["peak_mib"] + 64:
        found.append(f"samples: {result['samples']}")
    return found

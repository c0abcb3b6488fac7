# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""tilt_lens against Cycles, whose lens cannot be tilted, on the emissive checks, which both can draw."""

import json
import math
import re
import shutil
import statistics
import subprocess

from benchmarks import suite, versus_stock
from benchmarks.front import seconds_for
from benchmarks.lab import PINHOLE, TILT_LENS, Failed, digest
from tools.repository import ROOT

SCENE = next(scene for scene in suite.SCENES if scene.name == "checks")
# samples compared at; most samples, threshold and least samples of adaptive sampling
TARGETS = (16, 64, 256, 1024)
ADAPTIVE = ((256, 0.1, 16), (256, 0.05, 32), (1024, 0.05, 64), (1024, 0.02, 64), (4096, 0.02, 64), (4096, 0.01, 128), (4096, 0.005, 128))


def installed():
    return shutil.which("blender")


def scene_told(lab):
    shot = SCENE.shot(PINHOLE, declare=(("Tell", 1),))
    messages, _, _ = lab.render(lab.ours, lab.one_pixel(shot), lab.work / "cycles" / "told.png")

    def lines(word):
        return [list(map(float, line.split())) for line in re.findall(rf"^{word}: (.+)$", messages, re.MULTILINE)]

    (camera,), (focus,) = lines("Camera"), lines("Focus")
    return {
        "eye": camera[:3],
        "axis": camera[3:],
        "angle": focus[0],
        "focus": focus[1],
        "radius": focus[2],
        "spheres": lines("Sphere"),
        "size": SCENE.size,
    }


def settings(quick):
    """A threshold of 0 turns adaptive sampling off."""
    return [(str(samples), samples, 0, 0) for samples in (TARGETS[:3] if quick else TARGETS)] + [
        (f"{least},{most} {threshold:g}", most, threshold, least) for most, threshold, least in (ADAPTIVE[:4] if quick else ADAPTIVE)
    ]


def render_all(lab, folder, repetitions):
    """CPU seconds without the start of Blender; the first pictures stay."""
    (folder / "scene.json").write_text(json.dumps({**scene_told(lab), "settings": settings(lab.quick), "repetitions": repetitions}))
    done = subprocess.run(
        [
            installed(),
            "--background",
            "--factory-startup",
            "--python-exit-code",
            "1",
            "--python",
            str(ROOT / "benchmarks" / "cycles_scene.py"),
            "--",
            str(folder / "scene.json"),
        ],
        cwd=folder,
        capture_output=True,
        text=True,
        errors="replace",
        check=False,
    )
    found = [json.loads(line) for line in re.findall(r"^Cycles: (.+)$", done.stdout, re.MULTILINE)]
    if done.returncode != 0 or len(found) != repetitions * len(settings(lab.quick)):
        raise Failed(f"Blender ended with {done.returncode}:\n{(done.stdout + done.stderr)[-3000:]}")
    return found


def measure(lab):
    if not installed():
        lab.say("Part cycles is skipped, because Blender is not installed (sudo apt-get install blender).")
        return None
    lab.say("checks: Cycles and tilt_lens")
    reference = lab.reference(SCENE.shot(TILT_LENS), *SCENE.reference)
    version = subprocess.run([installed(), "--version"], capture_output=True, text=True, check=True).stdout.splitlines()[0]
    key = digest(
        "cycles",
        version,
        (ROOT / "benchmarks" / "cycles_scene.py").read_text(),
        SCENE.shot(TILT_LENS).sources(),
        settings(lab.quick),
        reference.name,
    )
    record = lab.runs.get((key, 0))
    if record is None:
        folder = lab.work / "cycles"
        folder.mkdir(exist_ok=True)
        found = render_all(lab, folder, 1 if lab.quick else 3)
        pictures = [folder / f"{number}.exr" for number in range(len(settings(lab.quick)))]
        errors = lab.tool("noise", "errors", reference, *pictures)
        record = {
            "key": key,
            "repetition": 0,
            "version": version,
            "runs": [
                {
                    "setting": name,
                    "mse": figures["mse"],
                    "mean": figures["mean"],
                    "cpu": statistics.median(line["cpu"] for line in found if line["setting"] == name),
                }
                for (name, *_), figures in zip(settings(lab.quick), errors)
            ],
        }
        lab.keep(record)
    cycles = [{**run, "program": "cycles", "scene": "checks", "rmse": math.sqrt(run["mse"])} for run in record["runs"]]
    ours = [run for run in versus_stock.measure(lab, SCENE) if run["program"] == "tilt_lens"]
    return {"version": version, "lines": compare(cycles, ours)}


def compare(cycles, ours):
    fronts = [[(run["cpu"], run["rmse"]) for run in runs] for runs in (cycles, ours)]
    lines = []
    for run in cycles:
        if run["setting"].isdigit():
            theirs, took = (seconds_for(front, run["rmse"]) for front in fronts)
            lines.append(
                {
                    "target": int(run["setting"]),
                    "rmse": run["rmse"],
                    "cycles": theirs,
                    "tilt_lens": took,
                    "ratio": theirs / took if took else None,
                }
            )
    return lines

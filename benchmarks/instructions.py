# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Scenes without tilt_lens: callgrind's instructions against the unpatched source. Also the inner loops, by Google Benchmark."""

import json
import re
import subprocess
import tempfile

from benchmarks import suite
from benchmarks.lab import PINHOLE, STOCK, Failed, Shot, digest
from tools import povray_run

SIZE = (64, 48)
CASES = [
    ("town, pinhole", Shot("town", PINHOLE, size=SIZE)),
    ("town, +A", Shot("town", PINHOLE, size=SIZE, options=("+A0.1", "+AM2", "+R3"))),
    ("town, stock focal blur", Shot("town", STOCK, size=SIZE, declare=suite.limits(16, 16, 0))),
    ("mirrors and glass, pinhole", Shot("glass", PINHOLE, size=SIZE)),
    ("area light, pinhole", Shot("shadows", PINHOLE, size=SIZE)),
]


def count(lab, binary, shot, times=1, within=None):
    """The least of several runs, since threads that wait vary it."""
    key = digest("callgrind", binary.read_bytes(), shot.settings(), shot.sources(), *filter(None, [within]))
    record = lab.runs.get((key, 0))
    if record is None:
        with tempfile.TemporaryDirectory() as folder:
            command = [
                "valgrind",
                "--tool=callgrind",
                "--callgrind-out-file=/dev/null",
                *([f"--toggle-collect={within}"] if within else []),
                *shot.command(binary, f"{folder}/picture.png", *lab.gathered_light(shot)),
            ]
            counts = []
            for _ in range(times):
                done = povray_run.run(command, folder, limit=None).succeeded()
                found = re.search(r"Collected : (\d+)", done.said)
                if not found:
                    raise Failed(f"callgrind does not report how many instructions it counted:\n{done.told()}")
                counts.append(int(found.group(1)))
        record = {"key": key, "repetition": 0, "instructions": min(counts), "all": counts}
        lab.keep(record)
    return record["instructions"]


def measure(lab, unpatched):
    lab.say("instructions of scenes without tilt_lens, patched and unpatched")
    rows = []
    for name, shot in CASES[:2] if lab.quick else CASES:
        plain, patched = count(lab, unpatched, shot, 3), count(lab, lab.ours, shot, 3)
        rows.append({"case": name, "unpatched": plain, "patched": patched, "more": patched / plain - 1})
    return rows


def inner_loops(lab):
    lab.say("inner loops")
    program = lab.tools / "inner_loops"
    seconds = 0.05 if lab.quick else 0.3
    key = digest("inner loops", program.read_bytes(), seconds)
    record = lab.runs.get((key, 0))
    if record is None:
        command = [program, "--benchmark_format=json", "--benchmark_repetitions=5", f"--benchmark_min_time={seconds}"]
        done = subprocess.run(list(map(str, command)), capture_output=True, text=True, check=True)
        medians = {
            entry["run_name"]: {name: entry[name] for name in ("cpu_time", "per_sample") if name in entry}
            for entry in json.loads(done.stdout)["benchmarks"]
            if entry.get("aggregate_name") == "median"
        }
        record = {"key": key, "repetition": 0, "medians": medians}
        lab.keep(record)
    medians = record["medians"]
    empty = medians["Empty"]["cpu_time"]

    def call(name, arguments_drawn=True):
        return medians[name]["cpu_time"] - (empty if arguments_drawn else 0.0)

    def tile(most, denoise):
        return 1e9 * medians[f"TilePerSample/samples:{most}/denoise:{denoise}"]["per_sample"]

    return [
        ("ray from film point and lens point (MakeRay)", call("Ray")),
        ("sample of lens and pixel (PixelSampler)", call("SamplePoint", False)),
        ("a pixel's sampler made anew", call("NewPixel", False)),
        ("round aperture", call("Map/disc")),
        ("aperture of 7 blades", call("Map/polygon")),
        ("aperture from a picture", call("Map/picture")),
        *[
            (
                f"bookkeeping a sample, {most} samples a pixel, denoise {'on' if denoise else 'off'} (TileSampler, without"
                " samples and rays)",
                tile(most, denoise),
            )
            for most in (64, 1024)
            for denoise in (0, 1)
        ],
    ]

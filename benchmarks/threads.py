# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Wall time of tracing by threads, the share that they wait, and the share of the whole run in which processors idle. The machine must be
quiet: a thread without a processor waits, too."""

import os
import re
import statistics

from benchmarks import gallery, suite
from benchmarks.lab import TILT_LENS, Failed, Shot, digest

SIZE, QUICK_SIZE = suite.DISPLAY_SIZE, (320, 180)
REPETITIONS = 3
SLEEPERS = (4, 16, 64)
SLEPT = 20  # seconds of wall time if none waits: the sampler's own computing, on few processors, is small against it


def numbers_of_threads(processors=None):
    return [threads for threads in (1, 2, 4, 8, 16) if threads <= max(2, processors or os.cpu_count() or 1)]


def traced(messages):
    found = re.search(r"^  Trace Time:[^(]*\(([0-9.]+) seconds\)\s+using \d+ thread\(s\) with ([0-9.]+) CPU-seconds", messages, re.M)
    if not found:
        raise Failed(f"the program does not report how long it traced:\n{messages[-1000:]}")
    return tuple(map(float, found.groups()))


def run(lab, shot, repetition):
    key = digest("threads and whole run", lab.hashes[lab.ours], shot.settings(), shot.sources())
    record = lab.runs.get((key, repetition))
    if record is None:
        picture = lab.work / "pictures" / f"{key}.png"
        messages, run_cpu, run_wall = lab.render(lab.ours, shot, picture)
        wall, cpu = traced(messages)
        picture.unlink()
        record = {"key": key, "repetition": repetition, "wall": wall, "cpu": cpu, "run_wall": run_wall, "run_cpu": run_cpu}
        lab.keep(record)
    return record


def of_scene(lab, name):
    """In turn, so that a busy minute hits all alike."""
    shots = {
        threads: Shot(name, TILT_LENS, 1, QUICK_SIZE if lab.quick else SIZE, threads=threads, folder=gallery.GALLERY)
        for threads in numbers_of_threads()
    }
    lab.say(f"{name} with {', '.join(map(str, shots))} threads")
    records = {threads: [] for threads in shots}
    for repetition in range(REPETITIONS):
        for threads, shot in shots.items():
            records[threads].append(run(lab, shot, repetition))
    rows = []
    for threads, found in records.items():
        wall, cpu, run_wall = (statistics.median(record[what] for record in found) for what in ("wall", "cpu", "run_wall"))
        waited, idle = (
            statistics.median(1 - record[f"{of}cpu"] / (threads * record[f"{of}wall"]) for record in found) for of in ("", "run_")
        )
        rows.append(
            {
                "scene": name,
                "size": list(shots[threads].size),
                "threads": threads,
                "wall": round(wall, 3),
                "cpu": round(cpu, 3),
                "waited": round(waited, 4),
                "run": round(run_wall, 3),
                "idle": round(idle, 4),
            }
        )
    return rows


def sleeping(lab, name):
    """Threads sleep for as many rays as the picture took; so there may be more of them than processors."""
    lab.say(f"{name} with {', '.join(map(str, SLEEPERS))} threads that sleep")
    shot = Shot(name, TILT_LENS, 1, SIZE, threads=2, folder=gallery.GALLERY, options=("+N",))
    picture = lab.work / "pictures" / f"{name}-counts.png"
    layers = picture.with_suffix(".layers.exr")
    lab.render(lab.ours, shot, picture)
    found = lab.tool("thread_waits", layers, "--threads", ",".join(map(str, SLEEPERS)), "--seconds", SLEPT)
    picture.unlink()
    layers.unlink()
    return [{"scene": name, "threads": row["threads"], "busy": round(row["busy"], 4)} for row in found]


def efficiency(rows, row):
    one = next(other for other in rows if other["scene"] == row["scene"] and other["threads"] == 1)
    return one["wall"] / (row["threads"] * row["wall"])


def measure(lab, names):
    wanted = [name for name in suite.DISPLAY if name in names]
    return {
        "traced": [row for name in wanted for row in of_scene(lab, name)],
        "slept": [row for name in suite.QUICK_DISPLAY if name in wanted for row in sleeping(lab, name)],
    }

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Wall time of tracing by threads, and the share that they wait. The machine must be quiet: a thread without a processor waits, too."""

import os
import re
import statistics

from benchmarks import gallery, suite
from benchmarks.lab import TILT_LENS, Failed, Shot, digest

SIZE, QUICK_SIZE = suite.DISPLAY_SIZE, (320, 180)
REPETITIONS = 3


def numbers_of_threads(processors=None):
    return [threads for threads in (1, 2, 4, 8, 16) if threads <= max(2, processors or os.cpu_count() or 1)]


def traced(messages):
    found = re.search(r"^  Trace Time:[^(]*\(([0-9.]+) seconds\)\s+using \d+ thread\(s\) with ([0-9.]+) CPU-seconds", messages, re.M)
    if not found:
        raise Failed(f"the program does not report how long it traced:\n{messages[-1000:]}")
    return tuple(map(float, found.groups()))


def run(lab, shot, repetition):
    key = digest("threads", lab.hashes[lab.ours], shot.settings(), shot.sources())
    record = lab.runs.get((key, repetition))
    if record is None:
        picture = lab.work / "pictures" / f"{key}.png"
        wall, cpu = traced(lab.render(lab.ours, shot, picture)[0])
        picture.unlink()
        record = {"key": key, "repetition": repetition, "wall": wall, "cpu": cpu}
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
        wall, cpu = (statistics.median(record[what] for record in found) for what in ("wall", "cpu"))
        waited = statistics.median(1 - record["cpu"] / (threads * record["wall"]) for record in found)
        rows.append(
            {
                "scene": name,
                "size": list(shots[threads].size),
                "threads": threads,
                "wall": round(wall, 3),
                "cpu": round(cpu, 3),
                "waited": round(waited, 4),
            }
        )
    return rows


def efficiency(rows, row):
    one = next(other for other in rows if other["scene"] == row["scene"] and other["threads"] == 1)
    return one["wall"] / (row["threads"] * row["wall"])


def measure(lab, names):
    wanted = [name for name in suite.DISPLAY if name in names and (not lab.quick or name in suite.QUICK_DISPLAY)]
    return [row for name in wanted for row in of_scene(lab, name)]

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Measures how batches scale, and writes the figures into docs/batch.md (between its two marks).

usage: python3 -m benchmarks.batch_scaling [--repeat N] [--write]     without --write the text is only printed

Times are medians. Other programs change elapsed times by much; the text therefore states the machine's load.
"""

import argparse
import os
import pathlib
import statistics
import sys
import tempfile
import time

from tools import povray_run
from tools.cluster import Cluster
from tools.repository import BUILD, ROOT

BEGIN, END = "<!-- written by benchmarks/batch_scaling.py -->\n", "<!-- end -->\n"
SCENE = ROOT / "scenes" / "tutorial" / "film.pov"
POVRAY = BUILD / "bin" / "povray"
TINY = (16, 12), "Declare=Stop=22"
FRAMES = 12
STILL = (640, 512), "Declare=Tilt=-8"  # eight bands of 64 rows
EIGHT_K = (7680, 4320)
FILM = 1440  # a minute at 24 a second
NODES = 1000


def measured(command, folder, env=None):
    """Elapsed seconds, CPU seconds, the largest process in MB, with child processes."""
    done = povray_run.run(command, folder, env or povray_run.user_environment(), limit=None)
    if done.code != 0:
        sys.exit(done.told())
    return done.seconds, done.cpu, done.memory / (1 << 20)


def words(picture):
    (width, height), *options = picture
    return [f"+W{width}", f"+H{height}", *options]


def median(runs, column):
    return statistics.median(run[column] for run in runs)


class Measurements:
    def __init__(self, repeat, folder):
        self.repeat, self.folder = repeat, pathlib.Path(folder)
        self.count = 0

    def batch(self, *words, env=None):
        self.count += 1
        output = self.folder / f"out{self.count}{'.png' if words[0] == 'still' else ''}"
        return measured([ROOT / "batch", *words, "--output", output, "--povray", POVRAY, "--quiet"], self.folder, env)

    def start(self):
        command = povray_run.command(POVRAY, SCENE, "tiny.png", *TINY, "+WT1", library=[SCENE.parent])
        return [measured(command, self.folder) for _ in range(self.repeat)]

    def unit(self, *more, env=None):
        """A film of tiny frames, less a film of one."""
        runs = []
        for _ in range(self.repeat):
            many = self.batch("film", SCENE, "--frames", FRAMES, "--bands", 1, "--workers", 1, *words(TINY), *more, env=env)
            one = self.batch("film", SCENE, "--frames", 1, "--bands", 1, "--workers", 1, *words(TINY), *more, env=env)
            runs.append(tuple((a - b) / (FRAMES - 1) for a, b in zip(many, one)))
        return runs

    def speed(self):
        runs = {}
        whole = povray_run.command(POVRAY, SCENE, "whole.png", *STILL, library=[SCENE.parent])
        for _ in range(self.repeat):
            for threads in (1, 2):
                runs.setdefault(f"povray +WT{threads}", []).append(measured([*whole, f"+WT{threads}"], self.folder))
            for workers in (1, 2, 4):
                run = self.batch("still", SCENE, "--bands", 8, "--workers", workers, *words(STILL))
                runs.setdefault(f"batch, {workers} workers" if workers > 1 else "batch, 1 worker", []).append(run)
        return runs

    def large(self):
        width, height = EIGHT_K
        band = povray_run.command(
            POVRAY, SCENE, "band.exr", EIGHT_K, "+WT1", "+FE", "Declare=Stop=22", "+SR2145", "+ER2176", library=[SCENE.parent]
        )
        memory = measured(band, self.folder)[2]
        check = measured(["oiiotool", "--info", "--hash", "band.exr"], self.folder)
        noise = ["oiiotool", "--pattern", "noise", f"{width}x{height}", "3", "-d", "half", "--compression", "zip"]
        for name in ("a", "b"):
            measured([*noise, "-o", f"{name}.exr"], self.folder)
        half = height // 2
        cut = ["a.exr", "--crop", f"{width}x{half}+0+0", "b.exr", "--crop", f"{width}x{half}+0+{half}"]
        join = measured(["oiiotool", *cut, "--paste:all=1:mergeroi=1", "+0+0", "-o", "joined.exr"], self.folder)
        return {"memory": memory, "check": check[1], "join": join[1], "bytes": (self.folder / "band.exr").stat().st_size}


def dispatch_rate(repeat):
    rates = []
    with tempfile.TemporaryDirectory(prefix="slurm.") as folder, Cluster(folder) as cluster:
        for _ in range(repeat):
            begun = time.monotonic()
            cluster.run("sbatch", "--array=0-59", "--output=/dev/null", "--wrap=true", f"--chdir={folder}")
            cluster.until("the array's end", lambda: not cluster.run("squeue", "-h").stdout.strip(), 300)
            rates.append(60 / (time.monotonic() - begun))
    return statistics.median(rates)


def on_paper(hours, bands, costs):
    """NODES one-core workers start one after the other; the last one of a frame joins it."""
    units = FILM * bands
    edges = 2 * (bands - 1) * costs["margin"] / EIGHT_K[1]
    unit = hours * 3600 * (1 + edges) / bands + costs["unit"] + costs["check"]
    join = bands * costs["check"] + costs["join"] if bands > 1 else 0.0
    waves = -(-units // NODES)
    clock = NODES / costs["rate"] + waves * unit + -(-FILM // NODES) * join
    return waves, clock / 3600, FILM * hours * 3600 / clock


def table(head, rows):
    lines = [f"| {' | '.join(head)} |", f"| {' | '.join('---' for _ in head)} |"]
    return lines + [f"| {' | '.join(row)} |" for row in rows]


def cost_rows(start, unit, large, rate):
    return [
        ("a start of POV-Ray, tiny picture", f"{median(start, 0):.2f}", f"{median(start, 1):.2f}"),
        ("a unit of a batch, tiny picture (start, check, record)", f"{median(unit, 0):.2f}", f"{median(unit, 1):.2f}"),
        ("checking one 8K OpenEXR band", "", f"{large['check']:.1f}"),
        ("joining an 8K OpenEXR picture of noise from two", "", f"{large['join']:.1f}"),
        ("a task of Slurm, on the private cluster of three nodes", f"{1 / rate:.2f}", ""),
    ]


def speed_rows(runs):
    first = median(runs["povray +WT1"], 0)
    return [(name, f"{median(found, 0):.1f}", f"{median(found, 1):.1f}", f"{first / median(found, 0):.2f}") for name, found in runs.items()]


def margin(runs, unit):
    """Rows sampled beyond a band's edges, by the time of eight bands beyond that of the whole and of the units."""
    whole, bands, rows = (median(runs["povray +WT1"], 1), median(runs["batch, 1 worker"], 1), STILL[0][1])
    return max(0.0, bands - whole - 10 * median(unit, 1)) / (2 * 7) / (whole / rows)  # two small renders


def paper_rows(costs, here):
    rows = []
    for hours in (0.1, 1.0, 10.0, here):
        for bands in (1, 4, 16):
            waves, clock, faster = on_paper(hours, bands, costs)
            rows.append((f"{hours:.1f}", str(bands), str(waves), f"{clock:.2f}", f"{faster:.0f}"))
    return rows


def text(repeat):
    load = os.getloadavg()[0]
    with tempfile.TemporaryDirectory(prefix="scaling.") as folder:
        measure = Measurements(repeat, folder)
        start, unit, runs, large = measure.start(), measure.unit(), measure.speed(), measure.large()
    rate = dispatch_rate(repeat)
    size = STILL[0]
    here = median(runs["povray +WT1"], 1) / (size[0] * size[1]) * EIGHT_K[0] * EIGHT_K[1] / 3600
    costs = {"unit": median(unit, 0), "check": large["check"], "join": large["join"], "rate": rate}
    costs["margin"] = margin(runs, unit)
    lines = [
        f"Medians of {repeat}, on {os.cpu_count()} cores; load of the machine before the run: {load:.1f}.",
        "",
        *table(("action", "elapsed s", "CPU s"), cost_rows(start, unit, large, rate)),
        "",
        f"The tutorial's `film.pov` with tilt -8, {size[0]} by {size[1]} pixels in 8 bands:",
        "",
        *table(("program", "elapsed s", "CPU s", "speed-up"), speed_rows(runs)),
        "",
        f"Each edge between two bands costs as much as about {costs['margin']:.0f} rows: pixels are sampled together with their",
        "neighbours, so that two bands both sample the rows beside their common edge.",
        "",
        f"One band of an 8K picture ({EIGHT_K[0]} by {EIGHT_K[1]}) takes {large['memory']:.0f} MB of memory, because POV-Ray",
        f"holds the whole frame, and {large['bytes'] / 1000:.0f} KB of disk.",
        "",
        f"**Calculated from these costs**: {FILM} frames of 8K on {NODES} nodes of one core each. The last rows use the cost per",
        "frame of the scene above.",
        "",
        *table(("core-hours per frame", "bands", "waves of units", "elapsed hours", "speed-up over one core"), paper_rows(costs, here)),
        "",
    ]
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--repeat", type=int, default=3)
    parser.add_argument("--write", action="store_true")
    settings = parser.parse_args()
    section = text(settings.repeat)
    print(section)
    if settings.write:
        page = ROOT / "docs" / "batch.md"
        head, _, rest = page.read_text(encoding="utf-8").partition(BEGIN)
        page.write_text(head + BEGIN + section + END + rest.partition(END)[2], encoding="utf-8")


if __name__ == "__main__":
    main()

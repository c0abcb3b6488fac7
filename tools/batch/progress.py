# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later

import os
import re
import sys
import time

from tools.batch.plan import unit_name
from tools.batch.store import read_json


LOOKED_AT, SHOWN = 64, 3  # running units whose records are read, and those in the progress line
LONG = 600  # seconds after which a running unit deserves a hint


def span(seconds):
    seconds = int(round(seconds))
    if seconds < 90:
        return f"{seconds} s"
    if seconds < 5400:
        return f"{seconds / 60:.0f} min"
    return f"{seconds / 3600:.1f} h"


class State:
    def __init__(self, work, description):
        bands = len(description["key"]["bands"])
        pictures = description.get("only") or range(len(description["key"]["pictures"]))
        numbers = [picture * bands + band for picture in pictures for band in range(bands)]
        self.units = {unit_name(number, bands): number for number in numbers}
        merged = {int(name) for name in work.names("merged")}
        done = work.names("done")
        self.done = {name for name, n in self.units.items() if n // bands in merged or name in done}
        self.failed = (work.names("failed") & self.units.keys()) - self.done
        self.running = (work.names("running") & self.units.keys()) - self.done
        self.merged, self.pictures = len(merged.intersection(pictures)), len(pictures)

    def missing(self):
        return [n for name, n in self.units.items() if name not in self.done and name not in self.failed]


class Running:
    def __init__(self, work, name, description):
        bands = description["key"]["bands"]
        record = read_json(work.record("running", name)) or {}
        picture, band = (int(part) for part in name.split("."))
        self.label = description["key"]["pictures"][picture].get("label", name)
        if len(bands) > 1:
            self.label += f" band {band + 1}"
        self.since, self.host = record.get("since", time.time()), record.get("host")
        self.log, self.begins = record.get("log"), record.get("begins", 0)
        self.seconds = max(0.0, time.time() - self.since)

    def percent(self):
        lines = log_end(self.log, 1, self.begins) if self.log else [""]
        found = re.findall(r"\((\d+)%", lines[0] if lines else "")
        return int(found[-1]) if found else None

    def text(self):
        percent = self.percent()
        return f"{self.label} ({span(self.seconds)}" + (")" if percent is None else f", {percent}%)")


class Progress:
    """Overwritten on a terminal, repeated now and then elsewhere."""

    def __init__(self, work, description, quiet=False):
        self.work, self.description, self.quiet = work, description, quiet
        self.begun = time.monotonic()
        self.at_begin = len(State(work, description).done)
        self.terminal = sys.stderr.isatty()
        self.last_text, self.last_time = "", 0.0
        self.hinted = False

    def time_left(self, state):
        """Seconds at this run's pace; None before a hundredth of a unit."""
        running = sum((Running(self.work, name, self.description).percent() or 0) / 100 for name in state.running)
        finished = len(state.done) - self.at_begin + running
        if finished < 0.01:
            return ""
        pace = (time.monotonic() - self.begun) / finished
        return f", {span(pace * (len(state.units) - len(state.done) - running))} left"

    def text(self):
        state = State(self.work, self.description)
        what = "bands" if len(self.description["key"]["bands"]) > 1 else "pictures"
        left = self.time_left(state) if len(state.done) < len(state.units) else ""
        return (
            f"{len(state.done)} of {len(state.units)} {what} done, {len(state.running)} running, "
            f"{len(state.failed)} failed{left}{self.at_work(state)}"
        )

    def at_work(self, state):
        units = [Running(self.work, name, self.description) for name in sorted(state.running)[:LOOKED_AT]]
        units.sort(key=lambda unit: -unit.seconds)
        if units and units[0].seconds > LONG and not self.hinted and not self.description.get("limit"):
            self.hinted = True
            sys.stderr.write(
                f"{units[0].label} has been running for {span(units[0].seconds)}; log: {units[0].log}. If it hangs: "
                "Ctrl-C, and again with --limit TIME.\n"
            )
        shown = "; ".join(unit.text() for unit in units[:SHOWN])
        return f": {shown}" + ("; ..." if len(state.running) > SHOWN else "") if shown else ""

    def show(self, final=False):
        now = time.monotonic()
        pause = 1.0 if self.terminal else 30.0
        if self.quiet or (not final and now - self.last_time < pause):
            return
        text = self.text()
        self.last_time = now
        if self.terminal:
            columns = os.get_terminal_size(sys.stderr.fileno()).columns or 80
            sys.stderr.write(f"\r\033[K{text[:columns - 1]}" + ("\n" if final else ""))
        elif text != self.last_text:
            sys.stderr.write(text + "\n")
        sys.stderr.flush()
        self.last_text = text


def log_end(path, lines=6, begins=0, ends=None):
    try:
        ends = os.path.getsize(path) if ends is None else ends
        with open(path, "rb") as stream:
            begins = max(begins, ends - 20000)
            stream.seek(begins)
            text = stream.read(ends - begins).decode(errors="replace")
    except OSError as error:
        return [f"(no log: {error.strerror})"]
    kept = [line for line in text.replace("\r", "\n").splitlines() if line.strip()]
    return kept[-lines:]


def failures(work, description):
    for name in sorted(State(work, description).failed):
        record = read_json(work.record("failed", name)) or {}
        yield f"failed: {record.get('picture', name)!r} rows {record.get('rows')}: {record.get('reason')}"
        yield f"  log: {record.get('log')}"
        end = log_end(record.get("log", ""), begins=record.get("begins", 0), ends=record.get("ends"))
        yield from ("  | " + line for line in end)


def unfinished(work, description):
    """Logs of workers that never reported."""
    state = State(work, description)
    if state.missing():
        logs = sorted(path for path in work.logs.iterdir() if not path.name.startswith("task-") and path.stat().st_size)
        for path in logs[-2:]:
            yield f"log {path}:"
            yield from ("  | " + line for line in log_end(path))
        jobs = read_json(work.folder / "jobs.json")
        if description["on"] == "slurm" and jobs:
            yield f"What Slurm knows of it: scontrol show job {jobs[0]}, or sacct -j {jobs[0]}"


def times(work, description):
    seconds = tries = 0
    for name in State(work, description).units:
        record = read_json(work.record("done", name))
        if record:
            seconds += record["seconds"]
            tries += record["try"] - 1
    return seconds, tries


def summary(work, description, elapsed):
    state = State(work, description)
    seconds, tries = times(work, description)
    missing = len(state.units) - len(state.done)
    yield (
        f"{state.merged} of {state.pictures} pictures in {description['output']!r}"
        if state.pictures > 1
        else f"{state.merged} of 1 picture"
    )
    yield (
        f"{len(state.done)} of {len(state.units)} units done, {len(state.failed)} failed, "
        f"{missing - len(state.failed)} not finished; {tries} tries repeated"
    )
    yield f"time {span(elapsed)} in this run; {span(seconds)} of povray in all"

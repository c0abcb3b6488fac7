# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Renders a task's units in turn and joins finished pictures. POV-Ray dies with its worker, and its state file is continued."""

import contextlib
import fcntl
import os
import pathlib
import signal
import subprocess
import sys
import time

from tools.batch import key as keys, merge, povray
from tools.batch.plan import unit_name
from tools.batch.store import BatchError, Work, little_room, locked, read_json, sha256, sync_file, sync_folder, write_json


class Changed(BatchError):
    """An input has changed since the batch was planned; another try cannot help."""


def stamps_before(description, folder):
    files = set(description["key"]["files"])
    with contextlib.suppress(BatchError):
        files |= keys.listed_files(folder / "files", keys.Links(description["links"]))[0]
    return keys.change_stamps(files)


def check_inputs(description, folder, before, started):
    """Returns files read in addition to the key's. Raises an error if one has changed since `before`, stamps_before() the render."""
    known, stamps = description["key"]["files"], description["stamps"]
    links = keys.Links(description["links"])
    read, missing = keys.listed_files(folder / "files", links)
    extra = {}
    for path in sorted(read):
        found = known.get(path) if stamps.get(path) == keys.file_stamp(path) else sha256(path)
        if path in known and found != known[path]:
            raise Changed(f"file {path!r} has changed since the batch began.")
        if path in description["key"]["missing"]:
            raise Changed(f"file {path!r} appeared since the batch began.")
        if keys.changed_since(path, before, started):
            raise BatchError(f"file {path!r} was written while it was being read.")
        if path not in known:
            extra[path] = found
    gone = sorted(missing & known.keys())
    if gone:
        raise Changed(f"file {gone[0]!r} was there when the batch began, and is not now.")
    return extra, sorted(missing - set(description["key"]["missing"]))


class Unit:
    def __init__(self, work, description, number, log):
        key = description["key"]
        self.work, self.description, self.log = work, description, log
        self.name = unit_name(number, len(key["bands"]))
        self.picture = key["pictures"][number // len(key["bands"])]
        self.rows = key["bands"][number % len(key["bands"])]
        self.folder = work.unit(self.name)
        self.begins = os.path.getsize(log) if os.path.exists(log) else 0
        self.process = None

    def say(self, text):
        with open(self.log, "a", encoding="utf-8", errors="surrogateescape") as stream:
            stream.write(f"--- {time.strftime('%H:%M:%S')} unit {self.name}: {text}\n")

    def place_in_log(self):
        return {"log": str(self.log), "begins": self.begins}

    def do(self):
        if self.work.record("done", self.name).exists():
            return True
        self.folder.mkdir(parents=True, exist_ok=True)
        with open(self.folder / "lock", "a", encoding="utf-8") as lock:
            fcntl.flock(lock, fcntl.LOCK_EX)
            if self.work.record("done", self.name).exists():
                return True
            tries = 1 + self.description["retries"]
            for attempt in range(1, tries + 1):
                reason, final = self.attempt(attempt, lock.fileno())
                if reason is None:
                    return True
                self.say(f"try {attempt} of {tries} failed: {reason}")
                if final:
                    break
                time.sleep(min(5.0, 0.5 * attempt))
            write_json(
                self.work.record("failed", self.name),
                {
                    "reason": reason,
                    "picture": self.picture["name"],
                    "rows": self.rows,
                    "ends": os.path.getsize(self.log),
                    **self.place_in_log(),
                },
            )
            return False

    def attempt(self, attempt, lock):
        """Returns None, or the reason of a failure and whether another try is in vain."""
        running = self.work.record("running", self.name)
        told = {"host": os.uname().nodename, "pid": os.getpid(), "try": attempt, "since": time.time()}
        write_json(running, {**told, **self.place_in_log()})
        try:
            return self.render(attempt, lock)
        except Changed as error:
            return str(error), True
        except (BatchError, OSError) as error:
            return str(error), False
        finally:
            with contextlib.suppress(OSError):
                running.unlink()

    def render(self, attempt, lock):
        povray.clear_output(self.folder)
        before = stamps_before(self.description, self.folder)
        with contextlib.suppress(FileNotFoundError):
            (self.folder / "files").unlink()
        goes_on = povray.prepare_state(self.folder)
        words = povray.arguments(self.description, self.picture, self.rows) + ["+C" if goes_on else "-C"]
        state = f"continued from {goes_on} bytes" if goes_on else "from the start"
        self.say(f"{self.picture['label']}, rows {self.rows[0]} to {self.rows[1]}, try {attempt}, {state}, on " f"{os.uname().nodename}")
        started = time.time()
        self.process = povray.start(self.description, self.folder, words, self.log, lock)
        limit = self.description["limit"]
        try:
            status = self.process.wait(timeout=limit)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()
            return f"povray was ended after {limit} s, as --limit says", True
        finally:
            self.process = None
        if status != 0:
            told = f"was ended by signal {-status}" if status < 0 else f"ended with exit code {status}"
            if goes_on and self.drop_state(status, goes_on):
                return f"povray {told} on its state file, which is dropped", False
            return f"povray {told}", status == 1
        extra, missing = check_inputs(self.description, self.folder, before, started)
        self.finish(extra, missing, attempt, time.time() - started)
        return None, False

    def drop_state(self, status, size):
        """True if the state file made POV-Ray crash. A file that has grown was readable; a kill or a full disk is not its fault."""
        path = povray.state_file(self.folder)
        blameless = -status in povray.KILLED or any(little_room(self.folder))
        if path is None or blameless or path.stat().st_size > size:
            return False
        path.unlink()
        return True

    def finish(self, extra, missing, attempt, seconds):
        size = self.description["key"]["size"]
        files = {}
        for rest, path in povray.outputs(self.folder).items():
            info = povray.image_info(path)
            if info["size"] != size:
                raise BatchError(f"{path.name} has {info['size']} pixels, expected {size}")
            sync_file(path)
            files[rest] = {"file": path.name, "bytes": path.stat().st_size, "sha256": sha256(path), **info}
        if "." + self.description["key"]["extension"] not in files:
            raise BatchError("povray ended well but wrote no picture")
        sync_folder(self.folder)
        write_json(
            self.work.record("done", self.name),
            {
                "files": files,
                "read": extra,
                "missing": missing,
                "seconds": seconds,
                "try": attempt,
                "host": os.uname().nodename,
                **self.place_in_log(),
            },
        )
        self.say(f"done in {seconds:.1f} s")


def end_when_asked(unit):
    """On SIGTERM or SIGINT, POV-Ray keeps its state file."""

    def end(number, _):
        if unit.process:
            with contextlib.suppress(ProcessLookupError):
                unit.process.send_signal(signal.SIGKILL)
        os._exit(128 + number)

    for number in (signal.SIGTERM, signal.SIGINT, signal.SIGHUP):
        signal.signal(number, end)


def run(folder, task):
    work = Work(pathlib.Path(folder))
    description = read_json(work.description)
    if description is None:
        sys.exit(f"batch task: cannot read {work.description}")
    povray.needed_programs()
    bands = len(description["key"]["bands"])
    for number in description["tasks"][task]:
        unit = Unit(work, description, number, work.log(task))
        end_when_asked(unit)
        if work.record("failed", unit.name).exists() or not unit.do():
            continue
        picture = number // bands
        if all(work.record("done", unit_name(picture * bands + b, bands)).exists() for b in range(bands)):
            try:
                with locked(work.units / f"{picture:05d}.lock"):
                    merge.merge_picture(work, description, picture)
            except (BatchError, OSError) as error:  # the batch's last step tries again
                unit.say(f"merging failed: {error}")
    return 0

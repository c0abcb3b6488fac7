# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Runs a command and measures resident memory over time, CPU time and elapsed time."""

import dataclasses
import os
import pathlib
import subprocess
import time

TICKS = os.sysconf("SC_CLK_TCK")


@dataclasses.dataclass
class Watched:
    returncode: int
    seconds: float  # elapsed
    cpu: float  # seconds, user and system
    peak: int  # peak resident memory, KiB
    course: list  # (elapsed seconds, processor seconds, resident KiB)
    said: str = ""


def resident(pid):
    """Resident memory in KiB, or None after the end."""
    try:
        for line in pathlib.Path(f"/proc/{pid}/status").read_text().splitlines():
            if line.startswith("VmRSS:"):
                return int(line.split()[1])
    except OSError:
        pass
    return None


def processor_seconds(pid):
    try:
        fields = pathlib.Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()
        return (int(fields[11]) + int(fields[12])) / TICKS
    except OSError:
        return None


def watch(command, log, interval=1.0, limit=None, on_sample=None, **how):
    """Runs the command with its output in the file `log`, measured every `interval` seconds, and ends it after `limit` seconds of processor
    time."""
    course = []
    begin = time.monotonic()
    with open(log, "wb") as out:
        process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=out, stderr=subprocess.STDOUT, **how)
        try:
            pid, status, usage = 0, 0, None
            next_sample = begin
            while pid == 0:
                pid, status, usage = os.wait4(process.pid, os.WNOHANG)
                now = time.monotonic()
                if pid == 0 and now >= next_sample:
                    next_sample += interval
                    memory, cpu = resident(process.pid), processor_seconds(process.pid)
                    if memory is not None and cpu is not None:
                        course.append((round(now - begin, 2), cpu, memory))
                        if on_sample:
                            on_sample(course[-1])
                if pid == 0 and limit is not None and course and course[-1][1] > limit:
                    process.kill()
                    limit = None
                if pid == 0:
                    time.sleep(min(0.05, interval))
            process.returncode = os.waitstatus_to_exitcode(status)
        except BaseException:
            process.kill()
            raise
    said = pathlib.Path(log).read_text(errors="replace")
    return Watched(process.returncode, time.monotonic() - begin, usage.ru_utime + usage.ru_stime, usage.ru_maxrss, course,
                   said)

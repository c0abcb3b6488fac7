# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Runs tasks as a Slurm job array, and a dependent job that finishes."""

import contextlib
import re
import shlex
import shutil
import subprocess
import sys
import time

from tools.batch.store import BatchError, read_json, write_json, write_text
from tools.repository import module_command

PATIENCE = 600  # seconds to wait for a silent controller
SCRIPT = """#!/bin/sh
# Written by batch; one task of the array, or the last step.
exec {program} {work} {argument}
"""


def check():
    for name in ("sbatch", "squeue", "scontrol", "sinfo"):
        if shutil.which(name) is None:
            raise BatchError(
                f"{name} is missing: --on slurm needs Slurm's commands on this machine (Debian package "
                "slurm-client) and the site's slurm.conf."
            )


def command(*words):
    try:
        done = subprocess.run(words, stdin=subprocess.DEVNULL, capture_output=True, timeout=120, check=False)
    except subprocess.TimeoutExpired:
        raise BatchError(f"{words[0]} gave no answer for 120 s.") from None
    if done.returncode != 0:
        raise BatchError(f"{words[0]} failed: {done.stderr.decode(errors='replace').strip()}")
    return done.stdout.decode(errors="replace").strip()


def largest_array():
    found = re.search(r"MaxArraySize\s*=\s*(\d+)", command("scontrol", "show", "config"))
    return int(found.group(1)) if found else 1001


def workers(settings, threads):
    if settings.workers:
        return settings.workers
    words = ["sinfo", "-h", "-o", "%C"] + ([f"--partition={settings.partition}"] if settings.partition else [])
    totals = [int(line.split("/")[3]) for line in command(*words).splitlines() if line.count("/") == 3]
    return max(1, sum(totals) // threads)


def site_options(settings):
    words = [f"--{name}={getattr(settings, name)}" for name in ("partition", "time", "account") if getattr(settings, name)]
    return words + settings.sbatch


def write_script(work, verb, argument):
    """The shell reads names from the script, because they may contain any characters."""
    path = work.folder / f"{verb}.sh"
    write_text(
        path,
        SCRIPT.format(program=shlex.join(module_command("tools.batch.batch", verb)), work=shlex.quote(str(work.folder)), argument=argument),
    )
    return path


def ranges(numbers):
    runs = []
    for n in numbers:
        if runs and runs[-1][1] == n - 1:
            runs[-1][1] = n
        else:
            runs.append([n, n])
    return ",".join(str(a) if a == b else f"{a}-{b}" for a, b in runs)


def log_name(work, name):
    """For sbatch's --output. A backslash disables the %-marks of a folder's name; all tasks then share a file."""
    folder = str(work.logs)
    if "\\" in folder:
        return folder.replace("\\", "\\\\") + "/slurm.out"
    return folder.replace("%", "%%") + "/" + name


def submit(work, description, tasks, settings):
    common = ["sbatch", "--parsable", "--open-mode=append", f"--chdir={work.folder}", *site_options(settings)]
    limit = f"%{settings.workers}" if settings.workers else ""
    array = command(
        *common,
        "--requeue",
        "--ntasks=1",
        f"--cpus-per-task={description['threads']}",
        f"--array={ranges(tasks)}{limit}",
        "--job-name=batch",
        f"--output={log_name(work, 'slurm-%a.out')}",
        str(write_script(work, "task", '"$SLURM_ARRAY_TASK_ID"')),
    ).split(";")[0]
    # afterany: a failed task must not stop the last step
    try:
        last = command(
            *common,
            "--ntasks=1",
            f"--dependency=afterany:{array}",
            "--job-name=batch-end",
            "--kill-on-invalid-dep=yes",
            f"--output={log_name(work, 'slurm-end.out')}",
            str(write_script(work, "finish", "")),
        ).split(";")[0]
    except BatchError:
        command("scancel", array)
        raise
    write_json(work.folder / "jobs.json", [array, last])
    return [array, last]


def alive(jobs):
    """Slurm forgets jobs that have ended."""
    listed = command("squeue", "--noheader", "--me", "--format=%A %F")
    known = {number for line in listed.splitlines() for number in line.split()}
    return [job for job in jobs if job in known]


def active_jobs(work):
    jobs = read_json(work.folder / "jobs.json")
    return alive(jobs) if jobs and shutil.which("squeue") else []


def cancelled(jobs):
    found = []
    for job in jobs:
        with contextlib.suppress(BatchError):
            if "JobState=CANCELLED" in command("scontrol", "--oneliner", "show", "job", job):
                found.append(job)
    return found


@contextlib.contextmanager
def interrupted_alone(jobs):
    try:
        yield
    except KeyboardInterrupt:
        print(f"\nThe jobs go on. To end them: scancel {' '.join(jobs)}", file=sys.stderr)
        raise


def wait(jobs, progress):
    """Raises an error if the jobs were cancelled."""
    wait_for_end(jobs, progress)
    gone = cancelled(jobs)
    if gone:
        raise BatchError(f"the jobs {' '.join(gone)} were cancelled. The same command submits what is missing.")


def wait_for_end(jobs, progress):
    pause, silent_since = 0.5, None
    while True:
        try:
            if not alive(jobs):
                return
            silent_since = None
        except BatchError as error:
            silent_since = silent_since or time.monotonic()
            if time.monotonic() - silent_since > PATIENCE:
                raise BatchError(
                    f"Slurm has not answered for {PATIENCE} s ({error}). The jobs {' '.join(jobs)} may still "
                    "run: call again later to go on."
                ) from None
        progress.show()
        time.sleep(pause)
        pause = min(5.0, pause * 1.2)


def run(work, description, tasks, settings, progress):
    jobs = submit(work, description, tasks, settings)
    with interrupted_alone(jobs):
        print(f"jobs {' '.join(jobs)} submitted ({len(tasks)} tasks, then the last step)", file=sys.stderr)
        if settings.detach:
            print("Not waiting for them. Call again with the same arguments to watch, or to go on with what is missing.", file=sys.stderr)
            return
        wait(jobs, progress)

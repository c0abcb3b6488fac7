# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Runs tasks with GNU parallel, one worker per core."""

import os
import shutil
import signal
import subprocess
import sys
import time

from tools.batch import povray
from tools.batch.store import BatchError
from tools.repository import LAUNCHER


def workers(settings, threads):
    return settings.workers or max(1, len(os.sched_getaffinity(0)) // threads)


def check():
    if shutil.which("parallel") is None:
        raise BatchError("GNU parallel is missing (Debian package parallel).")


def invocation(work, description, settings):
    count = workers(settings, description["threads"])
    # exec makes parallel the worker's parent; the environment passes names with any characters
    command = [
        "parallel",
        "--plain",  # ignores ~/.parallel/config
        "--will-cite",
        "--no-notice",
        f"-j{count}",
        "--retries",
        str(1 + settings.retries),
        "--halt",
        "never",
        'exec setpriv --pdeathsig KILL "$BATCH_PYTHON" -B "$BATCH_LAUNCHER" tools.batch.batch task "$BATCH_WORK" {}',
    ]
    env = dict(
        os.environ,
        BATCH_PYTHON=sys.executable,
        BATCH_LAUNCHER=str(LAUNCHER),
        BATCH_WORK=str(work.folder),
        PARALLEL_SHELL="/bin/sh",
        SHELL="/bin/sh",
    )
    env.pop("PARALLEL", None)
    return command, env


def run(work, description, tasks, settings, progress):
    """Every process dies with its parent, so that Ctrl-C leaves none."""
    command, env = invocation(work, description, settings)
    with open(work.logs / "parallel.log", "ab") as log:
        process = subprocess.Popen(
            povray.ending_with_parent(command), stdin=subprocess.PIPE, stdout=log, stderr=log, env=env, start_new_session=True
        )
        try:
            process.stdin.write("".join(f"{task}\n" for task in tasks).encode())
            process.stdin.close()
            while process.poll() is None:
                progress.show()
                time.sleep(0.2)
        except BaseException:
            end(process)
            raise


def end(process):
    process.send_signal(signal.SIGKILL)
    process.wait()
    time.sleep(0.3)

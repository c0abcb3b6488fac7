# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later

import os
import re
import subprocess

LIMIT = 300  # seconds


def measure(setup):
    cores = len(os.sched_getaffinity(0))
    done = subprocess.run(["ctest", "-L", "stress|fuzz", "-j", str(cores)], cwd=setup.build, capture_output=True, text=True, check=False)
    counts = re.search(r"(\d+) tests failed out of (\d+)", done.stdout)
    seconds = re.search(r"Total Test time \(real\) = +([\d.]+)", done.stdout)
    if not counts or not seconds:
        raise RuntimeError(done.stdout[-800:] + done.stderr[-800:])
    failed = re.findall(r"^\s+\d+ - (\S+) \(", done.stdout, re.MULTILINE)
    return {"tests": int(counts[2]), "failed": failed, "seconds": round(float(seconds[1])), "cores": cores}


def faults(result):
    found = [f"short form: {name} fails" for name in result["failed"]]
    if not result["tests"] or result["seconds"] > LIMIT:
        found.append(f"short form: {result['tests']} tests take {result['seconds']} s")
    return found

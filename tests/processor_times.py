# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Prints the processor time of each test: python3 -m tests.processor_times [OPTION OF CTEST...].

Tests of more than 15 s belong to slow_tests() in tests/CMakeLists.txt.
"""

import contextlib
import ctypes
import json
import os
import subprocess
import sys
import time

from tools.repository import BUILD

LIMIT = 15  # seconds
PR_SET_CHILD_SUBREAPER = 36  # of prctl()


def tests(options):
    told = subprocess.run(["ctest", "--show-only=json-v1", *options], cwd=BUILD, capture_output=True, check=True).stdout
    for test in json.loads(told)["tests"]:
        properties = {entry["name"]: entry["value"] for entry in test.get("properties", ())}
        environment = dict(setting.split("=", 1) for setting in properties.get("ENVIRONMENT", ()))
        yield test["name"], test["command"], environment, properties.get("WORKING_DIRECTORY", BUILD), properties.get("LABELS", ())


def wait_for_orphans():
    """Processes that outlive a test become our children, so that their time counts."""
    end = time.monotonic() + 10
    with contextlib.suppress(ChildProcessError):
        while time.monotonic() < end:
            if os.waitpid(-1, os.WNOHANG)[0] == 0:
                time.sleep(0.05)


def main():
    ctypes.CDLL(None).prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0)
    for name, command, environment, folder, labels in tests(sys.argv[1:]):
        before, begin = os.times(), time.monotonic()
        done = subprocess.run(
            command, cwd=folder, env={**os.environ, **environment}, stdin=subprocess.DEVNULL, capture_output=True, check=False
        )
        seconds_in_all = time.monotonic() - begin
        wait_for_orphans()
        after = os.times()
        seconds = after.children_user + after.children_system - before.children_user - before.children_system
        remarks = ["failed"] if done.returncode else []
        if seconds > LIMIT and "slow" not in labels:
            remarks.append("not among the slow tests")
        print(f"{seconds:8.1f} s of processor time, {seconds_in_all:8.1f} s in all  {name}  {', '.join(remarks)}", flush=True)


if __name__ == "__main__":
    main()

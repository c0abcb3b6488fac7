# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Measures and writes docs/numerics.md: python3 -m tests.stress.run [PART...], all parts without one.

A part without faults is kept in docs/numerics/PART.json. Interrupted parts continue. `--page` only writes the page; `--quick` measures
small sizes and keeps nothing."""

import argparse
import dataclasses
import importlib
import pathlib
import shutil
import sys
import tempfile

from tests.stress import page, results
from tools.repository import BUILD

PARTS = ("rays", "sampler", "pictures", "sanitizers", "fuzz", "faults", "soak", "scale", "shortly")
# programs and their Debian packages
TOOLS = {"sanitizers": "valgrind"}
QUICK = {
    "rays": {"cameras": 20_000, "extreme": 1000, "shard": 10_000},
    "sampler": {"log2_samples": 12},
    "pictures": {"cameras": 40, "few": 1, "pictures": 4, "samples": 128},
    "fuzz": {"count": 1000, "runs": 20_000},
    "faults": {"kills": 3},
    "soak": {"frames": (10, 20), "rows": (384, 1536)},
    "scale": {"size": "quick"},
}


def quickly(setup, names):
    broken = []
    with tempfile.TemporaryDirectory(prefix="tilt_lens.") as folder:
        setup = dataclasses.replace(setup, unfinished=pathlib.Path(folder))
        for name in names:
            part = importlib.import_module(f"tests.stress.{name}")
            broken += [f"{name}: {fault}" for fault in part.faults(part.measure(setup, **QUICK[name]))]
    return broken


def at_length(setup, names):
    broken = []
    for name in names:
        part = importlib.import_module(f"tests.stress.{name}")
        result = part.measure(setup)
        found = part.faults(result)
        if not found:
            results.save(name, result)
        broken += [f"{name}: {fault}" for fault in found]
    return broken


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("parts", nargs="*", metavar="PART", help=", ".join(PARTS))
    parser.add_argument("--build", type=pathlib.Path, default=BUILD, help="the release build with its tests")
    parser.add_argument("--jobs", type=int, default=2, help="programs at a time")
    parser.add_argument("--page", action="store_true", help="make the page from kept results")
    parser.add_argument("--quick", action="store_true", help="small sizes; fails if a limit is exceeded; keeps nothing")
    settings = parser.parse_args()
    unknown = sorted(set(settings.parts) - set(PARTS))
    if unknown:
        parser.error(f"no part {unknown[0]}; there are {', '.join(PARTS)}")
    names = settings.parts or [part for part in PARTS if not settings.quick or part in QUICK]
    missing = [tool for part, tool in TOOLS.items() if part in names and not shutil.which(tool)]
    if missing and not (settings.quick or settings.page):
        parser.error(f"missing: apt-get install {' '.join(missing)}")
    setup = results.Setup(settings.build.resolve(), settings.jobs)
    if settings.quick:
        broken = quickly(setup, names)
    else:
        broken = [] if settings.page else at_length(setup, names)
        page.write()
    if broken:
        sys.exit("\n".join(broken))


if __name__ == "__main__":
    main()

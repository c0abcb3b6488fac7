#!/usr/bin/env python3
# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The seed paper's experiments: renders, measures, fails where a number leaves its tolerance."""

import argparse
import importlib
import pathlib
import re
import shutil
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import figures  # noqa: E402
from common import REPOSITORY, Failed, Laboratory  # noqa: E402

# Name, module, function; in the order of docs/paper.md.
EXPERIMENTS = [
    ("equation", "equation", "table"),
    ("dragons", "figures", "dragons"),
    ("box", "figures", "box"),
    ("table1", "box", "table_1"),
    ("landscape", "figures", "landscape"),
    ("spots", "blur", "spots"),
    ("plane", "blur", "plane"),
    ("hinge", "blur", "hinge"),
    ("tower", "shift", "tower"),
    ("tilt_with_shift", "shift", "tilt_with_shift"),
    ("real_lenses", "real_lenses", "table"),
    ("glass", "glass", "compare"),
]


def run(lab, name, module, function):
    """One experiment; its failures in words."""
    started, failures = time.monotonic(), []
    print(f"== {name}", flush=True)
    try:
        for claim in getattr(importlib.import_module(module), function)(lab):
            print("   " + claim.line(), flush=True)
            if not claim.holds:
                failures.append(f"{name}: {claim.line()}")
    except Failed as trouble:
        print(f"   FAIL {trouble}", flush=True)
        failures.append(f"{name}: {str(trouble).splitlines()[0]}")
    print(f"   {time.monotonic() - started:.0f} s", flush=True)
    return failures


def update_docs(lab):
    """Pictures, curves and tables of this run become those of docs/paper.md."""
    folder = REPOSITORY / "docs" / "pictures" / "paper"
    folder.mkdir(parents=True, exist_ok=True)
    made = [lab.work / f"{name}.png" for names, _ in figures.PICTURES.values() for name in names]
    made += [*lab.results.glob("profile_*.svg"), *lab.results.glob("*.csv")]
    # curves' own tables are as long as pictures are wide; the documents show the plots
    for path in made:
        if path.is_file() and not re.match(r"(profile|glass)_._.*\.csv", path.name):
            shutil.copyfile(path, folder / path.name)


def main():
    build = REPOSITORY / "build"
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("names", nargs="*", metavar="EXPERIMENT",
                        help="all if none; of " + ", ".join(name for name, *_ in EXPERIMENTS))
    parser.add_argument("--quick", action="store_true", help="small pictures, the fast claims only")
    parser.add_argument("--povray", type=pathlib.Path, default=build / "bin" / "povray")
    parser.add_argument("--stock", type=pathlib.Path, default="/usr/bin/povray",
                        help="the unpatched program")
    parser.add_argument("--tools", type=pathlib.Path, default=build, help="build folder")
    parser.add_argument("--work", type=pathlib.Path, default=build / "experiments")
    parser.add_argument("--results", type=pathlib.Path,
                        help="curves and tables; default: in --work")
    parser.add_argument("--update-docs", action="store_true",
                        help="copy what was made to docs/pictures/paper")
    parser.add_argument("--threads", type=int, default=2)
    args = parser.parse_args()
    unknown = set(args.names) - {name for name, *_ in EXPERIMENTS}
    if unknown:
        parser.error("no such experiment: " + ", ".join(sorted(unknown)))
    work = args.work.resolve()
    results = args.results.resolve() if args.results else work / "results"
    lab = Laboratory(args.povray.resolve(), args.stock.resolve(), args.tools.resolve(), work,
                     results, args.quick, args.threads)
    failures = []
    for name, module, function in EXPERIMENTS:
        if not args.names or name in args.names:
            failures += run(lab, name, module, function)
    if args.update_docs:
        update_docs(lab)
    print("\n".join(["", f"{len(failures)} out of tolerance"] + failures if failures
                    else ["", "Everything is within its tolerance."]))
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The paper's experiments: renders, measures, and fails if a number is out of its tolerance."""

import argparse
import pathlib
import sys
import time

from experiments import blur, box, document, equation, figures, glass, real_lenses, shift
from experiments.laboratory import Laboratory
from tools.repository import BUILD

# in the order of docs/paper.md
EXPERIMENTS = [
    ("equation", equation.table),
    ("dragons", figures.dragons),
    ("box", figures.box),
    ("table1", box.table_1),
    ("landscape", figures.landscape),
    ("spots", blur.spots),
    ("plane", blur.plane),
    ("hinge", blur.hinge),
    ("tower", shift.tower),
    ("tilt_with_shift", shift.tilt_with_shift),
    ("real_lenses", real_lenses.table),
    ("glass", glass.compare),
]


def run(lab, name, function):
    started, failures, claims = time.monotonic(), [], []
    print(f"== {name}", flush=True)
    try:
        for claim in function(lab):
            print("   " + claim.line(), flush=True)
            claims.append([claim.text, float(claim.value), claim.unit, claim.allowed()])
            if not claim.holds:
                failures.append(f"{name}: {claim.line()}")
    except Exception as trouble:  # the others run in any case
        print(f"   FAIL {type(trouble).__name__}: {trouble}", flush=True)
        failures.append(f"{name}: {type(trouble).__name__}: {str(trouble).splitlines()[0]}")
    if not claims and not failures:
        failures.append(f"{name}: FAIL it claims nothing")
    lab.table("claims.csv", ["measured", "found", "unit", "limit"], claims)
    print(f"   {time.monotonic() - started:.0f} s", flush=True)
    return failures


def options():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("names", nargs="*", metavar="EXPERIMENT", help="all if none; of " + ", ".join(name for name, *_ in EXPERIMENTS))
    parser.add_argument("--quick", action="store_true", help="small pictures, the fast claims only")
    parser.add_argument("--povray", type=pathlib.Path, default=BUILD / "bin" / "povray")
    parser.add_argument("--stock", type=pathlib.Path, default="/usr/bin/povray", help="the unpatched program")
    parser.add_argument("--tools", type=pathlib.Path, default=BUILD, help="build folder")
    parser.add_argument(
        "--work",
        type=pathlib.Path,
        help="pictures, and results/EXPERIMENT; default: build/experiments/full or "
        "quick. Pictures of the same program and scene are kept from run to run",
    )
    parser.add_argument("--update-docs", action="store_true", help="where all holds, bring docs/paper.md and its pictures up to date")
    parser.add_argument("--check-docs", action="store_true", help="only tell whether docs/paper.md shows the stored tables")
    parser.add_argument("--threads", type=int, default=2)
    args = parser.parse_args()
    unknown = set(args.names) - {name for name, *_ in EXPERIMENTS}
    if unknown:
        parser.error("no such experiment: " + ", ".join(sorted(unknown)))
    if args.quick and args.update_docs:
        parser.error("--update-docs takes the full form, not --quick")
    if not args.work:
        args.work = BUILD / "experiments" / ("quick" if args.quick else "full")
    return args


def main():
    args = options()
    if args.check_docs:
        wrong = document.faults()
        print("\n".join(wrong) if wrong else "docs/paper.md shows the stored tables and pictures.")
        return 1 if wrong else 0
    work, failures, done = args.work.resolve(), [], []
    for name, function in EXPERIMENTS:
        if not args.names or name in args.names:
            lab = Laboratory(
                args.povray.resolve(), args.stock.resolve(), args.tools.resolve(), work, work / "results" / name, args.quick, args.threads
            )
            failures += run(lab, name, function)
            done.append(lab.results)
    if args.update_docs and not failures:
        document.update(done)
    print("\n".join(["", f"{len(failures)} out of tolerance"] + failures if failures else ["", "Everything is within its tolerance."]))
    if args.update_docs and failures:
        print("docs/paper.md was left as it is.")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Renders one picture with the fork and compares it with its reference. The exit code is one of pictures.OUTCOMES.

Faults are printed, and shown on a local page.
"""

import argparse
import pathlib
import shlex
import sys

from tests.tools import failure_page, manifest, pictures
from tools.repository import module_command


def arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("name", help="for example oracle/tilt or renders/table")
    parser.add_argument("--povray", required=True, help="the fork")
    parser.add_argument("--compare", required=True, help="the comparison program")
    parser.add_argument("--work", required=True, type=pathlib.Path, help="folder for the results")
    parser.add_argument("--references", type=pathlib.Path, default=manifest.FOLDER)
    parser.add_argument(
        "--declare", action="append", default=[], metavar="NAME=VALUE", help="changes the scene, to show that the comparison notices"
    )
    parser.add_argument("--expect", choices=pictures.OUTCOMES, default="same", help="the expected outcome; any other one fails")
    return parser.parse_args()


def check(entry, args, folder):
    record = manifest.load(args.references).get(entry.name)
    if record is None:
        raise pictures.Trouble("missing reference", f"MANIFEST.json has no entry {entry.name}")
    reference = args.references / record["file"]
    if not reference.is_file():
        raise pictures.Trouble("missing reference", f"there is no {reference}")
    if record["sources_sha256"] != entry.sources_sha256():
        changed = [path for path, value in entry.sources_sha256().items() if record["sources_sha256"].get(path) != value]
        raise pictures.Trouble("stale reference", "changed since the reference was made: " + (", ".join(changed) or "a file fewer"))
    pictures.render(entry.job(args.povray, args.declare), folder, entry.output)
    return pictures.compare(args.compare, folder / entry.output, reference, record["comparison"])


def report(entry, args, folder, trouble):
    folder.mkdir(parents=True, exist_ok=True)
    job = entry.job(args.povray, args.declare)
    rerun = f"cd {shlex.quote(str(folder))} && {shlex.join(pictures.command_of(job, entry.output))}"
    accept = module_command(
        "tests.tools.update_references", entry.name, "--povray", args.povray, "--compare", args.compare, "--reason", "WHY"
    )
    if entry.case:
        accept += ["--oracle", str(pathlib.Path(args.compare).with_name("oracle"))]
    commands = {"Render it again": rerun, "Accept the change": accept}
    reference = args.references / (entry.name + ".exr")
    page = failure_page.write(folder, entry.name, trouble, commands, folder / entry.output, reference, args.compare)
    print(f"{entry.name}: {trouble.outcome}: {trouble}\nsee {page}", file=sys.stderr)


def main():
    args = arguments()
    entry = manifest.entries().get(args.name)
    if entry is None:
        print(f"no picture is called {args.name}", file=sys.stderr)
        return pictures.OUTCOMES["failure"]
    folder = args.work / entry.name / ("_".join(args.declare).replace("=", "") or "as_is")
    try:
        figures = check(entry, args, folder.absolute())
        outcome = "same"
        print(
            f"{entry.name}: RMSE {figures['rmse']:.5f}, signed mean {figures['mean']:+.6f}, "
            f"largest local mean {figures['largest_local_mean']:.5f}"
        )
    except pictures.Trouble as trouble:
        outcome = trouble.outcome
        if outcome != args.expect:
            report(entry, args, folder.absolute(), trouble)
        else:
            print(f"{entry.name} {' '.join(args.declare)}: {outcome}, as expected: {trouble}")
    if outcome == args.expect:
        return 0
    if outcome == "same":
        print(f"{entry.name}: the comparison passed, but {args.expect!r} was expected", file=sys.stderr)
        return pictures.OUTCOMES["failure"]
    return pictures.OUTCOMES[outcome]


if __name__ == "__main__":
    sys.exit(main())

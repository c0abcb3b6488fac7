# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Runs POV-Ray on each case of a file, and compares its messages with the expected ones.

An expected error must be the only one and name file and line; the exit code is not zero, and there is no picture. Otherwise there must be a
picture."""

import argparse
import pathlib
import re
import sys
import tempfile

from tests.parse import cases_file
from tools import povray_run

PICTURE = "picture.png"
# POV-Ray breaks messages into lines of 79 characters, later ones indented.
KIND = r"((?:Parse |Possible |Render |Fatal )?(?:Error|Warning)): (.*)"
MESSAGE = re.compile(r"File '([^']*)' line (\d+): " + KIND)
PLACE = re.compile(r"File: (.*\S) +Line: (\d+)\n(?:File Context.*\n(?:.*\n)*?)?(?=" + KIND + ")")
PLACELESS = re.compile(KIND)


def messages_of(text):
    found = []
    for line in PLACE.sub(r"File '\1' line \2: ", re.sub(r"\n (?=\S)", " ", text)).split("\n"):
        match = MESSAGE.match(line)
        file, number = (match[1], int(match[2])) if match else (None, 0)
        match = match or PLACELESS.match(line)
        if match:
            kind, said = match.groups()[-2:]
            found.append(("error" if "Error" in kind else "warning", file, number, re.sub(r"\s+", " ", said).strip()))
    return found


def has_parts(text, parts):
    at = 0
    for part in parts:
        at = text.find(part, at)
        if at < 0:
            return False
        at += len(part)
    return True


def run(povray, case, folder, library):
    for name, text in case.files.items():
        (folder / name).write_text(text)
    return povray_run.run(povray_run.command(povray, cases_file.SCENE, PICTURE, (8, 6), "+WT1", *case.options, library=library), folder)


def compare_messages(case, found, kind):
    wanted = case.parts(kind)
    given = [message for message in found if message[0] == kind]
    if len(wanted) != len(given):
        yield f"{len(given)} {kind}s, expected {len(wanted)}"
    for parts in wanted:
        fits = [message for message in given if has_parts(message[3], parts)]
        if not fits:
            yield f"no {kind} with the parts: " + " | ".join(parts)
        elif not any(message[1:3] == case.place for message in fits):
            yield (f"the {kind} names {fits[0][1]} line {fits[0][2]}, " f"expected {case.place[0]} line {case.place[1]}")


def check(povray, case, library):
    with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
        folder = pathlib.Path(name)
        done = run(povray, case, folder, library)
        picture = (folder / PICTURE).exists()
    code, output = done.code, done.said
    found = messages_of(output)
    wrong = [*compare_messages(case, found, "error"), *compare_messages(case, found, "warning")]
    said = re.sub(r"\s+", " ", output)
    wrong += ["nowhere said: " + " | ".join(parts) for parts in case.parts("says") if not has_parts(said, parts)]
    refused = bool(case.parts("error"))
    if code is None:
        wrong.append(f"it did not end within {povray_run.PATIENCE} s")
    elif code < 0:
        wrong.append(f"it crashed: signal {-code}")
    elif refused != (code != 0):
        wrong.append(f"exit code {code}")
    if refused == picture:
        wrong.append("there is a picture" if picture else "there is no picture")
    if not wrong:
        return wrong, ""
    files = "".join(f"--- {file}\n{text}" for file, text in case.files.items())
    tail = output[output.find("[Parsing") :] if "[Parsing" in output else output[-1500:]
    return wrong, f"{' '.join(done.command)}\n{files}--- messages\n{tail.strip()[:1200]}\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("cases", type=pathlib.Path)
    parser.add_argument("--povray", required=True)
    parser.add_argument("--library", action="append", default=[], help="further folder of include files")
    parser.add_argument("--only", default="", help="cases whose name contains this")
    args = parser.parse_args()
    try:
        cases = [case for case in cases_file.read_cases(args.cases) if args.only in case.name]
    except (cases_file.BadCase, OSError) as error:
        sys.exit(f"{args.cases.name}: {error}")
    if not cases:
        sys.exit(f"{args.cases.name}: no case named {args.only}")
    failed = 0
    for case in cases:
        wrong, report = check(args.povray, case, args.library)
        if wrong:
            failed += 1
            print(f"FAILED {args.cases.stem}: {case.name}")
            print("".join(f"  {line}\n" for line in wrong) + report)
    print(f"{args.cases.stem}: {len(cases) - failed} of {len(cases)} cases as expected")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())

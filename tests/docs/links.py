# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Links of the pages are not broken, and commands name existing programs."""

import argparse
import os
import pathlib
import re
import shlex
import sys

from tools.docs import pages
from tools.repository import ROOT

PICTURES = (".jpg", ".png", ".svg", ".exr")
OWN = re.compile(r"(\./|(cmake|tests|experiments|benchmarks|scenes|tools|docs|editors)/)[\w./-]+$")


def check_links(path, text):
    for target in pages.links_of(text):
        if re.match(r"[a-z]+:", target):
            continue
        file, _, anchor = target.partition("#")
        other = (path.parent / file) if file else path
        if not other.exists():
            yield f"link to {target}: there is no such file"
        elif re.search(rb"/(tmp|home|root)/", other.read_bytes() if other.suffix in PICTURES else b""):
            yield f"link to {target}: the file contains the path of the folder where it was made; write it without metadata"
        elif anchor and other.suffix == ".md" and anchor not in pages.anchors_of(other.read_text()):
            yield f"link to {target}: no heading has that name"


def check_commands(text, name):
    for number, command in pages.commands_of(name, text):
        try:
            words = shlex.split(command)
        except ValueError:
            continue
        while words and re.match(r"\w+=", words[0]):
            words = words[1:]
        if words[:2] == ["python3", "-m"] and not (ROOT / f"{words[2].replace('.', '/')}.py").is_file():
            yield f"line {number}: '{command}' runs {words[2]}, which is not a module here"
        if words and OWN.match(words[0]):
            program = ROOT / words[0]
            if not program.is_file() or not os.access(program, os.X_OK):
                yield f"line {number}: '{command}' runs {words[0]}, which is not a program here"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("page", type=pathlib.Path, nargs="+")
    failed = False
    for page in parser.parse_args().page:
        path, text = page.resolve(), page.read_text()
        wrong = [*check_links(path, text), *check_commands(text, page.name)]
        for message in wrong:
            print(f"FAILED {page.name}: {message}")
        failed = failed or bool(wrong)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())

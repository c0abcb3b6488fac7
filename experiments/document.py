# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Writes docs/paper.md and docs/pictures/paper from a run. Its tables are those of the files:

<!-- table: spots/claims.csv -->
...the program replaces this text...
<!-- end of table -->
"""

import csv
import re
import shutil

from tools.repository import ROOT

TEXT = ROOT / "docs" / "paper.md"
PICTURES = ROOT / "docs" / "pictures" / "paper"
TABLE = re.compile(r"(<!-- table: (\S+) -->\n).*?(<!-- end of table -->)", re.DOTALL)
LINK = re.compile(r"\]\((pictures/paper/[^)]+)\)")


def cell(text):
    try:
        number = float(text)
    except ValueError:
        return text.replace("|", "/")
    return f"{number:.4g}" if number else "0"


def table(path):
    with path.open(newline="") as lines:
        rows = [[cell(text) for text in row] for row in csv.reader(lines)]
    rows.insert(1, ["---"] * len(rows[0]))
    return "".join("| " + " | ".join(row) + " |\n" for row in rows)


def written():
    return TABLE.sub(lambda found: found[1] + table(PICTURES / found[2]) + found[3], TEXT.read_text())


def update(folders):
    for folder in folders:
        target = PICTURES / folder.name
        shutil.rmtree(target, ignore_errors=True)
        target.mkdir(parents=True)
        for path in folder.iterdir():
            # curves' own tables are as long as pictures are wide
            if not re.match(r"profile_._.*\.csv", path.name):
                shutil.copyfile(path, target / path.name)
    TEXT.write_text(written())


def faults():
    found = [f"docs/{link} is missing" for link in LINK.findall(TEXT.read_text()) if not (TEXT.parent / link).is_file()]
    found += [f"docs/pictures/paper/{name} is missing" for _, name, _ in TABLE.findall(TEXT.read_text()) if not (PICTURES / name).is_file()]
    if not found and written() != TEXT.read_text():
        found.append("a table in docs/paper.md is not that of docs/pictures/paper; " "experiments/run --update-docs writes it")
    return found

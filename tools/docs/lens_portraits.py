# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Makes the portraits of docs/lenses.md, the same scene through each lens of scenes/include/lenses and an ideal one, and their table.

    python3 -m tools.docs.lens_portraits              all of them: some minutes
    python3 -m tools.docs.lens_portraits minolta_50   some
    python3 -m tools.docs.lens_portraits --table      only the table
"""

import argparse
import csv
import pathlib
import subprocess
import sys
import tempfile

from tools.docs import marked
from tools.docs.figures import render
from tools.repository import BUILD, ROOT

SCENE = ROOT / "tools" / "docs" / "scenes" / "portrait.pov"
LENSES = ROOT / "scenes" / "include" / "lenses" / "lenses.csv"
PAGE = ROOT / "docs" / "lenses.md"
PICTURES = ROOT / "docs" / "pictures" / "lenses"
SIZE = (270, 180)
SHAPES = ("open", "stopped", "swung")
PLACE = ("portraits: tools/docs/lens_portraits.py", "end of portraits")


def lenses():
    """{name: title}, in the scene's order."""
    with LENSES.open(encoding="utf-8") as table:
        rows = list(csv.DictReader(table))
    return {"ideal": "An ideal lens of 50 mm at f/1.4", **{pathlib.Path(row["file"]).stem: row["lens"] for row in rows}}


def make(povray, names):
    PICTURES.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
        folder = pathlib.Path(name)
        for number, lens in enumerate(lenses()):
            for shape, word in enumerate(SHAPES if lens in names else ()):
                render(povray, folder, SCENE, [f"Declare=Lens={number}", f"Declare=Shape={shape}"], SIZE, "portrait.png")
                subprocess.run(
                    [
                        "oiiotool",
                        folder / "portrait.png",
                        "--nosoftwareattrib",
                        "--compression",
                        "jpeg:88",
                        "-o",
                        PICTURES / f"{lens}_{word}.jpg",
                    ],
                    check=True,
                )
            if lens in names:
                print(lens, flush=True)


def table():
    rows = ["| lens | wide open | f/8 | wide open, swung |", "| --- | --- | --- | --- |"]
    for name, title in lenses().items():
        cells = [f"![{title}, {word}](pictures/lenses/{name}_{word}.jpg)" for word in SHAPES]
        rows.append(f"| {title} | {' | '.join(cells)} |")
    return "\n".join(rows) + "\n"


def page():
    return marked.filled(PAGE, *PLACE, table())


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="*", help="some lenses, as their files are named; without: all")
    parser.add_argument("--table", action="store_true", help="only write the table")
    parser.add_argument("--povray", default=str(BUILD / "bin" / "povray"))
    args = parser.parse_args()
    unknown = set(args.names) - set(lenses())
    if unknown:
        sys.exit(f"no such lens: {', '.join(sorted(unknown))}. Known: {', '.join(lenses())}")
    if not args.table:
        make(str(pathlib.Path(args.povray).resolve()), args.names or list(lenses()))
    PAGE.write_text(page(), encoding="utf-8")


if __name__ == "__main__":
    main()

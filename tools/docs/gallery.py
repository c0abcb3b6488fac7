# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Renders the gallery at full size and makes the thumbnails and the table of docs/gallery.md from it.

    python3 -m tools.docs.gallery                       all of them
    python3 -m tools.docs.gallery chess_by_swing        one
    python3 -m tools.docs.gallery --small               thumbnails only, in a seventh of the time.

Size and options of a picture are those of the command in the scene's opening comment. The full pictures stay in the output folder. With
--small, the table has the thumbnails' size.
"""

import argparse
import csv
import dataclasses
import os
import pathlib
import re
import subprocess
import sys

from tools import povray_run
from tools.docs import marked
from tools.repository import BUILD, ROOT

SCENES = ROOT / "scenes/gallery"
THUMBNAILS = ROOT / "docs/pictures/gallery"
PAGE = ROOT / "docs/gallery.md"
TABLE = THUMBNAILS / "times.csv"
WIDTH = 480
LARGEST = 60_000  # bytes of a thumbnail
COLUMNS = ["scene", "width", "height", "cpu_seconds", "samples_per_pixel", "standard_error"]


@dataclasses.dataclass
class Scene:
    name: str
    options: list

    @property
    def path(self):
        return SCENES / f"{self.name}.pov"

    @property
    def size(self):
        return tuple(next(int(option[2:]) for option in self.options if option.startswith(letter)) for letter in ("+W", "+H"))


def read_scene(path):
    command = re.search(rf"^//\s+\./render scenes/gallery/{path.stem}\.pov((?: \S+)*)$", path.read_text(), re.MULTILINE)
    options = command.group(1).split() if command else []
    if not any(option.startswith("+W") for option in options):
        sys.exit(f'{path}: its opening comment has no line "//   ./render scenes/gallery/{path.name} +W... +H..."')
    return Scene(path.stem, options)


def all_scenes():
    return {path.stem: read_scene(path) for path in sorted(SCENES.glob("*.pov"))}


def small(scene):
    width, height = scene.size
    return [f"+W{WIDTH}", f"+H{height * WIDTH // width}"]


def number(pattern, text, what):
    found = re.search(pattern, text)
    if not found:
        sys.exit(f"povray did not report {what}:\n{text[-1500:]}")
    return found.groups()


def render(scene, arguments):
    picture = arguments.output / f"{scene.name}{'_small' if arguments.small else ''}.png"
    command = povray_run.command(
        arguments.povray,
        scene.path,
        picture,
        scene.size,
        "+FN8",
        *scene.options,
        *(small(scene) if arguments.small else []),
        *arguments.option,
        library=[povray_run.INCLUDE],
    )
    done = povray_run.run(command, limit=None).succeeded()
    row = [
        scene.name,
        *number(r"Image Resolution\D*(\d+) x (\d+)", done.said, "the picture's size"),
        f"{done.cpu:.0f}",
        *number(r"Samples per pixel\.+mean ([\d.]+)", done.said, "the samples"),
        *number(r"Standard error\.+([\d.e-]+)", done.said, "the standard error"),
    ]
    return picture, dict(zip(COLUMNS, row))


def make_thumbnail(picture, scene):
    """In the best quality that keeps it small."""
    thumbnail = THUMBNAILS / f"{scene.name}.jpg"
    for quality in range(92, 40, -4):
        subprocess.run(
            [
                "oiiotool",
                str(picture),
                "--ch",
                "R,G,B",
                "--resize:filter=lanczos3",
                f"{WIDTH}x0",
                "--nosoftwareattrib",
                "--compression",
                f"jpeg:{quality}",
                "-o",
                str(thumbnail),
            ],
            check=True,
        )
        if thumbnail.stat().st_size < LARGEST:
            return thumbnail
    sys.exit(f"{thumbnail} is larger than {LARGEST} bytes at the lowest quality")


def read_table():
    if not TABLE.exists():
        return {}
    with TABLE.open(newline="") as file:
        return {row["scene"]: row for row in csv.DictReader(file)}


def write_table(rows):
    with TABLE.open("w", newline="") as file:
        writer = csv.DictWriter(file, COLUMNS, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows[name] for name in sorted(rows))
    lines = ["| picture | size | CPU s | samples per pixel | standard error |", "| --- | --- | --- | --- | --- |"]
    lines += [
        f"| [{row['scene']}](../scenes/gallery/{row['scene']}.pov) | {row['width']} x {row['height']} | "
        f"{row['cpu_seconds']} | {row['samples_per_pixel']} | {row['standard_error']} |"
        for _, row in sorted(rows.items())
    ]
    PAGE.write_text(marked.filled(PAGE, "table", "end of table", "\n".join(lines) + "\n"))


def main():
    scenes = all_scenes()
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scene", nargs="*", help="names of scenes; all without")
    parser.add_argument("--povray", default=str(BUILD / "bin/povray"))
    parser.add_argument(
        "--output", type=pathlib.Path, default=BUILD / "gallery", help="folder of the full pictures (default: build/gallery)"
    )
    parser.add_argument("--small", action="store_true", help="thumbnails only, rendered in their own size")
    parser.add_argument("--option", action="append", default=[], help="one more option for povray, such as --option=+WT1")
    arguments = parser.parse_args()
    unknown = [name for name in arguments.scene if name not in scenes]
    if unknown:
        sys.exit(f"no such scene: {', '.join(unknown)}. There are: {', '.join(scenes)}")
    if not os.access(arguments.povray, os.X_OK):
        sys.exit(f"{arguments.povray} is not a program: run ./render once to build it, or give another one with --povray")
    arguments.output.mkdir(parents=True, exist_ok=True)
    THUMBNAILS.mkdir(parents=True, exist_ok=True)
    for name in arguments.scene or scenes:
        try:
            picture, row = render(scenes[name], arguments)
        except povray_run.Failed as error:
            sys.exit(str(error))
        thumbnail = make_thumbnail(picture, scenes[name])
        write_table({**read_table(), name: row})
        print(f"{name}: {row['cpu_seconds']} CPU seconds; {picture}, {thumbnail}", flush=True)


if __name__ == "__main__":
    main()

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Makes the pictures of docs/manual.md from the scenes in it, its table of qualities, its report, and the drawings of docs/optics.md.

    python3 -m tools.docs.figures                     everything: some minutes
    python3 -m tools.docs.figures pictures tilt_8     some of the pictures
    python3 -m tools.docs.figures drawings            needs gnuplot (Debian: gnuplot-nox)
    python3 -m tools.docs.figures quality             the table
    python3 -m tools.docs.figures report              what the program says after a render

Needs oiiotool (Debian: openimageio-tools).
"""

import argparse
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile

from tools import povray_run
from tools.docs import marked, pages
from tools.repository import BUILD, ROOT

MANUAL = ROOT / "docs" / "manual.md"
PICTURES = ROOT / "docs" / "pictures" / "manual"
DRAWINGS = ROOT / "docs" / "pictures" / "optics"
SCRIPTS = ROOT / "tools" / "docs" / "drawings"
SMALL, WIDE = (256, 144), (480, 270)


def variants(stem, scene, variable, values, size=SMALL):
    """{name: (scene, options, size)} for several values of a variable."""
    return {f"{stem}_{name}": (scene, [f"Declare={variable}={value}"], size) for name, value in values.items()}


def same(values):
    return {str(value): value for value in values}


MADE = {
    **variants("tilt", "tilt.pov", "Tilt", same((-8, 0, 8))),
    **variants("swing", "swing.pov", "Swing", same((-8, 8))),
    **variants("focus_tilt", "focus_tilt.pov", "Turn", {"-37": -36.9, "53": 53.1}),
    "wall": ("wall.pov", [], WIDE),
    "points": ("points.pov", [], WIDE),
    **variants("sharp", "sharp_points.pov", "Tilted", same((0, 1))),
    **variants("focus_on", "focus_on.pov", "Chosen", same((0, 1, 2))),
    **variants("shift", "shift.pov", "Right", same((-8, 0, 8))),
    **variants("film", "film_width.pov", "Film", same((36, 18))),
    **variants("focal", "focal_length.pov", "Focal", same((24, 50, 90))),
    **variants("unit", "scene_unit.pov", "Unit", same((5, 10, 100))),
    **variants("stop", "f_stop.pov", "Stop", same((0.7, 1.4, 5.6))),
    **variants("lights", "lights.pov", "Shape", same((0, 1, 2, 3, 4, 5, 6, 7))),
    **variants("tiles", "wall_of_tiles.pov", "Shape", same((0, 1, 2, 3, 4, 5, 6))),
    **variants("glass", "glass.pov", "Glass", same((0, 1)), WIDE),
    **variants("denoise", "denoise.pov", "Denoise", same((0, 1))),
    **variants("aids", "aids.pov", "Aid", same((1, 2, 3))),
    **{f"layers_{name}": ("aids.pov", ["Declare=Aid=0", "+N"], SMALL) for name in ("depth", "blur", "samples")},
    "miniature": ("miniature.pov", [], WIDE),
    **variants("table", "table.pov", "Tilted", same((0, 1)), WIDE),
    "facade_turned": ("facade.pov", ["Declare=Shifted=0", "+A0.05"], WIDE),
    "facade_shifted": ("facade.pov", ["Declare=Shifted=1", "+A0.05"], WIDE),
    "photograph": ("photograph.pov", [], (450, 300)),
}
ANTIALIASED = {"shift.pov"}  # no aperture, hence one ray per pixel
REPORTED = ROOT / "scenes" / "gallery" / "watch_on_table.pov"
QUALITY = ("quality table: tools/docs/figures.py quality", "end of the quality table")
REPORT = ("report: tools/docs/figures.py report", "end of the report")


def scenes(folder):
    text = MANUAL.read_text()
    for example in pages.examples_of(pages.blocks_of(MANUAL.name, text)):
        if example.name:
            (folder / example.name).write_text(example.block.text)


def layer_commands():
    """{picture: words} of the layers of board.png."""
    lines = re.findall(r"^    (oiiotool board\.layers\.exr .* -o (\w+)\.png)$", MANUAL.read_text(), re.MULTILINE)
    return {name: shlex.split(line) for line, name in lines}


def render(povray, folder, scene, options, size, output):
    try:
        command = povray_run.command(povray, scene, output, size, *options, library=[povray_run.INCLUDE])
        return povray_run.run(command, folder, limit=None).succeeded().said
    except povray_run.Failed as error:
        sys.exit(str(error))


def write(place, text):
    MANUAL.write_text(marked.filled(MANUAL, *place, text + "\n"))
    print(text)


def make_pictures(povray, names):
    unknown = set(names) - set(MADE)
    if unknown:
        sys.exit(f"no such picture: {', '.join(sorted(unknown))}. Known: {', '.join(MADE)}")
    PICTURES.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
        folder = pathlib.Path(name)
        scenes(folder)
        for picture in names or MADE:
            scene, options, size = MADE[picture]
            smooth = ["+A0.05"] if scene in ANTIALIASED else []
            render(povray, folder, scene, [*options, *smooth], size, "board.png")
            shown = folder / "board.png"
            if picture.startswith("layers_"):
                shown = folder / f"{picture.removeprefix('layers_')}.png"
                subprocess.run(layer_commands()[shown.stem], cwd=folder, check=True)
            subprocess.run(
                ["oiiotool", str(shown), "--nosoftwareattrib", "--compression", "jpeg:88", "-o", str(PICTURES / f"{picture}.jpg")],
                check=True,
            )
            print(picture, flush=True)


def quality_table(povray):
    rows = ["| `Declare=Step=` | samples per pixel: mean, 99%, most | `Standard error` | CPU time, relative |", "| --- | --- | --- | --- |"]
    first = 0.0
    with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
        scenes(pathlib.Path(name))
        for step in (1, 2, 3):
            said = render(povray, name, "quality.pov", [f"Declare=Step={step}", "+WT1"], (320, 180), "picture.png")
            samples = re.search(r"Samples per pixel\.+mean ([\d.]+), 99% (\d+), most (\d+)", said)
            error = re.search(r"Standard error\.+([\d.]+)", said)
            time = re.search(r"Trace Time:.*\n\s*using 1 thread\(s\) with ([\d.]+) CPU", said)
            first = first or float(time[1])
            rows.append(f"| {step} | {', '.join(samples.groups())} | {error[1]} | {float(time[1]) / first:.1f} |")
    write(QUALITY, "\n".join(rows))


def report(povray):
    with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
        said = render(povray, pathlib.Path(name), REPORTED, [], (320, 240), "picture.png")
    lines = re.search(r"^Tilt Lens Sampling\n(?: +\S.*\n)+", said, re.MULTILINE)[0]
    whole = re.sub(r"\n (?=\S)", " ", lines)  # the console breaks long lines
    write(REPORT, f"```text\n{whole}```")


def make_drawings(names, folder=DRAWINGS):
    if shutil.which("gnuplot") is None:
        sys.exit("gnuplot is missing: apt-get install gnuplot-nox")
    scripts = {script.stem: script for script in sorted(SCRIPTS.glob("*.gp")) if script.stem != "common"}
    unknown = set(names) - set(scripts)
    if unknown:
        sys.exit(f"no such drawing: {', '.join(sorted(unknown))}. Known: {', '.join(scripts)}")
    folder.mkdir(parents=True, exist_ok=True)
    for name in names or scripts:
        subprocess.run(["gnuplot", "-e", f"output='{folder / (name + '.svg')}'", scripts[name].name], cwd=SCRIPTS, check=True)
    return list(names or scripts)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("part", nargs="?", choices=["all", "pictures", "drawings", "quality", "report"], default="all")
    parser.add_argument("names", nargs="*", help="some pictures or drawings; without: all")
    parser.add_argument("--povray", default=str(BUILD / "bin" / "povray"))
    args = parser.parse_args()
    povray = str(pathlib.Path(args.povray).resolve())
    if args.part in ("all", "drawings"):
        print("\n".join(make_drawings(args.names)))
    if args.part in ("all", "pictures"):
        make_pictures(povray, args.names)
    if args.part in ("all", "quality"):
        quality_table(povray)
    if args.part in ("all", "report"):
        report(povray)


if __name__ == "__main__":
    main()

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The gallery's scenes render without a warning, and its page shows all of them.

gallery.py --povray POVRAY --compare COMPARE scene SCENE.pov
gallery.py --povray POVRAY --compare COMPARE page
"""

import argparse
import math
import pathlib
import re
import sys
import tempfile

from tests.render import rendering
from tools import povray_run
from tools.docs import gallery
from tools.repository import ROOT

LARGEST = 60_000  # bytes of a thumbnail
WIDTH, HEIGHT = 64, 36


def warnings(said):
    return [
        line for line in said.splitlines() if re.search(r"warning", line, re.IGNORECASE) and not line.strip().startswith("Warning Stream")
    ]


def check_scene(path, povray):
    with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
        folder = pathlib.Path(name)
        command = povray_run.command(povray, path, "picture.exr", (WIDTH, HEIGHT), "+FE", "Declare=Samples=4", library=[povray_run.INCLUDE])
        done = povray_run.run(command, folder)
        if done.code != 0:
            return [done.told()]
        faults = [f"it warns: {line}" for line in warnings(done.said)]
        taken = re.search(r"Samples per pixel\.+mean ([\d.]+)", done.said)
        if not taken or float(taken.group(1)) > 4:
            faults.append("Declare=Samples=4 does not limit the samples to 4 a pixel" + (f": {taken.group(1)} were taken" if taken else ""))
        picture = rendering.read_picture(folder / "picture.exr", " ".join(command))
    bad = sum(not math.isfinite(value) for value in picture.values)
    if bad:
        faults.append(f"{bad} values of the picture are not finite")
    light = [sum(picture.pixel(x, y)[:3]) for y in range(HEIGHT) for x in range(WIDTH)]
    mean = sum(light) / len(light)
    spread = math.sqrt(sum((value - mean) ** 2 for value in light) / len(light))
    if not spread > 0.05:
        faults.append(f"the picture is blank: its pixels spread by {spread:.3f} only")
    return faults


def plain(text):
    return " ".join(text.split())


def check_blocks(page):
    faults = []
    for block in re.finditer(r"^```\n(.*?)^```$", page, re.MULTILINE | re.DOTALL):
        names = re.findall(r"\./render scenes/gallery/(\w+)\.pov", page[: block.start()])
        scene = ROOT / f"scenes/gallery/{names[-1]}.pov"
        if not scene.is_file() or plain(block.group(1)) not in plain(scene.read_text()):
            faults.append(f"docs/gallery.md shows what is not in {scene.name}:\n{block.group(1)}")
    return faults


def check_page():
    scenes = gallery.all_scenes()
    page = (ROOT / "docs/gallery.md").read_text()
    rows = gallery.read_table()
    faults = [] if len(scenes) >= 9 else [f"only {len(scenes)} scenes"]
    for name, scene in scenes.items():
        thumbnail = gallery.THUMBNAILS / f"{name}.jpg"
        command = f"./render scenes/gallery/{name}.pov {' '.join(scene.options)}"
        if not thumbnail.is_file():
            faults.append(f"{thumbnail} is missing: run python3 -m tools.docs.gallery {name}")
        elif thumbnail.stat().st_size > LARGEST:
            faults.append(f"{thumbnail} has {thumbnail.stat().st_size} bytes, more than {LARGEST}")
        if f"(pictures/gallery/{name}.jpg)" not in page:
            faults.append(f"docs/gallery.md does not show pictures/gallery/{name}.jpg")
        if command not in page:
            faults.append(f"docs/gallery.md does not have the scene's own command: {command}")
        if name not in rows or f"| [{name}]" not in page:
            faults.append(f"the table of docs/gallery.md lacks {name}")
    faults += check_blocks(page)
    faults += [f"{path} belongs to no scene" for path in gallery.THUMBNAILS.glob("*.jpg") if path.stem not in scenes]
    return faults


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--povray", required=True)
    parser.add_argument("--compare", required=True)
    kinds = parser.add_subparsers(dest="kind", required=True)
    kinds.add_parser("scene").add_argument("path", type=pathlib.Path)
    kinds.add_parser("page")
    arguments = parser.parse_args()
    rendering.SETTINGS.compare = arguments.compare
    faults = check_page() if arguments.kind == "page" else check_scene(arguments.path.resolve(), arguments.povray)
    print("\n".join(faults) or "good")
    sys.exit(bool(faults))


if __name__ == "__main__":
    main()

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Makes the pictures of lamps in docs/sampling.md: an older program on the left, this one on the right, both with default settings.

python3 run_module.py benchmarks.lamp_crops --before PROGRAM [--ours PROGRAM]

Needs oiiotool (Debian: openimageio-tools)."""

import argparse
import pathlib
import subprocess
import tempfile

from benchmarks.found_lamps import FOLDER
from benchmarks.lab import TILT_LENS, Shot
from tools import povray_run
from tools.repository import BUILD, ROOT

PICTURES = ROOT / "docs" / "pictures" / "lamps"
SIZE = (320, 240)
CROPS = {  # settings of the scene, upper left corner
    "mirror": ((("Radius", 0.08),), (80, 40)),
    "textures": ((("Radius", 0.04),), (80, 80)),
    "balls": ((), (80, 80)),
    "stars": ((), (80, 80)),
}
CROP = (144, 96)
SCALE = 3


def render(program, scene, declare, picture):
    shot = Shot(scene, TILT_LENS, size=SIZE, folder=FOLDER, declare=declare)
    povray_run.run(shot.command(program, picture, "+FN16"), picture.parent, povray_run.environment(), limit=None).succeeded()


def make(programs, scene, folder):
    declare, (left, top) = CROPS[scene]
    (width, height), crops = CROP, []
    for number, program in enumerate(programs):
        picture = folder / f"{scene}_{number}.png"
        render(program, scene, declare, picture)
        crops += [str(picture), "--cut", f"{width}x{height}+{left}+{top}"]
    across, down = len(programs) * width * SCALE, height * SCALE
    looks = ["--mosaic:pad=2", f"{len(programs)}x1", "--resize:filter=box", f"{across}x{down}", "--nosoftwareattrib"]
    path = PICTURES / f"{scene}.jpg"
    subprocess.run(["oiiotool", *crops, *looks, "-d", "uint8", "--compression", "jpeg:88", "-o", str(path)], check=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--before", type=pathlib.Path, required=True)
    parser.add_argument("--ours", type=pathlib.Path, default=BUILD / "bin" / "povray")
    args = parser.parse_args()
    for program in (args.before, args.ours):
        if not program.is_file():
            parser.error(f"there is no program {program}")
    PICTURES.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
        for scene in CROPS:
            make([args.before.resolve(), args.ours.resolve()], scene, pathlib.Path(name))


if __name__ == "__main__":
    main()

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Makes the crops of docs/sampling.md: few rays a pixel without and with samples that serve other pixels.

python3 run_module.py benchmarks.spread_crops [--tools FOLDER]

Parts of gallery pictures of 1280 by 720 are recorded and replayed with the same rays (record_samples and replay_samples, built by `ninja
-C build ablation_tools`). Needs oiiotool (Debian: openimageio-tools)."""

import argparse
import pathlib
import subprocess
import tempfile

from tools import povray_run
from tools.repository import BUILD, ROOT

GALLERY = ROOT / "scenes" / "gallery"
PICTURES = ROOT / "docs" / "pictures" / "sampling"
PICTURE = (1280, 720)
SIZE = (144, 80)  # whole blocks
RECORDED = 256  # of each pixel; their mean is the last column
CROPS = {"miniature_town": (160, 560), "chess_by_swing": (896, 416)}  # upper left corners, whole blocks
RAYS = (2, 4)  # a pixel, of the rows
COLUMNS = ("spreadWeight=0", "")  # without and with
SCALE = 3


def record(tools, scene, corner, path):
    command = povray_run.command(
        tools / "record_samples",
        GALLERY / f"{scene}.pov",
        path.with_suffix(".png"),
        PICTURE,
        *povray_run.part(*corner, *SIZE),
        "-C",
        "-GA",
        "+WT1",
        "+FN",
        library=[GALLERY, povray_run.INCLUDE],
    )
    record = {"TILT_LENS_RECORD": str(path), "TILT_LENS_RECORD_SAMPLES": str(RECORDED), "TILT_LENS_SETTINGS": ""}
    povray_run.run(command, path.parent, povray_run.environment(**record), limit=None).succeeded()


def replay(tools, samples, rays, prefix):
    command = [
        tools / "replay_samples",
        samples,
        *SIZE,
        RECORDED,
        "--variances",
        1,
        "--denoise",
        1,
        "--least",
        rays,
        "--most",
        rays,
        "--picture",
        prefix,
    ]
    subprocess.run(
        [str(part) for part in command], check=True, capture_output=True, text=True, input="".join(f"{settings}\n" for settings in COLUMNS)
    )


def make(tools, scene, corner, folder):
    samples = folder / f"{scene}.samples"
    record(tools, scene, corner, samples)
    shown = []
    for rays in RAYS:
        replay(tools, samples, rays, folder / f"{scene}_{rays}_")
        shown += [folder / f"{scene}_{rays}_{column}.pfm" for column in (*range(len(COLUMNS)), "true")]
    across, down = SIZE[0] * SCALE, SIZE[1] * SCALE
    subprocess.run(
        [
            "oiiotool",
            *map(str, shown),
            "--clamp:min=0:max=1",
            "--mosaic:pad=2",
            f"{len(COLUMNS) + 1}x{len(RAYS)}",
            "--powc",
            str(1 / 2.2),
            "--resize:filter=box",
            f"{across*(len(COLUMNS) + 1)}x{down*len(RAYS)}",
            "--nosoftwareattrib",
            "--compression",
            "jpeg:88",
            "-o",
            str(PICTURES / f"spread_{scene}.jpg"),
        ],
        check=True,
    )


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--tools", type=pathlib.Path, default=BUILD / "tests" / "benchmarks" / "tools")
    tools = parser.parse_args().tools
    PICTURES.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
        for scene, corner in CROPS.items():
            make(tools, scene, corner, pathlib.Path(name))


if __name__ == "__main__":
    main()

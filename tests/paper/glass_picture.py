# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Compares `prescription` with the experiments' tracer: the box scene through the same double Gauss lens, tilted by 0, 4 or 8 degrees, at
f/8 or f/2.1, or focused by its first element.

The tracer takes the mean over passing rays, so the program's picture is divided by that of an even surface."""

import argparse
import dataclasses
import json
import math
import pathlib
import struct
import subprocess
import sys
import tempfile

from experiments import gauss
from experiments.box import EDGE_TOP, VIEW
from experiments.laboratory import SCENES
from experiments.lens import Lens
from tests.render import rendering

TILTS, STOPS = (0, 4, 8), (8, 2.1)
SAMPLES = {8: 1024, 2.1: 4096}  # of the tracer, per pixel: its noise must be small against the limits
SIZE = (42, 28)
RMSE, MEAN = 0.006, 0.0005
# least RMSE of a wrong lens; the wrong sign of the tilt gives 0.11
WRONG, WRONG_SIZE, WRONG_SAMPLES = 0.1, (60, 40), 512
# first element's movement (mm), and tilt; the wrong lens is focused at infinity
MOVED, MOVED_TILT = 2.0, 4


def scene(tilt, stop, even=False, glass='"gauss.dat", 50'):
    world = "background { rgb 1 }\n" if even else '#include "box_objects.inc"\n'
    return (
        '#declare Quality = 1; #declare Variance = 5e-6;\n#include "box_camera.inc"\n'
        f"camera {{ Box_Camera() focal_point <{', '.join(map(str, EDGE_TOP))}>\n"
        f"tilt_lens {{ scene_unit Scene_Unit prescription {glass} f_stop {stop} tilt {tilt} }} }}\n{world}"
    )


def program_picture(folder, tilt, stop, even=False, size=SIZE, **glass):
    width, height = size
    return rendering.render(scene(tilt, stop, even, **glass), f"+L{folder}", f"+L{SCENES}", width=width, height=height, extension="exr")


def lens_of(tilt, stop, size=SIZE):
    width, height = size
    return Lens.tilted(dataclasses.replace(VIEW, width=width, height=height, f_stop=stop), tilt, EDGE_TOP)


def traced_picture(tool, folder, tilt, stop, moved=0.0, size=SIZE, samples=None):
    lens = lens_of(tilt, stop, size)
    width, height = size
    made = folder / f"traced_{tilt}_{stop}.exr"
    done = subprocess.run(
        [
            tool,
            made,
            "--width",
            str(width),
            "--height",
            str(height),
            "--samples",
            str(samples or SAMPLES[stop]),
            "--f-stop",
            str(stop),
            "--tilt",
            str(tilt),
            "--moved",
            str(moved),
            "--film-distance",
            repr(lens.film_distance * VIEW.scene_unit),
        ],
        check=True,
        capture_output=True,
        text=True,
    )
    # the tracer's stop stays in place when the first element moves
    assert abs(json.loads(done.stdout)["entrance_pupil"]) < (0.02 if moved == 0.0 else 0.03), done.stdout
    # three floats, and three halves for the error
    *_, data = rendering.read_pixels(made)
    return rendering.Picture(width, height, ["R", "G", "B"], [v for pixel in struct.iter_unpack("=fffeee", data) for v in pixel[:3]])


def differences(picture, even, traced):
    squares = mean = 0.0
    for name in "RGB":
        for own, level, other in zip(picture.channel(name), even.channel(name), traced.channel(name)):
            squares += (own / level - other) ** 2
            mean += own / level - other
    count = 3 * traced.width * traced.height
    return math.sqrt(squares / count), mean / count


def inner_focus(tool, folder, stop):
    at_infinity = gauss.write_moving(folder, MOVED, lens_of(MOVED_TILT, stop).film_distance * VIEW.scene_unit)
    stays = json.loads((folder / "moving.json").read_text())
    del stays["object-distance"]
    for surface in stays["surfaces"]:
        if isinstance(surface["thickness"], list):
            surface["thickness"] = surface["thickness"][0]
    (folder / "stays.json").write_text(json.dumps(stays))

    def found(name, size, samples):
        glass = f'"{name}.json", {at_infinity!r}'
        pictures = [program_picture(folder, MOVED_TILT, stop, even, size, glass=glass) for even in (False, True)]
        return differences(*pictures, traced_picture(tool, folder, MOVED_TILT, stop, MOVED, size, samples))

    rmse, mean = found("moving", SIZE, SAMPLES[stop])
    unmoved, _ = found("stays", WRONG_SIZE, WRONG_SAMPLES)
    good = rmse < RMSE and abs(mean) < MEAN and unmoved > WRONG
    print(
        f"first element moved, f/{stop}: RMSE {rmse:.5f}, signed mean {mean:+.6f}; the film moved instead: RMSE {unmoved:.5f}"
        f"{'' if good else '  WRONG'}"
    )
    return good


def one_tilt(tool, folder, stop, tilt):
    traced = traced_picture(tool, folder, tilt, stop)
    rmse, mean = differences(program_picture(folder, tilt, stop), program_picture(folder, tilt, stop, True), traced)
    good = rmse < RMSE and abs(mean) < MEAN
    print(f"f/{stop}, tilt {tilt}: RMSE {rmse:.5f}, signed mean {mean:+.6f}{'' if good else '  TOO LARGE'}")
    return good


def wrong_sign(tool, folder, stop, tilt):
    traced = traced_picture(tool, folder, tilt, stop, size=WRONG_SIZE, samples=WRONG_SAMPLES)
    pictures = [program_picture(folder, -tilt, stop, even, WRONG_SIZE) for even in (False, True)]
    wrong, _ = differences(*pictures, traced)
    print(f"f/{stop}, tilt {-tilt} instead of {tilt}: RMSE {wrong:.5f}{'' if wrong > WRONG else '  TOO SMALL'}")
    return wrong > WRONG


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("stop", type=float, choices=STOPS)
    parser.add_argument("tilt", type=int, nargs="?", choices=TILTS, help="without it: the lens that focuses by its first element")
    parser.add_argument("--wrong-sign", action="store_true", help="the program's tilt gets the wrong sign; the pictures must differ")
    parser.add_argument("--glass", required=True, help="the separate tracer")
    parser.add_argument("--povray", required=True)
    parser.add_argument("--compare", required=True)
    args = parser.parse_args(namespace=rendering.SETTINGS)
    with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
        folder = pathlib.Path(name)
        gauss.write(folder)
        if args.tilt is None:
            good = inner_focus(args.glass, folder, args.stop)
        elif args.wrong_sign:
            good = wrong_sign(args.glass, folder, args.stop, args.tilt)
        else:
            good = one_tilt(args.glass, folder, args.stop, args.tilt)
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())

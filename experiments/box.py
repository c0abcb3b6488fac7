# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Figs. 5 to 8 and Table 1 of Nakane et al.: a box on a checker board, three states of focus, brightness along lines. In place of the
paper's photographs, which are not published, the second curve is the accumulation buffer."""

import dataclasses
import math

from experiments.laboratory import SCENES, Claim
from experiments.lens import Lens, View

VIEW = View(location=(0, 32, -50), look_at=(0, 3, 0), width=240, height=160, focal_length=50, f_stop=2.8, scene_unit=10)


def turned(point):
    c, s = math.cos(math.radians(35)), math.sin(math.radians(35))
    return (c * point[0] + s * point[2], point[1], -s * point[0] + c * point[2])


EDGE_TOP = turned((6, 8, -6))
# across the top (off its squares' corners), along the left face, over the floor
LINES = {
    "red": ("top", "#cc0000", turned((5.6, 8, -5.0)), turned((-4.2, 8, 5.6))),
    "green": ("side", "#008800", turned((5.8, 3.2, -6)), turned((-5.6, 5.4, -6))),
    "pink": ("floor", "#dd44aa", (-9.3, 0, -14.0), (-15.1, 0, 13.0)),
}
# of the paper against its photographs, 8-bit levels
PAPER = {"b": {"red": 6.45, "green": 10.5, "pink": 11.3}, "c": {"red": 5.67, "green": 13.7, "pink": 16.1}}
LIMITS = {0: 0.5, 1: 0.15}  # by Quality of box_camera.inc


def state(letter, view=VIEW):
    if letter == "a":
        return Lens.tilted(view, 0.0, EDGE_TOP)
    return Lens.on_plane(view, (0, 1, 0) if letter == "b" else (0, 0, 1), EDGE_TOP)


def oracle_case(letter, lens):
    view = lens.view
    return {
        "picture": [view.width, view.height],
        "camera": {
            "location": view.location,
            "look_at": view.look_at,
            "focal_length": view.focal_length,
            "f_stop": view.f_stop,
            "scene_unit": view.scene_unit,
            "focus": {"tilt": lens.tilt(), "swing": 0, "through": EDGE_TOP},
        },
    }


def compare_lines(lab, letter, lens, pictures, names, stem, title):
    found = {}
    for colour, (where, shade, start, end) in LINES.items():
        a, b = lens.pixel(start), lens.pixel(end)
        csv = lab.results / f"{stem}_{letter}_{colour}.csv"
        csv.parent.mkdir(parents=True, exist_ok=True)
        report = lab.json(
            [
                lab.tool("profile"),
                "line",
                *pictures,
                "--from-to",
                *a,
                *b,
                *[x for name in names for x in ("--name", name)],
                "--colour",
                "#bbbbbb",
                "--colour",
                shade,
                "--colour",
                "#0044cc",
                "--csv",
                csv,
                *([] if lab.quick else ["--plot", csv.with_suffix(".svg"), "--title", f"{title} ({letter}), {colour} line: {where}"]),
            ]
        )
        found[colour] = [curve["average_difference"] for curve in report["curves"]]
    return found


def draw_lines(lab, lens, picture):
    drawing = ["--resize", f"{2 * lens.view.width}x{2 * lens.view.height}"]
    for _, shade, start, end in LINES.values():
        colour = ",".join(f"{int(shade[i:i + 2], 16) / 255:.3f}" for i in (1, 3, 5))
        ends = ",".join(str(round(2 * c)) for p in (start, end) for c in lens.pixel(p))
        drawing += [f"--line:color={colour}", ends]
    lab.png(picture, *drawing)


def table_1(lab):
    view = dataclasses.replace(VIEW, width=120, height=80) if lab.quick else VIEW
    size = (view.width, view.height)
    batches, samples = (4, 256) if lab.quick else (8, 2048)
    qualities = (0,) if lab.quick else (0, 1)
    rows = []
    for letter in "b" if lab.quick else "bc":
        lens = state(letter, view)
        reference = lab.oracle(f"box_{letter}", oracle_case(letter, lens), SCENES / "box_objects.inc", batches, samples)
        pictures = [
            lab.render(SCENES / f"box_{letter}.pov", f"table1_{letter}_{quality}.exr", size, declare=[("Quality", quality)])
            for quality in qualities
        ]
        if not lab.quick:
            draw_lines(lab, lens, pictures[0])
        names = ["accumulation, unpatched", "tilt_lens", "tilt_lens, high quality"]
        found = compare_lines(
            lab, letter, lens, [reference, *pictures], names[: 1 + len(pictures)], "profile", "Fig. 7" if letter == "b" else "Fig. 8"
        )
        for colour, differences in found.items():
            rows.append([letter, colour, PAPER[letter][colour], *differences])
            for quality, difference in zip(qualities, differences):
                yield Claim(f"Table 1 ({letter}) {colour}, quality {quality}", difference, LIMITS[quality], "levels")
    lab.table("table1.csv", ["state", "line", "paper against its photograph", "own quality", "high quality"][: 3 + len(qualities)], rows)

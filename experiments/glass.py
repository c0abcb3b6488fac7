# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""A lens of glass as a second photograph of the box scene. Its distortion moves image points, which
an ideal lens does not know; so each line is drawn between the images of the same two points of the
scene, as on a photograph, and how far they moved is reported beside the brightness."""

import dataclasses
import math

from box import LINES, VIEW, state
from common import SCENES, Claim

F_STOP = 8              # the glass's own aberrations are small there
SAME_SCENE = 1.0        # level: the ideal lens in the glass's program against tilt_lens
GLASS = 8.0             # levels; found 1.2 to 7.0, with the image points put in place


def photograph(lab, letter, lens, name, extra=()):
    """The picture and what the program says of the lens."""
    view, picture = lens.view, lab.work / f"{name}_{letter}.exr"
    lab.work.mkdir(parents=True, exist_ok=True)
    points = [x for _, _, start, end in LINES.values() for p in (start, end) for x in p]
    report = lab.json([lab.tool("paper", "glass"), picture, "--width", view.width, "--height",
                       view.height, "--samples", 192 if lab.quick else 512, "--f-stop", view.f_stop,
                       "--tilt", lens.tilt(), "--film-distance",
                       lens.film_distance * view.scene_unit, *extra, "--locate", *points])
    return picture, report


def levels(lab, picture, line, csv):
    """The profile along a line, 200 points."""
    lab.results.mkdir(parents=True, exist_ok=True)
    lab.run([lab.tool("paper", "profile"), "line", picture, "--from-to", *line, "--points", 200,
             "--csv", csv])
    return [float(row.split(",")[1]) for row in csv.read_text().splitlines()[1:]]


def compare(lab):
    view = dataclasses.replace(VIEW, f_stop=F_STOP)
    rows = []
    for letter in "b" if lab.quick else "abc":
        lens = state(letter, view)
        ours = lab.render(SCENES / f"box_{letter}.pov", f"stopped_{letter}.exr",
                          (view.width, view.height), [("Stop", F_STOP)])
        ideal, _ = photograph(lab, letter, lens, "ideal", ["--thin"])
        glass, report = photograph(lab, letter, lens, "glass")
        for i, (colour, (_, _, start, end)) in enumerate(LINES.items()):
            line = [*lens.pixel(start), *lens.pixel(end)]
            moved = [x for point in report["located"][2 * i:2 * i + 2] for x in point]
            csv = lab.results / f"glass_{letter}_{colour}"
            curves = [levels(lab, picture, at, csv.with_name(f"{csv.name}_{name}.csv"))
                      for name, picture, at in (("tilt_lens", ours, line), ("ideal", ideal, line),
                                                ("glass", glass, moved))]
            same, far = (sum(abs(a - b) for a, b in zip(curves[0], c)) / 200 for c in curves[1:])
            shift = max(math.hypot(moved[j] - line[j], moved[j + 1] - line[j + 1]) for j in (0, 2))
            rows.append([letter, colour, same, far, shift])
            yield Claim(f"glass ({letter}) {colour}: the same scene, ideal lens", same, SAME_SCENE,
                        "levels")
            yield Claim(f"glass ({letter}) {colour}: glass against tilt_lens, image points moved "
                        f"by {shift:.2g} pixels", far, GLASS, "levels")
    lab.table("glass.csv", ["state", "line", "ideal lens, levels", "glass, levels",
                            "image points moved, pixels"], rows)

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Shift alone keeps a tower's verticals parallel; shift with tilt shows the right part of the same picture."""

import dataclasses

from experiments import marks
from experiments.blur import PLAIN, SPOT_LIMIT, THROUGH, cropped, error_of, spot_grid
from experiments.laboratory import OWN_SCENES, Claim
from experiments.lens import Lens

PARALLEL_LIMIT = 0.1  # pixels, over the whole height of the picture
SIZE = (240, 360)
INSIDE, FIRST, LAST = 120, 100, 340  # a column on the tower, and rows below its roof


def slope(pairs):
    n = len(pairs)
    mx, my = sum(x for x, _ in pairs) / n, sum(y for _, y in pairs) / n
    return sum((x - mx) * (y - my) for x, y in pairs) / sum((x - mx) ** 2 for x, _ in pairs)


def convergence(lab, name, declare, rows=(FIRST, LAST)):
    """Change of the verticals' distance, top to bottom, pixels."""
    options = () if any(key == "F_Stop" for key, _ in declare) else ("+A0.0", "+AM1", "+R9", "-J")
    picture = lab.render(OWN_SCENES / "tower.pov", name, SIZE, declare, options)
    found = lab.json([lab.tool("profile"), "edges", picture, "--inside", INSIDE, "--first", rows[0], "--last", rows[1]])
    return slope([(row["row"], row["right"] - row["left"]) for row in found]) * SIZE[1]


def tower(lab):
    rows = []
    for text, declare in (("shift 10 mm", [("Rise", 10)]), ("shift 10 mm, tilt 4, f/4", [("Rise", 10), ("Tilt", 4), ("F_Stop", 4)])):
        found = convergence(lab, f"tower_{len(rows)}.exr", declare)
        rows.append([text, found])
        yield Claim(f"verticals, {text}: convergence over the picture", found, PARALLEL_LIMIT, "pixels")
    found = convergence(lab, "tower_up.exr", [("Pitch", 1)])
    rows.append(["looking up instead", found])
    # counter-test: turned up by 17 degrees
    yield Claim("looking up instead: pixels of convergence, as 1/x", 1 / abs(found), 0.2)
    lab.table("verticals.csv", ["camera", "convergence in pixels"], rows)


def tilt_with_shift(lab):
    view = dataclasses.replace(cropped(PLAIN, 180, 120) if lab.quick else PLAIN, shift=(3.0, 8.0))
    lens = Lens.tilted(view, 10.5, THROUGH)
    grid = spot_grid(lens)
    points, reaches = [p for p, _ in grid], [1.2 * b + 7 for _, b in grid]
    picture = marks.render(lab, "spots_shifted", lens, THROUGH, points)
    windows = [marks.window(lens, p, r) for p, r in zip(points, reaches)]
    worst = away = 0.0
    rows = []
    for point, m in zip(points, lab.moments(picture, windows)):
        measured, wanted = (m["xx"], m["xy"], m["yy"]), marks.expected(lens, point)
        x, y = lens.blur_centre(point)
        offset, error = max(abs(m["x"] - x), abs(m["y"] - y)), error_of(measured, wanted)
        rows.append([x, y, *wanted, *measured, offset, error])
        worst, away = max(worst, error), max(away, offset)
    lab.table(
        "tilt_with_shift.csv",
        ["x", "y", "closed xx", "closed xy", "closed yy", "measured xx", "measured xy", "measured yy", "centroid off by", "error"],
        rows,
    )
    yield Claim(f"tilt 10.5 with shift <3, 8>, {len(points)} discs: second moments", worst, SPOT_LIMIT)
    yield Claim("their centroids", away, PARALLEL_LIMIT, "pixels")

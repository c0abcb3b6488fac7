# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Blur diameters in millimetres on the film against

    c = f^2 / N * |1/u - 1/u0| / (1 - f/u0)

for lenses, f-numbers and distances that people use; u0: focus, u: subject, from the lens, in mm."""

import math

from experiments import marks
from experiments.laboratory import Claim
from experiments.lens import Lens, View

LIMIT = 0.01
# focal length mm, f-number, focus and subjects in metres
LENSES = [
    (17, 4.0, 0.5, (0.25, 1.0, 10.0)),
    (24, 3.5, 1.0, (0.4, 2.0, 10.0)),
    (50, 1.4, 2.0, (1.0, 4.0, 50.0)),
    (90, 2.8, 1.5, (1.0, 3.0, 20.0)),
    (150, 5.6, 3.0, (1.5, 6.0, 100.0)),
    (300, 2.8, 10.0, (6.0, 20.0, 200.0)),
]
BLUR_PIXELS = 16  # pixels; the film is cropped to it


def blur_diameter(f, n, focus, subject):
    return f * f / n * abs(1 / subject - 1 / focus) / (1 - f / focus)


def table(lab):
    rows = []
    for f, n, focus, subjects in LENSES[2:4] if lab.quick else LENSES:
        wanted = [blur_diameter(f, n, 1000 * focus, 1000 * u) for u in subjects]
        pitch = max(wanted) / BLUR_PIXELS
        view = View(
            location=(0, 0, 0), look_at=(0, 0, 1), width=96, height=32, focal_length=f, f_stop=n, scene_unit=1000, film_width=96 * pitch
        )
        lens = Lens.tilted(view, 0.0, (0, 0, focus))
        points = [marks.at_pixel(lens, 16 + 32 * i, 16, u) for i, u in enumerate(subjects)]
        picture = marks.render(lab, f"lens_{f}", lens, (0, 0, focus), points, samples=4096)
        moments = marks.measure(lab, picture, lens, points, [15] * len(points))
        worst = 0.0
        for u, c, point, (xx, _, yy) in zip(subjects, wanted, points, moments):
            own = lens.disc_moments(point, marks.radius_of(lens, point))[0] + 1 / 12
            # diameter: four times the standard deviation
            found = 4 * math.sqrt((xx + yy) / 2 - own) * pitch
            rows.append([f, n, focus, u, c, found, found / c - 1])
            worst = max(worst, abs(found / c - 1))
        yield Claim(f"{f} mm f/{n}, focus {focus} m, {len(subjects)} distances: blur diameter", worst, LIMIT)
    lab.table("real_lenses.csv", ["f mm", "N", "focus m", "subject m", "closed form mm", "measured mm", "error"], rows)

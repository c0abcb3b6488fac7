# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The report of sharp_points, compared with an independent formula and the picture."""

import itertools
import math
import random
import re

from tests.render import rendering
from tests.render.test_layers import Rendered

WIDTH, HEIGHT = 320, 240
LOCATION = (0.0, 3.0, -6.0)
DOWN = math.radians(30)
RIGHT, UP, AXIS = (1.0, 0.0, 0.0), (0.0, math.cos(DOWN), math.sin(DOWN)), (0.0, -math.sin(DOWN), math.cos(DOWN))
FILM, ANGLE = 36.0, 50.0
FILM_DISTANCE = 0.5 * FILM / math.tan(math.radians(ANGLE / 2))  # mm
POINTS = ((-1.8, 1.4, -1.0), (1.2, -0.2, -1.6), (0.1, 1.4, 1.0), (-1.5, -0.6, 3.4), (2.4, 1.0, 2.2))
DIAMETER, UNIT = 0.8, 20.0  # units; mm
VIEW = (
    f"location <{LOCATION[0]}, {LOCATION[1]}, {LOCATION[2]}> direction z right 4/3*x up y "
    f"look_at <0, {LOCATION[1] - 6 * math.tan(DOWN)!r}, 0> angle {ANGLE} "
)


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def in_camera(point):
    way = [p - o for p, o in zip(point, LOCATION)]
    return tuple(dot(way, axis) for axis in (RIGHT, UP, AXIS))


def defocus(k, points):
    """1/z - k.D, positive before the plane k.X = 1."""
    return [(1 - dot(k, p)) / p[2] for p in points]


def determinant(rows):
    if len(rows) == 1:
        return rows[0][0]
    return sum((-1) ** i * rows[0][i] * determinant([row[:i] + row[i + 1 :] for row in rows[1:]]) for i in range(len(rows)))


def levelled(points):
    """(k, defocus) with four points equally blurred."""
    rows = [[p[0] / p[2], p[1] / p[2], 1.0] for p in points]
    weights = [(-1) ** i * determinant(rows[:i] + rows[i + 1 :]) for i in range(4)]
    system = [[*row, math.copysign(1.0, w)] for row, w in zip(rows, weights)]
    right = [1.0 / p[2] for p in points]
    whole = determinant(system)
    unknown = [determinant([row[:i] + [b] + row[i + 1 :] for row, b in zip(system, right)]) / whole for i in range(4)]
    return tuple(unknown[:3]), abs(unknown[3])


def best_plane(points):
    return max((levelled(four) for four in itertools.combinations(points, 4)), key=lambda solved: solved[1])


def in_pixels(defocus_value, diameter):
    return defocus_value * diameter * FILM_DISTANCE * WIDTH / FILM


def seen_from_film(k, point):
    """Root mean square of two diameters of the turned lens along the chief ray."""
    q = (k[0], k[1], k[2] + UNIT / FILM_DISTANCE)
    t = [part / math.hypot(*q) for part in q]
    across = [point[i] / point[2] for i in (0, 1)]
    return math.sqrt((2 + dot(across, across) - sum((t[i] - t[2] * across[i]) ** 2 for i in (0, 1))) / 2)


def camera(items, aperture=""):
    written = ", ".join(f"<{x}, {y}, {z}>" for x, y, z in POINTS)
    return f"camera {{ {VIEW}{aperture}blur_samples 64 variance 0 tilt_lens {{ scene_unit {UNIT} denoise off sharp_points {written} {items} }} }}\n"


LAMPS = "".join(
    f"sphere {{ <{x}, {y}, {z}>, 0.008 pigment {{ rgb 100 }} finish {{ ambient 1 diffuse 0 }} no_shadow }}\n" for x, y, z in POINTS
)


def reported(said):
    text = re.sub(r"\n (?! )", " ", said)  # joins lines that the console has wrapped
    lines = re.findall(r"^    \d\.+<[^>]*>: ([\d.e-]+) pixels \(([\d.e-]+) mm\) (before|behind)(, binds)?", text, re.MULTILINE)
    return [(float(p) * (1 if side == "before" else -1), float(mm), bool(binds)) for p, mm, side, binds in lines]


class SharpPoints(rendering.RenderTest):
    def rendered(self, items, aperture=""):
        return Rendered(camera(items, aperture) + LAMPS, width=WIDTH, height=HEIGHT)

    def test_report_and_picture_have_the_least_greatest_blur(self):
        result = self.rendered("", f"aperture {2 * DIAMETER} ")
        points = [in_camera(p) for p in POINTS]
        k, greatest = best_plane(points)
        wanted = [in_pixels(d, DIAMETER) for d in defocus(k, points)]
        found = reported(result.said)
        self.assertEqual(len(found), 5, result.said)
        for (blur, mm, binds), want in zip(found, wanted):
            self.assertAlmostEqual(blur, want, delta=2e-3 * abs(want) + 1e-3, msg=result.said)
            self.assertAlmostEqual(mm, abs(blur) * FILM / WIDTH, delta=6e-3 * mm)
            self.assertEqual(binds, abs(want) > in_pixels(greatest, DIAMETER) * (1 - 1e-9), result.said)
        self.assertEqual(sum(binds for _, _, binds in found), 4)
        chance = random.Random(1)
        for _ in range(200):
            moved = [part + chance.uniform(-1e-4, 1e-4) for part in k]
            self.assertGreater(max(abs(d) for d in defocus(moved, points)), greatest)
        for point, want in zip(points, wanted):
            measured = self.spot(result.picture, point, int(abs(want) / 2) + 3)
            self.assertAlmostEqual(measured, abs(want) * seen_from_film(k, point), delta=0.02 * abs(want))

    def spot(self, picture, point, most):
        """Mean diameter, pixels, of an even ellipse of light."""
        scale = FILM_DISTANCE / point[2] * WIDTH / FILM
        column, row = WIDTH / 2 + scale * point[0], HEIGHT / 2 - scale * point[1]
        lights = []
        for y in range(int(row) - most, int(row) + most + 1):
            for x in range(int(column) - most, int(column) + most + 1):
                lights.append((picture.pixel(x, y)[0], x, y))
        total = sum(light for light, _, _ in lights)
        middle = [sum(light[0] * light[i] for light in lights) / total for i in (1, 2)]
        spread = sum(light * ((x - middle[0]) ** 2 + (y - middle[1]) ** 2) for light, x, y in lights) / total
        return math.sqrt(8 * (spread - 1 / 6))

    def test_widest_aperture_and_the_lens_without_tilt(self):
        result = self.rendered("sharp_within 5")
        points = [in_camera(p) for p in POINTS]
        k, greatest = best_plane(points)
        distance = FILM_DISTANCE / UNIT
        focal = 1 / math.hypot(k[0], k[1], k[2] + 1 / distance)
        stop = focal / (5 / in_pixels(greatest, 1.0))
        found = float(re.search(r"Aperture\.+f/([\d.]+)", result.said)[1])
        self.assertAlmostEqual(found, stop, delta=1e-3 * stop)
        self.assertAlmostEqual(max(abs(blur) for blur, _, _ in reported(result.said)), 5, delta=1e-3)
        vergences = [1 / p[2] for p in points]
        middle, half = (max(vergences) + min(vergences)) / 2, (max(vergences) - min(vergences)) / 2
        without = in_pixels(half, 1.0) / 5 / (middle + 1 / distance)
        match = re.search(r"without tilt\.+f/([\d.]+) in place of f/([\d.]+)", result.said)
        self.assertAlmostEqual(float(match[1]), without, delta=2e-3 * without)
        self.assertAlmostEqual(float(match[2]), found, delta=1e-3 * found)


if __name__ == "__main__":
    rendering.main()

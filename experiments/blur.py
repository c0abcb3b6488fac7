# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Measured blur against its closed form: spots of small discs, slanted rulers for the plane of sharp focus, refocusing for the hinge
line, the wedge of the depth of field."""

import dataclasses
import itertools
import math

from experiments import marks
from experiments.laboratory import Claim
from experiments.lens import Lens, View, add, dot, length, sub, times

PLAIN = View(location=(0, 32, -50), look_at=(0, 3, 0), width=360, height=240, focal_length=50, f_stop=2.8, scene_unit=10)
THROUGH = (1.5, 8, -8.4)
SPOT_LIMIT = 0.02  # of a spot's second moments
PLANE_LIMIT = 0.005  # of the distance
HINGE_LIMIT = 0.01  # of J: a line through two points 20 cm apart, followed for 50 cm


def cropped(view, width, height):
    return dataclasses.replace(view, width=width, height=height, film_width=view.film_width * width / view.width)


def spot_grid(lens):
    blurs, found = (-8, -4, 0, 4, 8), []
    for j in range(lens.view.height // 60):
        for i in range(lens.view.width // 60):
            blur = blurs[(i + 2 * j) % len(blurs)]
            x, y = 30 + 60 * i, 30 + 60 * j
            ray = lens.view.local(marks.at_pixel(lens, x, y, 1.0))
            vergence = dot(lens.focus, ray) - blur / (lens.radius * lens.pixels_per_slope())
            if vergence > 0.002:  # nearer than 5 m
                found.append((marks.at_pixel(lens, x, y, 1 / vergence), abs(blur)))
    return found


def error_of(measured, wanted):
    scale = (wanted[0], math.sqrt(wanted[0] * wanted[2]), wanted[2])
    return max(abs(a - b) / s for a, b, s in zip(measured, wanted, scale))


def spots(lab):
    rows = []
    for tilt in (10.5,) if lab.quick else (0.0, 10.5, -6.0):
        lens = Lens.tilted(cropped(PLAIN, 180, 120) if lab.quick else PLAIN, tilt, THROUGH)
        grid = spot_grid(lens)
        points, reaches = [p for p, _ in grid], [1.2 * b + 7 for _, b in grid]
        picture = marks.render(lab, f"spots_{tilt:g}", lens, THROUGH, points)
        worst = 0.0
        for point, measured in zip(points, marks.measure(lab, picture, lens, points, reaches)):
            wanted = marks.expected(lens, point)
            error = error_of(measured, wanted)
            rows.append([tilt, *lens.pixel(point), lens.view.local(point)[2], *wanted, *measured, error])
            worst = max(worst, error)
        yield Claim(f"spots, tilt {tilt:g}, {len(points)} discs: second moments", worst, SPOT_LIMIT)
    lab.table(
        "spots.csv",
        ["tilt", "x", "y", "depth cm", "closed xx", "closed xy", "closed yy", "measured xx", "measured xy", "measured yy", "error"],
        rows,
    )


def parabola(xs, ys):
    sums = [sum(x**n for x in xs) for n in range(5)]
    m = [[sums[i + j] for j in range(3)] + [sum(y * x**i for x, y in zip(xs, ys))] for i in range(3)]
    for i in range(3):
        for j in range(3):
            if j != i:
                factor = m[j][i] / m[i][i]
                m[j] = [q - factor * p for p, q in zip(m[i], m[j])]
    return [m[i][3] / m[i][i] for i in range(3)]


@dataclasses.dataclass
class Ruler:
    middle: tuple
    half: tuple  # from the middle to the end
    count: int = 7
    fit: list = None  # (width of the blur times depth)^2 as a parabola in u

    def at(self, u):
        return add(self.middle, times(u, self.half))

    def places(self, lens):
        near, far = (lens.view.local(self.at(u))[2] for u in (-1, 1))
        steps = [i / (self.count - 1) for i in range(self.count)]
        return [2 * t * near / (far * (1 - t) + near * t) - 1 for t in steps]

    def read(self, lens, moments):
        """A mark's blur across the tilt is proportional to |1 - k.X| / X.z. So the square of width times depth is a parabola along the
        ruler, which touches zero in the plane of sharp focus."""
        values = []
        for u, (xx, _, _) in zip(self.places(lens), moments):
            own = lens.disc_moments(self.at(u), marks.radius_of(lens, self.at(u)))[0]
            values.append((xx - own - 1 / 12) * lens.view.local(self.at(u))[2] ** 2)
        self.fit = parabola(self.places(lens), values)

    def sharp(self):
        return self.at(-self.fit[1] / (2 * self.fit[2]))

    def limits(self, lens, diameter):
        """Where the blur is `diameter` pixels, four standard deviations."""
        start, end = (lens.view.local(self.at(u))[2] for u in (-1, 1))
        middle, slope = (start + end) / 2, (end - start) / 2
        centre, width = -self.fit[1] / (2 * self.fit[2]), math.sqrt(self.fit[2])
        c = diameter / 4
        found = [(width * centre + sign * c * middle) / (width - sign * c * slope) for sign in (-1, 1)]
        return sorted((self.at(u) for u in found), key=lambda p: lens.view.local(p)[2])


def read_rulers(lab, name, lens, through, rulers):
    points = [r.at(u) for r in rulers for u in r.places(lens)]
    picture = marks.render(lab, name, lens, through, points)
    reaches = [max(map(abs, sum(lens.blur_axes(p), ()))) * 1.1 + 4 for p in points]
    moments = marks.measure(lab, picture, lens, points, reaches)
    for i, ruler in enumerate(rulers):
        ruler.read(lens, moments[i * ruler.count : (i + 1) * ruler.count])


def slanted(lens, x, top, bottom):
    """Across the plane of sharp focus, ends 6 pixels out of focus, unless nearly at infinity."""
    view, ends = lens.view, []
    defocus = 6 / (lens.radius * lens.pixels_per_slope())
    for y, sign in ((top, -1), (bottom, 1)):
        sharp = dot(lens.focus, view.local(marks.at_pixel(lens, x, y, 1.0)))
        ends.append(marks.at_pixel(lens, x, y, 1 / (sharp - sign * min(defocus, 0.6 * sharp))))
    return Ruler(times(0.5, add(*ends)), times(0.5, sub(ends[1], ends[0])))


def plane(lab):
    rows = []
    for tilt in (10.5,) if lab.quick else (0.0, 10.5, -6.0):
        lens = Lens.tilted(PLAIN, tilt, THROUGH)
        rulers = [slanted(lens, x, 20, 220) for x in (60, 180, 300)]
        read_rulers(lab, f"rulers_{tilt:g}", lens, THROUGH, rulers)
        worst = 0.0
        for ruler in rulers:
            found = ruler.sharp()
            local = lens.view.local(found)
            off = (1 - dot(lens.focus, local)) / length(lens.focus)
            distance = length(local)
            rows.append([tilt, *found, distance, off, off / distance])
            worst = max(worst, abs(off / distance))
        yield Claim(f"plane of sharp focus, tilt {tilt:g}, {len(rulers)} rulers: off by", worst, PLANE_LIMIT, "of its distance")
    lab.table("plane.csv", ["tilt", "x", "y", "z", "distance cm", "off cm", "relative"], rows)


def line_through(a, b):
    q = (b[1] - a[1]) / (b[0] - a[0])
    return a[1] - q * a[0], q


def meet(first, second):
    y = (second[0] - first[0]) / (first[1] - second[1])
    return y, first[0] + first[1] * y


HINGE_VIEW = View(location=(0, 0, 0), look_at=(0, 0, 1), width=120, height=400, focal_length=50, f_stop=2.8, scene_unit=10, film_width=12)
HINGE_TILT = 8.0
WEDGE_BLUR = 6.0  # pixels


def hinge_lines(lab, depth):
    through = (0, 0, depth)
    lens = Lens.tilted(HINGE_VIEW, HINGE_TILT, through)
    rulers = [slanted(lens, 30, 15, 145), slanted(lens, 90, 255, 385)]
    for ruler in rulers:
        ruler.count = 5
    read_rulers(lab, f"hinge_{depth:g}", lens, through, rulers)
    places = [[r.sharp(), *r.limits(lens, WEDGE_BLUR)] for r in rulers]
    lines = [line_through(a[1:], b[1:]) for a, b in zip(*places)]
    return lens, dict(zip(("sharp", "near", "far"), lines))


def hinge(lab):
    depths = (40.0, 70.0) if lab.quick else (40.0, 52.0, 70.0)
    found = [hinge_lines(lab, depth) for depth in depths]
    distance = found[0][0].hinge_distance()
    rows = []
    for i, j in itertools.combinations(range(len(found)), 2):
        y, z = meet(found[i][1]["sharp"], found[j][1]["sharp"])
        error = math.hypot(y + distance, z) / distance
        rows.append([f"sharp planes {i + 1}, {j + 1}", y, z, error])
        yield Claim(f"hinge line from focus {i + 1} and {j + 1}, J = {distance:.4g} cm: off by", error, HINGE_LIMIT, "J")
    for lens, lines in found:
        y, z = meet(lines["near"], lines["far"])
        error = math.hypot(y + distance, z) / distance
        rows.append(["near and far limit", y, z, error])
        yield Claim("the wedge's edge against the hinge line: off by", error, HINGE_LIMIT, "J")
        reach = WEDGE_BLUR / (2 * lens.radius * lens.pixels_per_slope())
        for name, sign in (("near", 1), ("far", -1)):
            wanted = 1 / (lens.focus[2] + sign * reach)
            yield Claim(f"{name} limit on the axis, {wanted:.4g} cm: off by", lines[name][0] / wanted - 1, PLANE_LIMIT, "of its distance")
    lab.table("hinge.csv", ["from", "y cm", "z cm", "off, in J"], rows)

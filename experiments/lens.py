# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""A tilted thin lens in closed form.

Camera frame: lens centre at the origin, x right, y up, z into the scene, film at -s. The unit lens normal is t, the focal length f. The
plane of sharp focus is k.X = 1, k = t/f - z/s (Scheimpflug's rule and the thin lens equation). Lengths in scene units, angles in degrees,
image in pixels from the upper left corner."""

import dataclasses
import math


def dot(a, b):
    return sum(p * q for p, q in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def sub(a, b):
    return tuple(p - q for p, q in zip(a, b))


def add(a, b):
    return tuple(p + q for p, q in zip(a, b))


def times(factor, a):
    return tuple(factor * p for p in a)


def length(a):
    return math.sqrt(dot(a, a))


def unit(a):
    return times(1 / length(a), a)


@dataclasses.dataclass
class View:
    location: tuple
    look_at: tuple
    width: int
    height: int
    focal_length: float  # mm
    f_stop: float
    scene_unit: float  # mm
    film_width: float = 36.0  # mm
    shift: tuple = (0.0, 0.0)  # mm, right and up

    def axes(self):
        axis = unit(sub(self.look_at, self.location))
        right = unit(cross((0, 1, 0), axis))
        return right, cross(axis, right), axis

    def local(self, point):
        offset = sub(point, self.location)
        return tuple(dot(offset, axis) for axis in self.axes())

    def turned(self, vector):
        return tuple(dot(vector, axis) for axis in self.axes())


class Lens:
    def __init__(self, view, normal, film_distance):
        self.view, self.normal, self.film_distance = view, normal, film_distance
        self.focal_length = view.focal_length / view.scene_unit
        self.radius = 0.5 * self.focal_length / view.f_stop
        self.focus = sub(times(1 / self.focal_length, normal), (0, 0, 1 / film_distance))

    @classmethod
    def tilted(cls, view, tilt, through):
        f, p = view.focal_length / view.scene_unit, view.local(through)
        normal = (0.0, -math.sin(math.radians(tilt)), math.cos(math.radians(tilt)))
        return cls(view, normal, f * p[2] / (dot(p, normal) - f))

    @classmethod
    def on_plane(cls, view, normal, point):
        f, n = view.focal_length / view.scene_unit, view.turned(unit(normal))
        k = times(1 / dot(n, view.local(point)), n)
        across = (f * k[0], f * k[1])
        t_z = math.sqrt(1 - across[0] ** 2 - across[1] ** 2)
        return cls(view, (*across, t_z), 1 / (t_z / f - k[2]))

    @classmethod
    def of_angle(cls, view, angle, diameter, normal, point):
        s = view.film_width / view.scene_unit / 2 / math.tan(math.radians(angle / 2))
        n = view.turned(unit(normal))
        q = add(times(1 / dot(n, view.local(point)), n), (0, 0, 1 / s))
        f = 1 / length(q)
        view = dataclasses.replace(view, focal_length=f * view.scene_unit, f_stop=f / diameter)
        return cls(view, times(f, q), s)

    def tilt(self):
        return math.degrees(math.atan2(-self.normal[1], self.normal[2]))

    def hinge_distance(self):
        """J of Merklinger's rule."""
        return self.focal_length / math.hypot(self.normal[0], self.normal[1])

    def pixels_per_slope(self):
        """On the film, for x/z."""
        return self.film_distance * self.view.scene_unit / self.view.film_width * self.view.width

    def pixel(self, point):
        v, p, scale = self.view, self.view.local(point), self.pixels_per_slope()
        millimetre = v.width / v.film_width
        return (v.width / 2 + scale * p[0] / p[2] - v.shift[0] * millimetre, v.height / 2 - scale * p[1] / p[2] + v.shift[1] * millimetre)

    def lens_axes(self):
        right = unit(cross((0, 1, 0), self.normal))
        return right, cross(self.normal, right)

    def vergence(self, point):
        """w(D) - 1/T for the chief ray X = T D, D.z = 1."""
        p = self.view.local(point)
        return (dot(self.focus, p) - 1) / p[2]

    def blur_axes(self, point):
        """Pixels (x right, y down): images of the lens's right and upper rim. To first order a lens point l moves it by (w - 1/T) (l - D
        l.z)."""
        p = self.view.local(point)
        direction = times(1 / p[2], p)
        scale = self.vergence(point) * self.radius * self.pixels_per_slope()
        return [(scale * (e[0] - direction[0] * e[2]), -scale * (e[1] - direction[1] * e[2])) for e in self.lens_axes()]

    def blur_moments(self, point):
        """(xx, xy, yy), evenly filled: squared axes by four."""
        axes = self.blur_axes(point)
        return tuple(sum(a[i] * a[j] for a in axes) / 4 for i, j in ((0, 0), (0, 1), (1, 1)))

    def blur_diameter(self, point):
        xx, _, yy = self.blur_moments(point)
        return 4 * math.sqrt((xx + yy) / 2)

    def blur_centre(self, point):
        """Pixels, for a small disc parallel to the film: a nearer rim of a tilted lens sees it larger."""
        p, (right, up) = self.view.local(point), self.lens_axes()
        sums, rings, spokes = [0.0, 0.0, 0.0], 8, 16
        for i in range(rings):
            for j in range(spokes):
                r = self.radius * math.sqrt((i + 0.5) / rings)
                angle = 2 * math.pi * (j + 0.5) / spokes
                rim = add(times(r * math.cos(angle), right), times(r * math.sin(angle), up))
                size = self.seen_size(rim, p)
                for k, slope in enumerate((1.0, *self.seen_from(rim, p))):
                    sums[k] += size * slope
        x, y = self.pixel(point)
        scale = self.pixels_per_slope()
        return (x + scale * (sums[1] / sums[0] - p[0] / p[2]), y - scale * (sums[2] / sums[0] - p[1] / p[2]))

    def seen_from(self, rim, p):
        """As slopes, of a camera-frame point through a lens point."""
        k_rim, k_p = dot(self.focus, rim), dot(self.focus, p)
        met = add(times(k_p - k_rim, rim), times(1 - k_rim, sub(p, rim)))
        return met[0] / met[2], met[1] / met[2]

    def seen_size(self, rim, p):
        """Area on the film of a small piece parallel to it, by differences."""
        step = 1e-4 * p[2]
        (ax, ay), (bx, by) = (self.seen_from(rim, (p[0] + d, p[1], p[2])) for d in (-step, step))
        (cx, cy), (dx, dy) = (self.seen_from(rim, (p[0], p[1] + d, p[2])) for d in (-step, step))
        return abs((bx - ax) * (dy - cy) - (by - ay) * (dx - cx))

    def disc_moments(self, point, radius):
        """Parallel to the film, by a pinhole."""
        half = radius * self.pixels_per_slope() / self.view.local(point)[2]
        return (half * half / 4, 0.0, half * half / 4)

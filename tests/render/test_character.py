# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Rendered aberrations obey the laws in docs/manual.md."""

import math
import pathlib
import tempfile

from tests.render import rendering, scenes

WIDTH, HEIGHT = 64, 48
SIZE = {"width": WIDTH, "height": HEIGHT, "extension": "exr"}
VIEW = "location 0 look_at <0, 0, 10> right 4/3*x angle 50 "
HALF = math.tan(math.radians(25))
SAMPLES = "blur_samples 32, 32 variance 0 "
EVEN = "background { rgb 0.5 }\n"
ALL = (
    "edge_light 0.4 natural_vignetting 1 optical_vignetting 0.4 distortion 0.05, 0.01 field_curvature 0.3 lateral_colour 0.2 "
    "axial_colour 0.2 "
)
BENT = "tilt 4 shift <2, -1> blades 5 " + ALL


def camera(items, aperture=0.5, samples=SAMPLES):
    return scenes.camera("scene_unit 100 " + items, aperture, samples, VIEW)


def place(x, y):
    return 2 * (x + 0.5) / WIDTH - 1, (HEIGHT - 2 * (y + 0.5)) / WIDTH


def layers_of(scene):
    with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
        folder = pathlib.Path(name)
        job = rendering.Job(scene, ("+N",), width=WIDTH, height=HEIGHT)
        job.run(folder)
        layers = rendering.read_picture(folder / "picture.layers.exr", job.told())
    return lambda x, y: dict(zip(layers.names, layers.pixel(x, y)))


def middle_of(picture, channel):
    weights = [(place(x, y), picture.pixel(x, y)[channel]) for y in range(HEIGHT) for x in range(WIDTH)]
    light = sum(weight for _, weight in weights)
    return [sum(at[axis] * weight for at, weight in weights) / light for axis in (0, 1)]


class Vignetting(rendering.RenderTest):
    def test_natural(self):
        picture = rendering.render(camera("natural_vignetting 1") + EVEN, **SIZE)
        for x, y in ((0, 0), (63, 20), (40, 47), (31, 23)):
            at = math.hypot(*place(x, y)) * HALF
            self.assertAlmostEqual(picture.pixel(x, y)[0] / 0.5, math.cos(math.atan(at)) ** 4, delta=0.004)

    def test_natural_of_a_pinhole(self):
        pinhole = rendering.render(camera("natural_vignetting 1", 0) + EVEN, **SIZE)
        blurred = rendering.render(camera("natural_vignetting 1") + EVEN, **SIZE)
        self.assertLess(max(abs(a - b) for a, b in zip(pinhole.channel("R"), blurred.channel("R"))), 1e-3)

    def test_optical(self):
        picture = rendering.render(camera("optical_vignetting 0.5") + EVEN, **SIZE)
        corner = math.hypot(1, 0.75)
        for x, y in ((0, 0), (63, 47), (63, 20), (31, 23)):
            half = 0.5 * math.hypot(*place(x, y)) / corner  # half the distance of two unit circles
            shared = 2 / math.pi * (math.acos(half) - half * math.sqrt(1 - half * half))
            # the focus at 10 makes the rim's shadow slightly larger than the aperture
            self.assertAlmostEqual(picture.pixel(x, y)[0] / 0.5, shared, delta=0.04)
        for x, y in ((0, 0), (5, 40)):
            self.assertAlmostEqual(picture.pixel(x, y)[0], picture.pixel(WIDTH - 1 - x, HEIGHT - 1 - y)[0], delta=0.002)


class Distortion(rendering.RenderTest):
    def test_layers_match_the_picture(self):
        at = layers_of(camera("distortion 0.1, -0.02 shift <3, 2>") + "plane { z, 20 pigment { rgb 1 } }\n")
        for x, y in ((0, 0), (63, 20), (40, 47)):
            shown = place(x, y)
            own = [shown[0] + 3 / 18, shown[1] + 2 / 18]
            square = own[0] ** 2 + own[1] ** 2
            factor = 1 + 0.1 * square - 0.02 * square**2
            values = at(x, y)
            self.assertAlmostEqual(values["position.X"], 20 * HALF * own[0] * factor, places=4)
            self.assertAlmostEqual(values["position.Y"], 20 * HALF * own[1] * factor, places=4)
            self.assertAlmostEqual(values["depth.Z"], 20, places=4)

    def test_near(self):
        """The coefficient is K1 + NEAR f/D, with D in units of 100 mm."""
        film = 18 / HALF  # mm
        for distance in (10, 1.5):
            view = VIEW.replace("look_at <0, 0, 10>", f"look_at <0, 0, {distance}>")
            at = layers_of(
                scenes.camera("scene_unit 100 distortion -0.02, 0.01, 0.8", 0.5, SAMPLES, view) + "plane { z, 20 pigment { rgb 1 } }\n"
            )
            k1 = -0.02 + 0.8 / (1 + 100 * distance / film)
            for x, y in ((0, 0), (63, 20), (40, 47)):
                own = place(x, y)
                square = own[0] ** 2 + own[1] ** 2
                factor = 1 + k1 * square + 0.01 * square**2
                values = at(x, y)
                self.assertAlmostEqual(values["position.X"], 20 * HALF * own[0] * factor, places=4)
                self.assertAlmostEqual(values["position.Y"], 20 * HALF * own[1] * factor, places=4)

    def test_light_is_at_its_position_in_the_layers(self):
        for k1, shift in ((0.1, (0, 0)), (-0.05, (3 / 18, 2 / 18))):
            picture = rendering.render(
                camera(f"distortion {k1} shift <{18 * shift[0]}, {18 * shift[1]}>")
                + "sphere { <2.2, -1.4, 10>, 0.1 pigment { rgb 1 } finish { emission 20 } }\n",
                **SIZE,
            )
            own = [at + by for at, by in zip(middle_of(picture, 0), shift)]
            factor = 1 + k1 * (own[0] ** 2 + own[1] ** 2)
            self.assertAlmostEqual(own[0] * factor * HALF * 10, 2.2, delta=0.03)
            self.assertAlmostEqual(own[1] * factor * HALF * 10, -1.4, delta=0.03)

    def test_of_a_pinhole(self):
        world = "plane { z, 20 pigment { checker rgb 0.2, rgb 1 scale 4 } finish { emission 1 diffuse 0 } }\n"
        pinhole = rendering.render(camera("distortion 0.1", 0) + world, **SIZE)
        small = rendering.render(camera("distortion 0.1", 1e-6) + world, **SIZE)
        self.assertLess(max(abs(a - b) for a, b in zip(pinhole.channel("R"), small.channel("R"))), 1e-3)


class FieldCurvature(rendering.RenderTest):
    def test_layers_have_the_blur(self):
        # in focus at 10; at half a film's width 1/Z grows by sag/s^2
        at = layers_of(camera("field_curvature 0.3") + "plane { z, 10 pigment { rgb 1 } }\n")
        s = 18 / HALF  # mm
        for x, y in ((0, 23), (63, 24), (31, 23), (31, 0)):
            square = sum(value**2 for value in place(x, y))
            vergence = -0.3 * square / s**2 * 100  # vergence of the surface minus that in focus
            blur = 0.25 * vergence * WIDTH / (2 * HALF)  # the lens diameter is half of `aperture`
            self.assertAlmostEqual(at(x, y)["blur"], blur, delta=1e-3 * abs(blur) + 1e-5)


class Colours(rendering.RenderTest):
    def test_even_light_stays_even(self):
        for items in ("lateral_colour 0.3", "axial_colour -0.5", "tilt 5 lateral_colour -0.3 axial_colour 0.4"):
            picture = rendering.render(camera(items) + "background { rgb <0.5, 2, 0.125> }\n", **SIZE)
            self.assertEqual(set(zip(*(picture.channel(name) for name in "RGB"))), {(0.5, 2.0, 0.125)}, picture.told)

    def test_lateral(self):
        picture = rendering.render(
            camera("lateral_colour 1.8", samples="blur_samples 256, 256 variance 0 ")
            + "sphere { <3.2, 0, 10>, 0.15 pigment { rgb 1 } finish { emission 10 } }\n",
            **SIZE,
        )
        red, green, blue = (middle_of(picture, channel)[0] for channel in range(3))
        # the outer thirds' centres lie 2/3 of the way to the spectrum's ends
        self.assertAlmostEqual(red / green - 1, 2 / 3 * 0.05, delta=0.008)
        self.assertAlmostEqual(1 - blue / green, 2 / 3 * 0.05, delta=0.008)


class Sampling(rendering.RenderTest):
    def test_threads_and_parts(self):
        scene = scenes.camera("scene_unit 100 " + BENT) + scenes.WORLD
        self.assert_same_in_parts(scene, first=9, last=40, **SIZE)

    def test_zero_equals_absence(self):
        without = rendering.render(scenes.camera("tilt 4") + scenes.WORLD, **SIZE)
        off = "edge_light 0 natural_vignetting 0 optical_vignetting 0 distortion 0 field_curvature 0 lateral_colour 0 axial_colour 0"
        self.assert_same(rendering.render(scenes.camera("tilt 4 " + off) + scenes.WORLD, **SIZE), without, "off")

    def test_focus_aids(self):
        world = "plane { z, 10 pigment { rgb 1 } finish { emission 1 diffuse 0 } }\n"
        flat = rendering.render(camera("focus_peaking rgb <1, 0, 0>") + world, **SIZE)
        bent = rendering.render(camera("focus_peaking rgb <1, 0, 0> field_curvature 2") + world, **SIZE)
        self.assertLess(max(flat.channel("G")), 0.6, "all of the wall is sharp")
        self.assertLess(bent.pixel(32, 24)[1], 0.6, "sharp in the middle")
        self.assertGreater(bent.pixel(0, 0)[1], 0.9, "not in the corner")


if __name__ == "__main__":
    rendering.main()

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Blurred light has the diaphragm's moments."""

import math

from tests.render import rendering, scenes

SIZE = {"width": 64, "height": 64, "extension": "exr"}
VIEW = "right x up y location <0, 0, -10> look_at 0 angle 40 "
LIGHT = "sphere { <0, 0, 20>, 0.3 pigment { rgb 1 } finish { emission 16 diffuse 0 } }\n"
SAMPLES = "blur_samples 256, 256 variance 0 "


def moments(lens, aperture=2.4):
    """Light, and mean squares across and along, pixels."""
    picture = rendering.render(scenes.camera("scene_unit 10 " + lens, aperture, SAMPLES, VIEW) + LIGHT, **SIZE)
    places = [(x, y, picture.pixel(x, y)[0]) for y in range(picture.height) for x in range(picture.width)]
    light = sum(value for _, _, value in places)
    middle = [sum(place[axis] * place[2] for place in places) / light for axis in (0, 1)]
    return light, *(sum((place[axis] - middle[axis]) ** 2 * place[2] for place in places) / light for axis in (0, 1))


def mean_square_radius(blades, curvature):
    steps, fourth, second = 4000, 0.0, 0.0
    half, middle = math.sin(math.pi / blades), math.cos(math.pi / blades)
    for i in range(steps):
        angle = math.pi / blades * (i + 0.5) / steps
        if curvature == 0:
            radius = middle / math.cos(angle)
        else:
            arc = 1 / curvature
            behind = math.sqrt(arc**2 - half**2) - middle
            radius = math.sqrt(arc**2 - (behind * math.sin(angle)) ** 2) - behind * math.cos(angle)
        fourth += radius**4
        second += radius**2
    return fourth / second / 2


class Diaphragm(rendering.RenderTest):
    def test_squeeze(self):
        # a tiny lens shows the size of pixels and light
        _, dot_x, dot_y = moments("", 0.0001)
        light, x, y = moments("")
        for lens, ratio in (("", 2), ("", 0.5), ("tilt 8 ", 2), ("swing 8 shift <2, 1> ", 1.5)):
            with self.subTest(lens=lens, squeeze=ratio):
                round_light, round_x, round_y = moments(lens) if lens else (light, x, y)
                oval_light, oval_x, oval_y = moments(f"{lens}squeeze {ratio}")
                self.assertLess(abs(oval_light / round_light - 1), 0.02)
                width, height = min(1, 1 / ratio), min(1, ratio)
                self.assertLess(abs((oval_x - dot_x) / (round_x - dot_x) / width**2 - 1), 0.03)
                self.assertLess(abs((oval_y - dot_y) / (round_y - dot_y) / height**2 - 1), 0.03)

    def test_blade_curvature(self):
        _, dot_x, dot_y = moments("", 0.0001)
        _, x, y = moments("")
        disc = x + y - dot_x - dot_y
        for blades, curvature in ((3, 0), (3, 0.5), (3, 1), (5, 0.6)):
            with self.subTest(blades=blades, curvature=curvature):
                _, x, y = moments(f"blades {blades}, 20 blade_curvature {curvature}")
                found = (x + y - dot_x - dot_y) / disc / 2
                self.assertLess(abs(found / mean_square_radius(blades, curvature) - 1), 0.03)

    def test_threads_and_parts(self):
        scene = scenes.camera("tilt 4 blades 5 blade_curvature 0.5 squeeze 2") + scenes.WORLD
        self.assert_same_in_parts(scene, first=9, last=40, **SIZE)

    def test_off_is_as_without(self):
        without = rendering.render(scenes.camera("blades 5, 10") + scenes.WORLD, **SIZE)
        off = rendering.render(scenes.camera("blades 5, 10 blade_curvature 0 squeeze 1") + scenes.WORLD, **SIZE)
        self.assert_same(off, without, "off")


if __name__ == "__main__":
    rendering.main()

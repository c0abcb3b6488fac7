# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Blur of lamps in mirrors and behind panes. One sample per pixel shows the circle of confusion."""

from tests.render import rendering

SIZE = {"width": 64, "height": 48, "extension": "exr"}
CAMERA = """
camera { location <0, 0, -10> look_at 0 angle 40 right 4/3*x aperture 1 focal_point <0, 0, 8> blur_samples 1 tilt_lens { } }
"""
MIRROR = "box { <-30, -30, 8>, <30, 30, 9> pigment { rgb 0 } finish { ambient 0 diffuse 0 reflection 1 } }\n"
PANE = "box { <-30, -30, 8>, <30, 30, 8.001> pigment { rgbt 1 } }\n"
BALL = "sphere { <0, 0, 18>, 10 pigment { rgbt 1 } }\n"


LAMP = "pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 1 }"


def lamps(z):
    return "".join(f"sphere {{ <{3*x}, {3*y}, {z}>, 0.6 {LAMP} }}\n" for x in range(-2, 3) for y in (-1, 0, 1))


def picture(scene):
    return rendering.render(CAMERA + scene, **SIZE)


class LightPath(rendering.RenderTest):
    def test_flat_mirror_keeps_the_blur_of_reflected_objects(self):
        self.assert_near(picture(MIRROR + lamps(-14)), picture(lamps(30)), 1e-5)

    def test_flat_pane_keeps_the_blur_of_objects_behind_it(self):
        self.assert_near(picture(PANE + lamps(30)), picture(lamps(30)), 1e-5)

    def test_curved_surface_has_its_own_circle_of_confusion(self):
        self.assert_different(picture(BALL + lamps(30)), picture(lamps(30)), 1e-3)


if __name__ == "__main__":
    rendering.main()

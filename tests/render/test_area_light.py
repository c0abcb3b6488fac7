# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""One point of an area light per ray gives soft shadows."""

import re

from tests.render import rendering, scenes

FLOOR = "plane { y, 0 pigment { rgb 0.8 } }\nbackground { rgb 0.3 }\n"
THINGS = (
    "sphere { <0.3, 0.8, 0>, 0.7 pigment { rgb <0.8, 0.3, 0.2> } }\n"
    "box { <-1.6, 0, -0.3>, <-1.2, 1.5, 0.3> pigment { rgb <0.3, 0.5, 0.8> } finish { specular 0.5 } }\n"
    "sphere { <1.5, 0.5, 1>, 0.5 pigment { rgb 0.1 } finish { reflection 0.7 } }\n"
)
LIGHTS = {
    "grid of 5 by 5": "x*3, z*3, 5, 5 adaptive 10",
    "grid of 4 by 3": "x*4, z*2, 4, 3 adaptive 10",
    "grid of 17 by 2": "x*4, z*2, 17, 2 adaptive 10",
    "row": "x*4, z*2, 6, 1 adaptive 10",
    "circle that turns": "x*3, z*3, 5, 5 adaptive 10 circular orient",
    "all points shade": "x*3, z*3, 5, 5 adaptive 10 area_illumination on",
}
SIZE = {"width": 40, "height": 30, "extension": "exr"}


def light(area):
    return f"light_source {{ <4, 6, -4>, rgb 1 area_light {area} }}\n"


def shadow_rays(said):
    return int(re.search(r"Shadow Ray Tests:\s*(\d+)", said).group(1))


class AreaLight(rendering.RenderTest):
    def test_has_the_mean_of_all_points(self):
        samples = "blur_samples 512, 512 variance 0 "
        for name, area in LIGHTS.items():
            with self.subTest(name):
                world = light(area) + FLOOR + THINGS
                lens = rendering.render(scenes.camera("", 1e-6, samples) + world, **SIZE)
                pinhole = rendering.render(f"camera {{ {scenes.VIEW} }}\n" + world, "+A0.0", "+AM1", "+R7", "-J", **SIZE)
                hard = rendering.render(
                    f"camera {{ {scenes.VIEW} }}\n" + light("x*3, z*3, 1, 1") + FLOOR + THINGS, "+A0.0", "+AM1", "+R7", "-J", **SIZE
                )
                self.assert_near(lens, pinhole, 0.003, name)
                self.assert_different(hard, pinhole, 0.01, name)

    def test_takes_one_shadow_ray_in_place_of_the_grids(self):
        world = FLOOR + THINGS
        samples = "blur_samples 16, 16 variance 0 "
        told = {}
        for name, area in (("grid", "x*3, z*3, 5, 5 adaptive 10"), ("point", "x*3, z*3, 1, 1")):
            told[name] = rendering.render_and_listen(scenes.camera("", 0.2, samples) + light(area) + world, **SIZE)[1]
        self.assertLess(shadow_rays(told["grid"]), 1.2 * shadow_rays(told["point"]), told["grid"])

    def test_pinhole_keeps_the_grid(self):
        world = light("x*3, z*3, 3, 3 adaptive 10") + FLOOR + THINGS
        lens = rendering.render(scenes.camera("", 0) + world, **SIZE)
        pinhole = rendering.render(f"camera {{ {scenes.VIEW} }}\n" + world, **SIZE)
        self.assert_same(lens, pinhole, "pinhole")


if __name__ == "__main__":
    rendering.main()

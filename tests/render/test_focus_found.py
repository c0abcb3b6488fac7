# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Points of focus_on and focus_at are sharp."""

from tests.render import rendering, scenes
from tests.render.test_layers import Rendered

BALL = "#declare Ball = sphere { <0.3, 0.6, 0>, 0.6 }\n"
LENS = "focal_length 40 f_stop 0.2 scene_unit 900 "
SAMPLES = "blur_samples 8, 16 "
VIEW = "location <0.4, 1.5, -4> look_at <0, 0.5, 0.5> "


def camera(items, before="", samples=SAMPLES):
    return f"{before}camera {{ {VIEW}{samples}tilt_lens {{ {LENS}{items} }} }}\n"


class Found(rendering.RenderTest):
    def blur_at(self, text, x, y):
        return Rendered(text + scenes.WORLD, width=160, height=120).at("blur", int(160 * x), int(120 * (1 - y)))

    def test_a_place_is_sharp(self):
        for items in ("", "tilt 6 ", "tilt 3 swing -4 shift <3, 2> ", "focus_tilt 60 "):
            for x, y in ((0.503, 0.404), (0.203, 0.604), (0.803, 0.104)):
                with self.subTest(items=items, x=x, y=y):
                    self.assertLess(abs(self.blur_at(camera(f"{items}focus_at <{x}, {y}>"), x, y)), 0.5)

    def test_an_object_is_focused_as_by_its_point(self):
        way = [0.4 - 0.3, 1.5 - 0.6, -4.0]
        length = sum(w * w for w in way) ** 0.5
        point = [m + 0.6 * w / length for m, w in zip((0.3, 0.6, 0.0), way)]
        stated = f"focal_point <{point[0]!r}, {point[1]!r}, {point[2]!r}> "
        found = rendering.render(camera("tilt 4 focus_on Ball", BALL) + scenes.WORLD)
        self.assert_near(found, rendering.render(camera("tilt 4", samples=SAMPLES + stated) + scenes.WORLD), 1e-3)
        self.assert_different(found, rendering.render(camera("tilt 4 focus_scale 9") + scenes.WORLD), 1e-2)

    def test_threads_and_parts(self):
        text = camera("focal_points focus_on Ball, focus_at <0.8, 0.2>, focus_at <0.2, 0.6>", BALL) + scenes.WORLD
        self.assert_same_in_parts(text, first=11, last=22, width=40, height=30)


class Seed(rendering.RenderTest):
    def test_another_seed_is_other_noise_of_the_same_picture(self):
        lens, fixed = "tilt 4 focus_scale 5 denoise off ", "blur_samples 64 variance 0 "
        usual = rendering.render(camera(lens, samples=fixed) + scenes.WORLD)
        self.assert_same(rendering.render(camera(lens + "sample_seed 0", samples=fixed) + scenes.WORLD), usual)
        other = rendering.render(camera(lens + "sample_seed 4294967295", samples=fixed) + scenes.WORLD)
        self.assert_different(other, usual, 1e-4)
        self.assert_near(other, usual, 2e-2)
        threads = rendering.render(camera(lens + "sample_seed 4294967295", samples=fixed) + scenes.WORLD, "+WT2", "+BS8")
        self.assert_same(threads, other)


if __name__ == "__main__":
    rendering.main()

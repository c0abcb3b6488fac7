# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Pixels do not depend on threads, tiles, parts or preview."""

from tests.render import rendering, scenes

SIZE = {"width": 59, "height": 43}  # no multiple of any tile


class Repeatable(rendering.RenderTest):
    @classmethod
    def setUpClass(cls):
        cls.whole = rendering.render(scenes.TILTED, "+WT1", **SIZE)

    def check(self, *options):
        picture = rendering.render(scenes.TILTED, *options, **SIZE)
        self.assert_same(picture, self.whole, " ".join(options))

    def test_threads(self):
        for threads in (1, 2, 4):
            with self.subTest(threads=threads):
                self.check(f"+WT{threads}")

    def test_block_sizes(self):
        for size in (4, 8, 13, 32):
            with self.subTest(size=size):
                self.check("+WT2", f"+BS{size}")

    def test_render_patterns(self):
        for pattern in (0, 1, 3, 5):
            with self.subTest(pattern=pattern):
                self.check("+WT2", "+BS9", f"+RP{pattern}")

    def test_block_step(self):
        self.check("+WT2", "+BS9", "+RP1", "+RS3")

    def test_preview(self):
        for end in (1, 4):
            with self.subTest(end=end):
                self.check("+WT2", "+SP64", f"+EP{end}")

    def test_anti_aliasing_is_not_multiplied(self):
        for options in (["+A0.3"], ["+A0.05", "+AM2", "+R3", "+J"]):
            with self.subTest(options=options):
                self.check("+WT2", *options)

    def test_high_reproducibility(self):
        self.check("+WT2", "+HR")

    def test_other_tilt_is_another_picture(self):
        other = rendering.render(scenes.camera("tilt 3") + scenes.WORLD, **SIZE)
        self.assert_different(other, self.whole, 0.01)


class SubImages(rendering.RenderTest):
    @classmethod
    def setUpClass(cls):
        cls.whole = rendering.render(scenes.TILTED, "+WT2", **SIZE)

    def check(self, left, top, right, bottom, *options):
        part = rendering.render(scenes.TILTED, f"+SC{left}", f"+EC{right}", f"+SR{top}", f"+ER{bottom}", *options, **SIZE)
        place = (left - 1, top - 1, right, bottom)
        self.assert_same(part.crop(*place), self.whole.crop(*place), "sub-image")

    def test_odd_offsets(self):
        self.check(14, 7, 50, 37)

    def test_one_row(self):
        self.check(1, 30, 59, 30)

    def test_one_column(self):
        self.check(38, 1, 38, 43)

    def test_last_rows(self):
        self.check(1, 41, 59, 43, "+BS7")

    def test_the_rest_is_left_out(self):
        part = rendering.render(scenes.TILTED, "+SR20", "+ER30", **SIZE)
        self.assertEqual(set(part.crop(0, 0, 59, 19).values + part.crop(0, 30, 59, 43).values), {0.0}, part.told)


class OneSample(rendering.RenderTest):
    SCENE = scenes.camera(samples="blur_samples 1 ") + scenes.WORLD

    def test_threads_tiles_and_parts(self):
        whole = rendering.render(self.SCENE, "+WT1", **SIZE)
        self.assert_same(rendering.render(self.SCENE, "+WT2", "+BS13", **SIZE), whole, "tiles")
        part = rendering.render(self.SCENE, "+WT2", "+SC14", "+EC50", "+SR7", "+ER37", **SIZE)
        self.assert_same(part.crop(13, 6, 50, 37), whole.crop(13, 6, 50, 37), "sub-image")

    def test_is_nearer_to_the_truth_than_the_rays_alone(self):
        truth = rendering.render(scenes.camera(samples="blur_samples 400, 400 variance 0 ") + scenes.WORLD, **SIZE)
        plain = rendering.render(
            scenes.camera("tilt 4 swing 2 shift <2, -1> blades 5, 10 denoise off", samples="blur_samples 1 ") + scenes.WORLD, **SIZE
        )
        shown = rendering.render(self.SCENE, **SIZE)

        def error(picture):
            return sum((a - b) ** 2 for a, b in zip(picture.values, truth.values))

        self.assertLess(error(shown), 0.7 * error(plain))


class Animation(rendering.RenderTest):
    def test_clock_in_tilt(self):
        moving = scenes.camera("tilt clock swing clock/2 shift <clock, 0>") + scenes.WORLD
        still = scenes.camera("tilt 6 swing 3 shift <6, 0>") + scenes.WORLD
        self.assert_same(rendering.render(moving, "+K6"), rendering.render(still), "clock")


if __name__ == "__main__":
    rendering.main()

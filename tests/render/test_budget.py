# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""A budget is kept, and its pixels are repeatable."""

import pathlib
import re
import signal
import tempfile

from tests.render import rendering, scenes

SIZE = {"width": 89, "height": 67}  # no multiple of any tile


def scene(budget, lens="tilt 4 swing 2 shift <2, -1> blades 5, 10", world=scenes.WORLD, samples=""):
    return scenes.camera(f"{lens} budget {budget}", samples=samples) + world


LAMPS = (
    scenes.WORLD
    + """
#declare Seed = seed(3);
#for (I, 1, 30)
  sphere { <6*rand(Seed)-3, 2*rand(Seed), 6+9*rand(Seed)>, 0.02 pigment { rgb 1 } finish { emission 40 diffuse 0 } }
#end
"""
)


def numbers(said):
    budget = re.search(r"^ +Budget\.+\S+ samples a pixel, (\S+) taken \((\S+) in vain\)$", said, re.MULTILINE)
    mean = re.search(r"^ +Samples per pixel\.+mean ([\d.]+),", said, re.MULTILINE)
    variance = re.search(r"^ +variance\.+(\S+), chosen for this budget$", said, re.MULTILINE)
    error = re.search(r"^ +Standard error\.+(\S+) of white \(estimated\), (\S+) by the variance$", said, re.MULTILINE)
    speed = re.search(r"^ +speed\.+([1-9]\d*) samples a second$", said, re.MULTILINE)
    if not (budget and mean and variance and error and speed):
        raise AssertionError(said)
    return [float(number) for number in (budget[1], mean[1], variance[1], error[1], error[2])]


class Kept(rendering.RenderTest):
    def check(self, budget, text):
        _, said = rendering.render_and_listen(text, "+WT2", width=200, height=130)
        taken, mean, variance, error, target = numbers(said)
        self.assertLessEqual(taken, budget * 1.001, said)
        self.assertGreaterEqual(taken, 0.85 * budget, said)
        self.assertLessEqual(mean, taken + 0.05, said)
        self.assertAlmostEqual(target, variance**0.5, delta=0.06 * target)
        self.assertLess(error, target * 1.1, said)
        return error

    def test_blurred_board(self):
        self.assertLess(self.check(30, scene(30)), self.check(8, scene(8)))

    def test_wide_open_lens(self):
        self.check(16, scene(16, "tilt 0 f_stop 0.02 scene_unit 1").replace("aperture 0.3", ""))

    def test_lamps(self):
        self.check(12, scene(12, world=LAMPS))

    def test_lamps_that_are_searched(self):
        world = scenes.WORLD + scenes.painted()
        self.check(16, scene(16, world=world))
        self.assertIn("Lamps searched", rendering.render_and_listen(scene(16, world=world), **SIZE)[1])

    def test_without_denoising(self):
        self.check(24, scene(24, "tilt 4 denoise off"))


class Same(rendering.RenderTest):
    @classmethod
    def setUpClass(cls):
        cls.text = scene(8)
        cls.whole = rendering.render(cls.text, "+WT1", **SIZE)

    def test_threads(self):
        self.assert_same(rendering.render(self.text, "+WT3", "+BS13", **SIZE), self.whole, "three threads")

    def test_part(self):
        part = rendering.render(self.text, "+SC31", "+EC60", "+SR21", "+ER44", **SIZE)
        place = (30, 20, 60, 44)
        self.assert_same(part.crop(*place), self.whole.crop(*place), "sub-image")

    def test_other_budget_is_another_picture(self):
        self.assertNotEqual(rendering.render(scene(10), **SIZE).values, self.whole.values)

    def test_continued(self):
        large = {"width": 160, "height": 120}  # the signal comes in time
        with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
            folder = pathlib.Path(name)
            rendering.Job(self.text, ("+WT1", "+BS8"), **large).stop(folder, signal.SIGKILL, 8000)  # a few finished tiles
            again = rendering.Job(self.text, ("+WT2", "+BS8", "+C"), **large)
            said = again.run(folder)
            self.assert_same(again.result(folder), rendering.render(self.text, **large), "continued")
        self.assertIn("done before the render was continued", said)

    def test_the_variance_alone_gives_the_same_samples(self):
        _, said = rendering.render_and_listen(self.text, **SIZE)
        taken, mean, variance, error, _ = numbers(said)
        self.assertLessEqual(taken, 8, "a small picture, of which the trials are a large part")
        _, said = rendering.render_and_listen(scenes.camera(samples=f"variance {variance} ") + scenes.WORLD, **SIZE)
        alone = re.search(r"Samples per pixel\.+mean ([\d.]+),", said)
        self.assertAlmostEqual(float(alone[1]), mean, delta=0.02 * mean)
        self.assertIn(f"{error:.2g} of white", said)


class Told(rendering.RenderTest):
    def test_focus_aids_take_no_pilot(self):
        _, said = rendering.render_and_listen(scene(8, "tilt 4 focus_map"), **SIZE)
        self.assertIn("1, through the lens centre", said)
        self.assertNotIn("Budget", said)

    def test_pinhole(self):
        _, said = rendering.render_and_listen(scene(8).replace("aperture 0.3", ""), **SIZE)
        self.assertIn("budget has no effect in a camera without an aperture", re.sub(r"\s+", " ", said))

    def test_no_noise(self):
        _, said = rendering.render_and_listen(scene(30, world="background { rgb 0.5 }"), **SIZE)
        taken = numbers(said)[0]
        self.assertEqual(taken, 4.0, said)


if __name__ == "__main__":
    rendering.main()

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
from tests.focus import harness
from tests.focus.beside_page import BesidePage

BOXES = "return ['stage', 'other-stage'].map(id => document.getElementById(id).getBoundingClientRect().toJSON())"
OVER = "const { hidden, parentElement, className } = document.getElementById('truth'); return hidden ? '' : parentElement.id + className"
# Corners that show the scene.
CORNERS = """
const [width, height] = focusPage.live.size, nothing = [233, 233, 228];
const corners = [0, width - 1, width * (height - 1), width * height - 1];
const isEmpty = (pixels, corner) => nothing.every((value, i) => Math.abs(pixels[4 * corner + i] - value) <= 1);
return [focusPage.livePixels(), focusPage.otherPixels()].map(pixels => corners.filter(corner => !isEmpty(pixels, corner)).length);
"""


class TruthPage(BesidePage):
    def setUp(self):
        super().setUp()
        self.open_pair()
        self.choose("quality", 0)
        self.true_picture(160)


class Truth(TruthPage):
    def test_the_true_picture_is_over_the_picture_of_its_lens(self):
        self.assertEqual(self.run(OVER), "stage")
        self.assertNotIn("render again", self.text("true-said"))
        self.press("input[name=pair][value=A]")
        self.assertEqual(self.run(OVER), "other-stage")
        self.assertIn("Of lens B: render again for lens A.", self.text("true-said"))
        self.browser.refresh()
        self.until("the picture", lambda: self.drawn() and "Done" in self.text("true-said"))
        self.assertEqual(self.run(OVER), "other-stage")
        self.assertEqual(self.console(), [])


class OtherTruth(TruthPage):
    def test_the_true_picture_of_another_lens_is_named(self):
        self.press("input[name=pair][value=A]")
        self.press("#beside")
        self.assertEqual(self.run(OVER), "stageother", "alone, it is over the picture of another lens")
        self.assertIn("Of another lens: render again.", self.text("true-said"))
        self.press("#beside")
        self.press("input[name=pair][value=B]")
        self.set_number("fStop", 4)
        self.assertEqual(self.run(OVER), "stageother", "of neither lens")
        self.press("#render")
        self.until("the true picture", lambda: "Done" in self.text("true-said"))
        self.assertEqual(self.run(OVER), "stage")
        self.assertEqual(self.console(), [])


class Frames(BesidePage):
    def test_both_are_whole_where_one_is_shifted(self):
        self.open_pair()
        self.set_number("shiftUp", -6)
        self.set_number("shiftRight", -6)
        number = self.refined_sum()
        self.until("a preview of both frames", lambda: self.drawn() and self.run("return focusPage.previewSum()") != number)
        self.one_pass()
        self.assertEqual(self.run(CORNERS), [4, 4])
        self.assertEqual(self.console(), [])

    def test_beside_each_other_and_on_a_phone_one_above_the_other(self):
        self.open_pair()
        left, right = self.run(BOXES)[::-1]
        self.assertEqual(left["top"], right["top"])
        self.assertLess(left["right"], right["left"], "lens A is on the left, though B is shown")
        metrics = {"width": 360, "height": 780, "deviceScaleFactor": 1, "mobile": True}
        self.browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", metrics)
        self.addCleanup(self.browser.execute_cdp_cmd, "Emulation.clearDeviceMetricsOverride", {})
        upper, lower = self.run(BOXES)[::-1]
        self.assertLess(upper["bottom"], lower["top"])
        self.assertEqual(upper["left"], lower["left"])
        self.assertLessEqual(self.run("return document.documentElement.scrollWidth"), 360)
        self.assertGreater(upper["width"], 300)


if __name__ == "__main__":
    harness.main()

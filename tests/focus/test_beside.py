# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Two lenses side by side: each picture, its figures, its true picture, and what a reload keeps."""

from tests.focus import harness
from tests.focus.harness import PageTest

PLACES = ((-0.41, -0.41), (0.28, -0.055), (-0.03, 0.3))  # on the fronts of the three towers
NUMBERS = "const { tilt, fStop } = focusPage.model.numbers(); return [Math.round(1000 * tilt) / 1000, fStop]"
SHOWN = "return document.querySelector('input[name=pair]:checked').value"
# Name, numbers and blurs of the figures of the shown and of the other lens.
FIGURES = """
return ["figures", "other-figures"].map(id => {
    const place = document.getElementById(id);
    return [place.querySelector("b").textContent, place.childNodes[1].data.trim(), ...[...place.querySelectorAll("li")].map(li => li.textContent)];
});
"""
# Root mean square difference of two lists of pixels, relative to white.
RMSE = "const rmse = (a, b) => Math.sqrt(a.reduce((sum, x, i) => sum + ((x - b[i]) / 255) ** 2, 0) / (a.length * 3 / 4));\n"
BOXES = "return ['stage', 'other-stage'].map(id => document.getElementById(id).getBoundingClientRect().toJSON())"
OVER = "const { hidden, parentElement, className } = document.getElementById('truth'); return hidden ? '' : parentElement.id + className"
# Whether the left, lower corner of each picture shows the scene.
CORNERS = """
const at = 4 * focusPage.live.size[0] * (focusPage.live.size[1] - 1), [r, g, b] = [233, 233, 228];
return [focusPage.livePixels(), focusPage.otherPixels()].map(p => Math.abs(p[at] - r) + Math.abs(p[at + 1] - g) + Math.abs(p[at + 2] - b) > 8);
"""


class Beside(PageTest):
    def open_pair(self, scene=None):
        """Lens A through the three towers, lens B another one, side by side; B is shown."""
        self.open(scene or self.scene())
        self.set_number("fStop", 0.7)
        self.press("input[name=mode][value=three]")
        for place in PLACES:
            self.click_at(*place)
        self.press("#beside")
        self.assertEqual(self.run(FIGURES)[1][1:], self.run(FIGURES)[0][1:], "it begins as a copy")
        self.press("input[name=pair][value=B]")
        self.set_number("fStop", 2)
        self.set_number("tilt", 0)

    def test_each_picture_is_that_of_its_lens(self):
        self.open_pair()
        self.smooth()
        self.run("window.before = [focusPage.livePixels(), focusPage.otherPixels()]")
        self.press("input[name=pair][value=A]")
        self.smooth()
        script = "const [live, other] = [focusPage.livePixels(), focusPage.otherPixels()];"
        found = self.run(f"{RMSE}{script} return [rmse(before[0], other), rmse(before[1], live), rmse(live, other)]")
        self.assertLess(max(found[:2]), 0.003, found)
        self.assertGreater(found[2], 0.01, "both pictures are the same")
        (name, numbers, *blurs), (other, numbers_b, *blurs_b) = self.run(FIGURES)
        self.assertEqual((name, other), ("Lens A", "Lens B"))
        self.assertRegex(numbers, r"^tilt 4\.\d+°, swing 0\.\d+°, f/0\.7$")
        self.assertRegex(numbers_b, r"^tilt 0°, swing 0\.\d+°, f/2$")
        self.assertEqual(blurs, ["sharp"] * 3)
        points = self.run("return JSON.stringify(focusPage.model.picks)")
        self.press("input[name=pair][value=B]")
        script = """
            const [given, done] = arguments;
            import(new URL("page/lens.js", location)).then(({ blurOfPoint }) => {
                const { lens, width } = focusPage.model;
                done(JSON.parse(given).map(point => Math.abs(blurOfPoint(lens, point, width))));
            });
        """
        wanted = self.browser.execute_async_script(script, points)
        self.assertEqual(blurs_b[0], "sharp")
        for text, blur in zip(blurs_b[1:], wanted[1:], strict=True):
            self.assertAlmostEqual(float(text.removesuffix(" px")), blur, delta=0.006)
        self.assertEqual(self.console(), [])

    def test_a_click_into_the_other_picture_and_a_reload(self):
        self.open_pair()
        before = self.run("return [JSON.stringify(focusPage.model.state.picks), String(focusPage.model.numbers().fStop)]")
        self.run(
            """
            const picture = document.getElementById("other-picture"), { left, top, width, height } = picture.getBoundingClientRect();
            picture.dispatchEvent(new MouseEvent("click", { clientX: left + 0.78 * width, clientY: top + 0.62 * height, bubbles: true }));
        """
        )
        self.assertEqual((self.run(SHOWN), self.run(NUMBERS)[1]), ("A", 0.7))
        self.assertEqual(len(self.run("return focusPage.model.picks")), 3)
        state = self.run("return JSON.stringify(focusPage.model.state)")
        self.browser.refresh()
        self.until("the preview", self.drawn)
        self.smooth()
        self.assertEqual((self.run(SHOWN), self.run("return JSON.stringify(focusPage.model.state)")), ("A", state))
        self.assertTrue(self.run("return document.getElementById('beside').checked"))
        self.assertEqual([name for name, *_ in self.run(FIGURES)], ["Lens A", "Lens B"])
        self.assertIn("f/2", self.run(FIGURES)[1][1])
        self.element("picture").send_keys("s")
        self.assertTrue(self.run("return document.getElementById('other').hidden"))
        self.press("input[name=pair][value=B]")
        self.assertEqual(self.run("return [JSON.stringify(focusPage.model.state.picks), String(focusPage.model.numbers().fStop)]"), before)
        self.assertEqual(self.console(), [])

    def test_an_impossible_number_does_not_reach_the_other_side(self):
        self.open_pair()
        self.set_number("tilt", 95)
        self.press("input[name=pair][value=A]")
        self.assertIn("tilt 0°", self.run(FIGURES)[1][1])
        self.press("input[name=pair][value=B]")
        self.assertEqual(self.run(NUMBERS), [0, 2])
        self.assertEqual(self.console(), [])

    def test_the_true_picture_is_over_the_picture_of_its_lens(self):
        self.open_pair()
        self.choose("quality", 0)
        self.true_picture(160)
        self.assertEqual(self.run(OVER), "stage")
        self.assertNotIn("render again", self.text("true-said"))
        self.press("input[name=pair][value=A]")
        self.assertEqual(self.run(OVER), "other-stage")
        self.assertIn("Of lens B: render again for lens A.", self.text("true-said"))
        self.browser.refresh()
        self.until("the picture", lambda: self.drawn() and "Done" in self.text("true-said"))
        self.assertEqual(self.run(OVER), "other-stage")
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

    def test_both_are_whole_where_one_is_shifted(self):
        self.open_pair()
        self.set_number("shiftUp", -6)
        self.set_number("shiftRight", -6)
        number = self.run("return focusPage.previewSum()")
        self.until("a preview of both frames", lambda: self.drawn() and self.run("return focusPage.previewSum()") != number)
        self.smooth()
        self.assertEqual(self.run(CORNERS), [True, True])
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

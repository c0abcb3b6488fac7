# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Two lenses side by side."""

from tests.focus import harness
from tests.focus.beside_page import FIGURES, BesidePage

NUMBERS = "const { tilt, fStop } = focusPage.model.numbers(); return [Math.round(1000 * tilt) / 1000, fStop]"
SHOWN = "return document.querySelector('input[name=pair]:checked').value"
RMSE = "const rmse = (a, b) => Math.sqrt(a.reduce((sum, x, i) => sum + ((x - b[i]) / 255) ** 2, 0) / (a.length * 3 / 4));\n"


class Pictures(BesidePage):
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


class Sides(BesidePage):
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
        self.one_pass()
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


if __name__ == "__main__":
    harness.main()

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The page's knobs, and impossible lenses."""

from tests.focus import harness
from tests.focus.harness import ONE_LENS, PageTest


class Knobs(PageTest):
    def test_each_knob_changes_the_lens_and_the_text(self):
        self.open(self.scene())
        self.press("input[name=form][value=angles]")
        for knob, value, numbers in (
            ("tilt", 6, "m.numbers().tilt"),
            ("swing", -3, "m.numbers().swing"),
            ("focusTilt", 40, "m.numbers().focus.tilt"),
            ("focusSwing", 10, "m.numbers().focus.swing"),
            ("fStop", 1.8, "m.lens.focalLength / m.lens.diameter"),
            ("angle", 60, "m.numbers().angle"),
            ("focalLength", 35, "m.numbers().focalLength"),
            ("sceneUnit", 50, "1 / m.lens.millimetre"),
            ("shiftRight", 4, "m.block.shift[0]"),
            ("shiftUp", -2, "m.block.shift[1]"),
            ("blades", 5, "m.block.blades"),
            ("bladesAngle", 20, "m.block.bladesAngle"),
        ):
            with self.subTest(knob):
                before = self.text("block")
                self.set_number(knob, value)
                self.assertAlmostEqual(self.run(f"const m = focusPage.model; return {numbers}"), value, places=6)
                self.assertAlmostEqual(float(self.run("return document.getElementById(arguments[0]).value", knob)), value, places=3)
                if knob != "bladesAngle" or "blades" in self.text("block"):
                    self.assertNotEqual(self.text("block"), before)
                self.assertRegex(self.text("block"), r"^(\w+ .+\n)*tilt_lens \{\n(  .+\n)+\}$")
        self.assertEqual(self.console(), [])

    def test_what_cannot_be_is_said_beside_the_knob(self):
        self.open(self.scene())
        said = "return document.querySelector('[data-said=' + arguments[0] + ']').textContent"
        self.set_number("tilt", 95)
        self.assertIn("less than 90", self.run(said, "turn"))
        self.assertTrue(self.run("return document.getElementById('render').disabled"))
        self.set_number("tilt", 5)
        self.assertEqual(self.run(said, "turn"), "")
        self.set_number("focalLength", 500000)
        self.assertIn("focal length", self.run(said, "focalLength"))
        self.set_number("focalLength", 50)
        self.choose("real", 1)
        self.set_number("tilt", 12)
        self.assertIn("8.5", self.run(said, "turn"))
        self.set_number("shiftUp", 15)
        self.assertIn("12 mm", self.run(said, "shift"))
        self.set_number("fStop", 2)
        self.assertIn("f/3.5", self.run(said, "fStop"))
        self.assertEqual(self.console(), [])

    def test_plane_through_the_lens_has_a_remark_beside_the_points(self):
        self.open(self.scene())
        self.press("input[name=mode][value=three]")
        self.choose("third", "upright")
        # a vertical plane through both points contains the lens
        self.run("focusPage.model.pick([0, 0, 1])")
        before = self.run("return focusPage.model.lens.focus")
        self.run("focusPage.model.pick([0, 0, -1])")
        said = "return document.querySelector('[data-said=points]').textContent"
        self.assertIn("passes through the lens", self.run(said))
        self.assertTrue(self.run("return [...document.querySelectorAll('#points button')].every(p => p.className === 'bad')"))
        self.assertEqual(self.run("return focusPage.model.lens.focus"), before, "the picture stays that of the last lens")
        self.click_at(0.3, -0.3)
        self.assertEqual(self.run(said), "")
        self.assertNotEqual(self.run("return focusPage.model.lens.focus"), before)
        self.assertEqual(self.run(ONE_LENS), [])

    def test_sliders_and_lists_turn_the_lens_too(self):
        self.open(self.scene())
        slide = """
        const slider = document.getElementById(arguments[0]).previousElementSibling, before = focusPage.model.lens;
        slider.value = Number(slider.min) + 0.7 * (slider.max - slider.min);
        slider.dispatchEvent(new Event("input"));
        slider.dispatchEvent(new Event("change"));
        return JSON.stringify(before) !== JSON.stringify(focusPage.model.lens);
        """
        for knob in ("tilt", "swing", "fStop", "angle", "focalLength", "focusTilt", "focusSwing", "sceneUnit", "shiftRight", "shiftUp"):
            with self.subTest(knob):
                self.assertTrue(self.run(slide, knob))
                self.assertEqual(self.run(ONE_LENS), [])
        for name, value, width in (("film", 7, 127), ("real", 1, 36)):
            self.choose(name, value)
            self.assertAlmostEqual(self.run("return focusPage.model.block.filmWidth"), width, places=6)
            self.assertEqual(self.run(f"return document.getElementById('{name}').value"), str(value))
        self.assertAlmostEqual(self.run("return focusPage.model.numbers().focalLength"), 24, places=9)


if __name__ == "__main__":
    harness.main()

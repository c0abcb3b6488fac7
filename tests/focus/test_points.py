# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Adding, moving and removing points."""

from tests.focus import harness
from tests.focus.more_page import PLACES, MorePage


class Points(MorePage):
    def test_points_are_added_moved_and_removed(self):
        from selenium.webdriver.common.keys import Keys

        self.open(self.scene())
        self.click_all(PLACES[:3])
        self.assertEqual([blur for blur, _ in self.rows()], [0, 0, 0])
        self.assertIn("focal_plane", self.as_plane())
        self.click_at(*PLACES[3])
        self.hold(0.1)
        held = self.run("return focusPage.model.block.fStop")
        self.element("points").find_elements("tag name", "button")[3].send_keys(Keys.ARROW_UP)
        self.assertNotEqual(self.run("return focusPage.model.block.fStop"), held, "the f-stop follows the point")
        self.set_number("fStop", 2)
        self.assertFalse(self.run("return document.getElementById('hold').checked"), "a number that was set by hand stays")
        self.assertEqual(self.run("return focusPage.model.block.fStop"), 2)
        self.press("#back")
        self.assertTrue(self.run("return document.getElementById('hold').checked"))
        self.press("#sharp-points li:last-child button")
        self.assertEqual(len(self.rows()), 3)
        self.element("points").find_elements("tag name", "button")[0].send_keys(Keys.DELETE)
        self.assertEqual(len(self.rows()), 2)
        self.press("input[name=mode][value=three]")
        self.assertEqual(len(self.run("return focusPage.model.picks")), 2, "the other kinds of points keep them")
        self.assertEqual(self.console(), [])

    def as_plane(self):
        self.press("input[name=form][value=plane]")
        return self.text("block")

    def test_the_limits_have_a_word(self):
        self.open(self.scene())
        self.click_all(PLACES[:2])
        said = "return document.querySelector('[data-said=' + arguments[0] + ']').textContent"
        self.run("const m = focusPage.model, [a, b] = m.picks; m.pick(a.map((x, i) => 0.7 * x + 0.3 * b[i]))")
        self.assertIn("on one line", self.run(said, "points"))
        self.press("#sharp-points li:last-child button")
        self.run("for (let i = 2; i < 100; i++) focusPage.model.pick([Math.cos(i), 0.02 * i, 2 * Math.sin(7 * i)])")
        self.assertEqual(self.run(said, "points"), "")
        self.run("focusPage.model.pick([0, 0, 0])")
        self.assertIn("100 points are the most", self.run(said, "points"))
        self.assertEqual(len(self.rows()), 100)
        self.set_number("within", "0")
        self.assertIn("0 is refused", self.run(said, "within"))
        self.set_number("within", "2,5")
        self.assertEqual(self.run("return focusPage.model.within"), 2.5)


if __name__ == "__main__":
    harness.main()

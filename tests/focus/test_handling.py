# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Dragged points, directions, copied text, another width."""

import re

from tests.focus import harness
from tests.focus.harness import TOWERS, PageTest


class Handling(PageTest):
    def test_the_third_point_may_be_a_direction(self):
        self.open(self.scene())
        self.press("input[name=mode][value=three]")
        for third, normal in (("level", "x"), ("upright", "y")):
            self.choose("third", third)
            for x, y in TOWERS[:2]:
                self.click_at(x, y)
            lean = self.run("return focusPage.model.lens.focus[arguments[0]]", "xyz".index(normal))
            self.assertAlmostEqual(lean, 0, places=9)
        self.choose("third", "film")
        self.assertRegex(self.run("return JSON.stringify(focusPage.model.numbers())"), r'"tilt":0,"swing":0')

    def test_points_can_be_dragged_and_moved_by_keys(self):
        from selenium.webdriver import ActionChains
        from selenium.webdriver.common.keys import Keys

        self.open(self.scene())
        before = self.pick_towers()
        point = self.browser.find_element("css selector", "#points button")
        ActionChains(self.browser, duration=0).click_and_hold(point).move_by_offset(60, 20).release().perform()
        dragged = self.run("return focusPage.model.picks")
        self.assertNotEqual(dragged[0], before[0])
        self.assertEqual(dragged[1:], before[1:])
        point.send_keys(Keys.ARROW_RIGHT)
        self.assertNotEqual(self.run("return focusPage.model.picks[0]"), dragged[0])
        self.press("#back")
        self.press("#back")
        self.assertEqual(self.run("return focusPage.model.picks"), before)

    def stays_smooth_at(self, width):
        self.smooth()
        passes = "return focusPage.live.passes"
        smooth = self.run(passes)
        drawn = "return document.getElementById('side').viewBox.baseVal.width"
        before = self.run(drawn)
        self.browser.set_window_size(width, 1000)
        self.until("the side view", lambda: self.run(drawn) != before)
        return self.run(passes) == smooth

    def test_another_width_of_the_page_leaves_the_picture_and_draws_the_side_view_anew(self):
        self.open(self.scene())
        self.addCleanup(self.browser.set_window_size, 1280, 1000)
        # edges may become smooth meanwhile, but not again and again
        self.assertTrue(any(self.stays_smooth_at(width) for width in 5 * (700, 1280)))

    def test_copied_text_is_the_block(self):
        address = self.open(self.scene())
        origin = re.match(r"http://[^/]+", address).group()
        permissions = {"origin": origin, "permissions": ["clipboardReadWrite", "clipboardSanitizedWrite"]}
        self.browser.execute_cdp_cmd("Browser.grantPermissions", permissions)
        self.press("#copy")
        self.until("the copy", lambda: "Copied" in self.text("file-said"))
        copied = self.browser.execute_async_script("navigator.clipboard.readText().then(arguments[0])")
        self.assertEqual(copied, self.text("block"))

    def test_keyboard_alone_picks_a_point(self):
        from selenium.webdriver.common.keys import Keys

        self.open(self.scene())
        picture = self.element("picture")
        before = self.run("return focusPage.model.picks")
        picture.send_keys(Keys.ARROW_LEFT, Keys.ARROW_DOWN, Keys.ENTER)
        self.assertNotEqual(self.run("return focusPage.model.picks"), before)


if __name__ == "__main__":
    harness.main()

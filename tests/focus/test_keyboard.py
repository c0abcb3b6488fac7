# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Keys reach, focus and operate every control."""

from selenium.webdriver import ActionChains
from selenium.webdriver.common.keys import Keys

from tests.focus import harness
from tests.focus.harness import PageTest

MOST_STOPS = 80  # for one way through the page

WANTED = """
const name = e => e.id || e.name || e.textContent;
return [...document.querySelectorAll("button, input, select, a[href], [tabindex]")]
    .filter(e => !e.disabled && e.checkVisibility() && !(e.type === "radio" && !e.checked)).map(name);
"""
FOCUSED = """
const e = document.activeElement, seen = e.type === "radio" ? e.nextElementSibling : e;
return [e === document.body ? null : e.id || e.name || e.textContent, getComputedStyle(seen).outlineStyle !== "none"];
"""


class Keyboard(PageTest):
    def keys(self, *keys, hold=None):
        chain = ActionChains(self.browser, duration=0)
        if hold:
            chain.key_down(hold)
        for key in keys:
            chain.send_keys(key)
        if hold:
            chain.key_up(hold)
        chain.perform()

    def tab_to(self, name):
        for _ in range(MOST_STOPS):
            self.keys(Keys.TAB)
            if self.run(FOCUSED)[0] == name:
                return
        self.fail(f"Tab does not reach {name}")

    def test_tab_reaches_all_controls_visibly(self):
        self.open(self.scene())
        self.true_picture(160)  # adds a slider and a link
        wanted = self.run(WANTED)
        for name in ("picture", "wipe", "mode", "third", "form", "copy", "save", "tilt", "real", "back"):
            self.assertEqual(name in wanted, name not in ("third", "back"), name)
        reached = []
        for _ in range(MOST_STOPS):
            self.keys(Keys.TAB)
            name, seen = self.run(FOCUSED)
            if name is None:
                break
            self.assertTrue(seen, f"{name} has the focus and nothing shows it")
            reached.append(name)
        self.assertLessEqual(set(wanted), set(reached))

    def test_from_a_scene_without_a_lens_to_three_sharp_places(self):
        scene = self.scene()
        self.open(scene)
        self.tab_to("mode")
        self.keys(Keys.ARROW_RIGHT)
        self.assertEqual(self.run("return focusPage.model.mode"), "three")
        self.tab_to("picture")
        self.assertFalse(self.run("return document.getElementById('cross').hidden"), "the cross shows where Enter picks")
        self.assertIn("Arrow keys", self.text("hint"))
        for steps in (9 * [Keys.ARROW_LEFT] + 9 * [Keys.ARROW_DOWN], 16 * [Keys.ARROW_RIGHT] + 9 * [Keys.ARROW_UP], 9 * [Keys.ARROW_LEFT]):
            self.keys(*steps, hold=Keys.SHIFT)
            self.keys(Keys.ARROW_UP, Keys.ENTER)
        picks = self.run("return focusPage.model.picks")
        self.assertEqual(len(picks), 3)
        off = self.run("return focusPage.model.picks.map(p => focusPage.model.offPlane(p))")
        self.assertLess(max(map(abs, off)), 1e-9)
        self.tab_to("fStop")
        self.keys("a", hold=Keys.CONTROL)
        self.keys("1", Keys.TAB)
        self.assertEqual(self.run("return focusPage.model.block.fStop"), 1)
        self.tab_to("write")
        self.keys(Keys.ENTER)
        self.until("the change", lambda: "Written" in self.text("file-said"))
        self.assertIn("focal_plane", scene.read_text())

    def test_step_back_has_its_usual_key(self):
        self.open(self.scene())
        before = self.run("return focusPage.model.picks")
        self.click_at(-0.4, -0.4)
        self.assertNotEqual(self.run("return focusPage.model.picks"), before)
        self.keys("z", hold=Keys.CONTROL)
        self.assertEqual(self.run("return focusPage.model.picks"), before)


if __name__ == "__main__":
    harness.main()

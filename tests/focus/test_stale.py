# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""A true picture of another lens is marked."""

from tests.focus import harness
from tests.focus.harness import SCENE, PageTest

OTHER = "Of another lens: render again."


class Stale(PageTest):
    def is_other(self):
        dimmed = self.run("return getComputedStyle(document.getElementById('truth')).filter !== 'none'")
        self.assertEqual(dimmed, OTHER in self.text("true-said"))
        return dimmed

    def test_the_picture_of_another_lens_says_so(self):
        address = self.open(self.scene(SCENE.replace("angle 45", "angle 45 focal_point <0, 1, 0> tilt_lens { scene_unit 100 f_stop 8 }")))
        self.set_number("fStop", 1)
        self.choose("quality", 0)
        self.true_picture(160)
        self.assertFalse(self.is_other())
        for knob, value in (("fStop", 2), ("tilt", 3), ("shiftUp", 1), ("angle", 50)):
            self.set_number(knob, value)
            self.assertTrue(self.is_other(), knob)
            self.press("#back")
            self.assertFalse(self.is_other(), f"{knob} as before")
        self.set_number("fStop", 16)
        # a later page starts with the scene's own lens
        self.browser.get(address)
        self.until("the preview", self.drawn)
        self.until("the picture", lambda: "Done" in self.text("true-said"))
        self.assertTrue(self.is_other())
        self.set_number("fStop", 1)
        self.assertFalse(self.is_other(), "the lens of the picture")
        self.set_number("fStop", 4)
        self.press("#render")
        self.until("the new picture", lambda: "Done" in self.text("true-said"))
        self.assertFalse(self.is_other())
        self.assertEqual(self.console(), [])


if __name__ == "__main__":
    harness.main()

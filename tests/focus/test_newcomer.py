# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Clicks in an exporter's scene make five points sharp."""

import re

from selenium.webdriver.common.by import By

from tests.focus import harness
from tests.focus.more_page import MorePage

# four towers on a floor; a matrix places the camera
EXPORTER = (
    """// exported
#version 3.7;
global_settings { assumed_gamma 1.0 }
background { rgb <0.6, 0.7, 0.9> }
"""
    + harness.exported_camera("7.35889, -6.92579, 4.95831")
    + """light_source { <4, -1, 9>, rgb 1.2 }
plane { z, 0  pigment { checker rgb 0.8 rgb 0.4 scale 0.5 } }
box { <1.2, -3.3, 0>, <1.8, -2.7, 0.6>  pigment { rgb <0.8, 0.3, 0.2> } }
box { <2.9, -1.5, 0>, <3.5, -0.9, 1.4>  pigment { rgb <0.3, 0.6, 0.3> } }
box { <-0.8, -1.8, 0>, <-0.2, -1.2, 0.9>  pigment { rgb <0.9, 0.8, 0.3> } }
box { <0.2, 1.2, 0>, <0.8, 1.8, 1.8>  pigment { rgb <0.3, 0.4, 0.8> } }
"""
)
# places and heights of the towers' tops and the floor
PLACES = {(-0.156, -0.192): 0.6, (0.184, -0.022): 1.4, (-0.154, 0.108): 0.9, (0.141, 0.346): 1.8, (0, 0.01): 0}
SIZE = (320, 180)
WITHIN = 1  # pixels: what the page proposes
STEP = 2 ** (1 / 6)  # between the f-numbers of a ring: a third of a stop


class Newcomer(MorePage):
    def click(self, selector):
        self.browser.find_element(By.CSS_SELECTOR, selector).click()

    def greatest(self, scene):
        stop, blurs, _ = self.reported(scene, SIZE)
        self.assertEqual(len(blurs), len(PLACES))
        return max(abs(blur) for blur, _ in blurs), stop

    def test_five_points_are_sharp_at_the_widest_aperture(self):
        scene = self.scene(EXPORTER)
        self.open(scene, *(f"+{name}{side}" for name, side in zip("WH", SIZE)))
        self.click("#where label:last-of-type")
        for x, y in PLACES:
            self.click_at(x, y)
        for pick, height in zip(self.run("return focusPage.model.picks"), PLACES.values(), strict=True):
            self.assertAlmostEqual(pick[2], height, delta=0.02)
        self.click("#holding label")
        self.click("#write")
        self.until("the change", lambda: "ritten" in self.text("file-said"))
        self.assertIn("Written", self.text("file-said"))
        written = scene.read_text()
        blur, stop = self.greatest(scene)
        self.assertLessEqual(blur, WITHIN + 0.005)
        layer = abs(harness.rendered(scene, self.folder, SIZE, "+N")["blur"])
        for x, y in PLACES:
            self.assertLess(layer[int((0.5 - y) * SIZE[1]), int((x + 0.5) * SIZE[0])], WITHIN + 0.1)
        self.assertGreater(layer.max(), 2 * WITHIN, "nothing is blurred")
        wider, count = re.subn(r"sharp_within \S+", f"f_stop {stop / STEP:.6f}", written)
        self.assertEqual(count, 1)
        blur, _ = self.greatest(self.scene(wider, "wider.pov"))
        self.assertGreater(blur, WITHIN * 1.05)
        self.assertEqual(self.console(), [])

    def test_the_copied_text_makes_the_same_lens(self):
        self.open(self.scene(EXPORTER), *(f"+{name}{side}" for name, side in zip("WH", SIZE)))
        self.click_all(PLACES)
        self.click("#holding label")
        self.click("#copy")
        self.until("the trial", lambda: "tried" in self.text("file-said"))
        self.assertIn("tried there, it makes this lens", self.text("file-said"))
        pasted = self.scene(EXPORTER.replace("  matrix", self.text("block") + "\n  matrix"), "pasted.pov")
        blur, stop = self.greatest(pasted)
        self.assertLessEqual(blur, WITHIN + 0.005)
        self.assertAlmostEqual(stop, self.run("return focusPage.model.block.fStop"), delta=1e-3 * stop)


if __name__ == "__main__":
    harness.main()

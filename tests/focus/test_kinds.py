# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Scenes with several cameras, a clock, or a lens."""

from tests.focus import harness
from tests.focus.harness import SCENE, PageTest

LENS = "tilt_lens { scene_unit 20 f_stop 1.4 focus_tilt 30 blades 6, 10 shift <2, 1> }"


class Kinds(PageTest):
    def test_a_scene_with_a_lens_begins_with_it(self):
        self.open(self.with_lens(LENS))
        numbers = self.run("return focusPage.model.numbers()")
        self.assertAlmostEqual(numbers["focus"]["tilt"], 30, places=6)
        self.assertAlmostEqual(numbers["fStop"], 1.4)
        self.press("input[name=form][value=angles]")
        for word in ("scene_unit 20", "f_stop 1.4", "blades 6, 10", "shift <2, 1>", "tilt "):
            self.assertIn(word, self.text("block"))

    def test_several_cameras_can_be_chosen(self):
        second = "camera { location <6, 2, -6> look_at <0, 0.5, 0> right x*image_width/image_height angle 50 }\n"
        self.open(self.scene(SCENE + second))
        choices = self.run("return [...document.getElementById('camera').options].map(o => o.textContent)")
        self.assertEqual(len(choices), 2)
        self.assertEqual(self.run("return focusPage.model.camera.location"), [6, 2, -6])
        self.choose("camera", 0)
        self.until("the other camera", lambda: self.drawn() and self.run("return focusPage.model.camera.location[2]") == -7)
        self.until("its preview", lambda: self.run("return focusPage.live.location[2]") == -7)
        self.assertEqual(self.console(), [])

    def test_the_clock_moves_the_scene(self):
        self.open(self.scene(SCENE + "sphere { <0, 1, -3>, 0.1 + 0.6*clock pigment { rgb x } }\n"))
        self.assertFalse(self.run("return document.getElementById('clock-choice').hidden"))
        before = self.refined_sum()
        self.choose("clock", 1)
        self.until("the moved scene", lambda: abs(self.run("return focusPage.previewSum()") - before) > 10)

    def test_camera_without_lens_has_a_message(self):
        self.browser.get(self.start(self.scene(SCENE.replace("camera {", "camera { orthographic")), *harness.SMALL))
        self.until("the message", lambda: "not perspective" in self.message())

    def test_a_picture_of_other_proportions_gets_its_own_height(self):
        self.open(self.scene(SCENE.replace("x*image_width/image_height", "x*2")), "+W160")
        self.assertEqual(self.run("return focusPage.live.size"), [160, 80])

    def test_what_the_pictures_leave_out_is_said(self):
        self.open(self.scene())
        self.assertEqual(self.text("left-out"), "")
        self.end()
        self.open(self.with_lens("tilt_lens { f_stop 1 } bokeh { pigment { rgb 1 } } normal { bumps 0.1 }"))
        self.assertIn("the camera's bokeh picture and normal; a render", self.text("left-out"))

    def test_other_items_stay_in_the_block(self):
        scene = self.with_lens("tilt_lens { f_stop 2 denoise off budget 12 focus_peaking rgb <1, 0, 0>, 2 }")
        self.open(scene)
        self.set_number("tilt", 3)
        for item in ("denoise off", "budget 12", "focus_peaking rgb <1, 0, 0>, 2"):
            self.assertIn(f"\n  {item}\n", self.text("block"))
        self.press("#write")
        self.until("the change", lambda: "Written" in self.text("file-said"))
        self.assertIn("denoise off\n    budget 12\n    focus_peaking rgb <1, 0, 0>, 2\n  }", scene.read_text())
        self.true_picture(160)  # with denoise, without the tint; with a budget, the picture's own variance would be refused
        self.smooth()
        self.assertLess(self.run(harness.DIFFERENCE)["rmse"], 0.05)


if __name__ == "__main__":
    harness.main()

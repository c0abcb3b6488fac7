# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Scenes of all kinds on the page: with errors, changed on the disk, with several cameras, a clock, a lens of their own."""

import os

from tests.focus import harness
from tests.focus.harness import SCENE, PageTest

LENS = "tilt_lens { scene_unit 20 f_stop 1.4 focus_tilt 30 blades 6, 10 shift <2, 1> }"


class Changes(PageTest):
    def with_lens(self, block):
        """The scene with a block of its own."""
        return self.scene(SCENE.replace("  angle 45\n", f"  angle 45\n  {block}\n"))

    def message(self):
        """The error on the page, if any."""
        return self.run("const m = document.getElementById('message'); return m.hidden ? '' : m.textContent")

    def test_error_has_its_line_and_disappears_when_mended(self):
        scene = self.scene(SCENE.replace("angle 45", "angle forty"))
        self.browser.get(self.start(scene, *harness.SMALL))
        self.until("the error", self.message)
        self.assertIn("scene.pov, line 7", self.message())
        self.assertIn("angle forty", self.message())
        scene.write_text(SCENE)
        self.until("the preview", self.drawn)
        self.assertEqual(self.message(), "")
        self.assertEqual(self.console(), [])

    def test_a_changed_file_is_shown_anew_and_keeps_the_lens(self):
        scene = self.scene(SCENE + '#include "more.inc"\n')
        (self.folder / "more.inc").write_text("// nothing\n")
        self.open(scene)
        self.set_number("tilt", 5)
        before = self.run("return focusPage.previewSum()")
        (self.folder / "more.inc").write_text("background { rgb 1 } plane { y, 2.9 hollow pigment { rgb <0, 0, 1> } }\n")
        self.until("the new preview", lambda: self.drawn() and abs(self.run("return focusPage.previewSum()") - before) > 1000)
        self.assertEqual(self.text("status"), "more.inc changed: this is the new preview.")
        self.assertAlmostEqual(self.run("return focusPage.model.numbers().tilt"), 5)

    def test_a_scene_with_a_lens_begins_with_it(self):
        self.open(self.with_lens(LENS))
        numbers = self.run("return focusPage.model.numbers()")
        self.assertAlmostEqual(numbers["focus"]["tilt"], 30, places=6)
        self.assertAlmostEqual(numbers["fStop"], 1.4)
        self.press("input[name=form][value=angles]")
        for word in ("scene_unit 20", "f_stop 1.4", "blades 6, 10", "shift <2, 1>", "tilt "):
            self.assertIn(word, self.text("block"))

    def test_what_would_be_a_guess_is_not_written(self):
        for block, said in (
            ("#if (1) tilt_lens { f_stop 2 } #end", "has another"),
            ("tilt_lens { #if (1) f_stop 2 denoise off #end }", "directives"),
        ):
            scene = self.with_lens(block)
            text = scene.read_text()
            with self.subTest(block):
                self.open(scene)
                self.set_number("tilt", 3)
                self.press("#write")
                self.until("an answer", lambda: self.text("file-said"))
                if "Written" in self.text("file-said"):  # the program found the wanted lens in it
                    self.assertNotEqual(said, "directives")
                    self.press("#undo")
                    self.until("the undoing", lambda: "is as it was" in self.text("file-said"))
                else:
                    self.assertIn("Not written", self.text("file-said"))
                self.assertEqual(scene.read_text(), text)
                self.assertEqual([p.name for p in self.folder.iterdir() if "before-focus" in p.name], [])
                self.end()

    def test_other_items_stay_in_the_block(self):
        scene = self.with_lens("tilt_lens { f_stop 2 denoise off focus_peaking rgb <1, 0, 0>, 2 }")
        self.open(scene)
        self.set_number("tilt", 3)
        for item in ("denoise off", "focus_peaking rgb <1, 0, 0>, 2"):
            self.assertIn(f"\n  {item}\n", self.text("block"))
        self.press("#write")
        self.until("the change", lambda: "Written" in self.text("file-said"))
        self.assertIn("denoise off\n    focus_peaking rgb <1, 0, 0>, 2\n  }", scene.read_text())
        self.true_picture(160)  # with denoise, without the tint
        self.smooth()
        self.assertLess(self.run(harness.DIFFERENCE)["rmse"], 0.05)

    def test_undo_keeps_what_somebody_else_has_changed(self):
        scene = self.scene()
        self.open(scene)
        self.press("#write")
        self.until("the change", lambda: "Written" in self.text("file-said"))
        self.assertEqual((self.folder / "scene.pov.before-focus").read_text(), SCENE)
        scene.write_text(scene.read_text() + "// mine\n")
        self.press("#undo")
        self.until("the refusal", lambda: "somebody else" in self.text("file-said"))
        self.assertTrue(scene.read_text().endswith("// mine\n"))

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

    def test_removed_camera_disappears(self):
        second = "camera { location <6, 2, -6> look_at <0, 0.5, 0> right x*image_width/image_height angle 50 }\n"
        scene = self.scene(SCENE + second)
        self.open(scene)
        self.choose("camera", 1)
        self.until("the other camera", lambda: self.drawn() and self.run("return focusPage.live.location[2]") == -6)
        scene.write_text(SCENE)
        self.until("the camera that is left", lambda: self.drawn() and self.run("return focusPage.live.location[2]") == -7)
        self.press("#write")
        self.until("the change", lambda: "Written" in self.text("file-said"))

    def test_the_clock_moves_the_scene(self):
        self.open(self.scene(SCENE + "sphere { <0, 1, -3>, 0.1 + 0.6*clock pigment { rgb x } }\n"))
        self.assertFalse(self.run("return document.getElementById('clock-choice').hidden"))
        before = self.run("return focusPage.previewSum()")
        self.choose("clock", 1)
        self.until("the moved scene", lambda: abs(self.run("return focusPage.previewSum()") - before) > 10)

    def test_camera_without_lens_has_a_message(self):
        self.browser.get(self.start(self.scene(SCENE.replace("camera {", "camera { orthographic")), *harness.SMALL))
        self.until("the message", lambda: "not perspective" in self.message())

    def test_a_picture_of_other_proportions_gets_its_own_height(self):
        self.open(self.scene(SCENE.replace("x*image_width/image_height", "x*2")), "+W160")
        self.assertEqual(self.run("return focusPage.live.size"), [160, 80])

    def test_a_broken_line_is_made_anew_and_keeps_the_lens(self):
        watch = "window.lines = []; WebSocket = class extends WebSocket { constructor(...a) { super(...a); lines.push(this); } };"
        made = self.browser.execute_cdp_cmd("Page.addScriptToEvaluateOnNewDocument", {"source": watch})
        self.addCleanup(self.browser.execute_cdp_cmd, "Page.removeScriptToEvaluateOnNewDocument", made)
        self.open(self.scene())
        self.set_number("tilt", 5)
        # acts as after 1006, the code of a broken connection, which cannot be sent on purpose
        self.run("const [line] = lines, { onclose } = line; line.onclose = line.onmessage = null; line.close(); onclose({ code: 1006 })")
        self.until("a new line", lambda: self.run("return lines.length > 1 && lines[1].readyState === 1") and self.drawn())
        self.assertEqual(self.message(), "")
        self.assertAlmostEqual(self.run("return focusPage.model.numbers().tilt"), 5)
        self.set_number("fStop", 1)
        self.press("#write")
        self.until("an answer over the new line", lambda: "Written" in self.text("file-said"))

    def test_what_the_pictures_leave_out_is_said(self):
        self.open(self.scene())
        self.assertEqual(self.text("left-out"), "")
        self.end()
        self.open(self.with_lens("tilt_lens { f_stop 1 } bokeh { pigment { rgb 1 } } normal { bumps 0.1 }"))
        self.assertIn("the camera's bokeh picture and normal; a render", self.text("left-out"))

    def test_ended_program_has_a_message(self):
        self.open(self.scene())
        self.end()
        self.until("the message", lambda: "has ended" in self.message())
        os.stat(self.folder)


if __name__ == "__main__":
    harness.main()

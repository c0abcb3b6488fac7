# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""A block that cannot be replaced precedes a second camera."""

from tests.focus import harness
from tests.focus.harness import SCENE, TOWERS, PageTest

SIZE = (160, 90)
QUALITY = "  angle 45\n  blur_samples 4\n"


class BehindPage(PageTest):
    def with_items(self, items, before=""):
        text = SCENE.replace("  angle 45\n", f"{QUALITY}  {items}\n").replace("camera {", f"{before}camera {{")
        return self.scene(text), text

    def write(self):
        self.press("#write")
        self.until("an answer", lambda: "ritten" in self.text("file-said"))
        return self.text("file-said")

    def focus_on_towers(self):
        self.pick_towers()
        self.set_number("fStop", 0.7)
        self.set_number("sceneUnit", 100)

    def check(self, scene):
        blur = harness.rendered(scene, self.folder, SIZE, "+N", f"+L{self.folder}")["blur"]
        for x, y in TOWERS:
            self.assertLess(abs(blur[int((0.5 - y) * SIZE[1]), int((x + 0.5) * SIZE[0])]), 0.3, f"{x}, {y}")
        self.assertGreater(abs(blur).max(), 2, "nothing is blurred")


class Replaced(BehindPage):
    def test_the_new_block_is_written_behind_the_old_one(self):
        (self.folder / "lens.inc").write_text("tilt_lens { f_stop 2 }\n")
        for items, before in (
            ("tilt_lens { #if (1) f_stop 2 #else f_stop 4 #end }", ""),
            ("#if (1) tilt_lens { f_stop 2 } #else tilt_lens { f_stop 4 } #end", ""),
            ("My_Lens(2) rotate 3*y scale 2", "#macro My_Lens(N) tilt_lens { f_stop N } #end\n"),
            ('#include "lens.inc"', ""),
        ):
            scene, text = self.with_items(items, before)
            with self.subTest(items):
                self.open(scene)
                self.focus_on_towers()
                for form in ("angles", "points"):  # the second time, the new block is replaced
                    self.press(f"input[name=form][value={form}]")
                    self.assertIn("Written", self.write())
                    changed = scene.read_text()
                    self.assertIn(items, changed)
                    self.assertEqual(changed.count("Focus_Camera_1"), 2)
                    self.assertNotIn("Focus_Camera_2", changed)
                    self.until("the preview", lambda: "this is the new preview" in self.text("status"))
                    self.check(scene)
                self.press("#undo")
                self.until("the undoing", lambda: "as it was before" in self.text("file-said"))
                self.assertEqual(scene.read_text().count("focal_plane"), 1)
                self.end()


class Kept(BehindPage):
    def test_what_would_be_lost_is_not_written(self):
        scene, text = self.with_items("My_Lens(2)", "#macro My_Lens(N) tilt_lens { f_stop N denoise off } #end\n")
        self.open(scene)
        self.set_number("tilt", 3)
        self.assertIn("Not written: the camera's tilt_lens block comes from a macro or another file.", self.write())
        self.assertEqual(scene.read_text(), text)

    def test_a_chosen_camera_stays_the_chosen_one(self):
        scene, text = self.with_items("tilt_lens { #if (1) f_stop 2 #end }")
        scene.write_text(text + "camera { location <6, 2, -6> look_at <0, 0.5, 0> right x*image_width/image_height angle 50 }\n")
        self.open(scene)
        chosen = "return [document.getElementById('camera').value, focusPage.model.camera.location[2], focusPage.live.location[2], focusPage.model.block.fStop]"
        self.choose("camera", 0)
        self.until("the other camera", lambda: self.drawn() and self.run(chosen) == ["0", -7, -7, 2])
        self.set_number("fStop", 1)
        self.assertIn("Written", self.write())
        self.until("the written camera", lambda: self.drawn() and self.run(chosen) == ["1", -7, -7, 1])
        self.press("#undo")
        self.until("the undoing", lambda: "as it was before" in self.text("file-said"))
        self.until("the camera as it was", lambda: self.drawn() and self.run(chosen)[:3] == ["0", -7, -7])


if __name__ == "__main__":
    harness.main()

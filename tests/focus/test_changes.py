# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Changing scenes, and a broken connection."""

import argparse
import asyncio
import itertools
import os
from unittest import mock

from tests.focus import harness
from tests.focus.harness import SCENE, FocusTest, PageTest
from tools.focus.options import Options
from tools.focus.scene_file import SceneFile
from tools.focus.session import Session

# Previews arrive as late as the test wants; answers about the file at once.
LATE_PREVIEWS = """
    window.late = null;
    WebSocket = class extends WebSocket {
        set onmessage(take) {
            super.onmessage = event => {
                const message = typeof event.data === "string" ? JSON.parse(event.data) : {};
                if (late && message.type !== "file")
                    late.push({ message, deliver: () => take(event) });
                else
                    take(event);
            };
        }
    };
"""


class Changes(PageTest):
    def run_before_pages(self, script):
        made = self.browser.execute_cdp_cmd("Page.addScriptToEvaluateOnNewDocument", {"source": script})
        self.addCleanup(self.browser.execute_cdp_cmd, "Page.removeScriptToEvaluateOnNewDocument", made)

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

    def test_writing_and_undoing_faster_than_previews_keeps_the_lens(self):
        self.run_before_pages(LATE_PREVIEWS)
        self.open(self.scene())
        self.set_number("tilt", 5)
        self.run("window.late = []")
        scenes = "return late.filter(({ message }) => message.type === 'scene').length"
        for number, (button, said) in enumerate((("write", "Written"), ("undo", "is as it was"))):
            self.press(f"#{button}")
            self.until("the change", lambda said=said: said in self.text("file-said"))
            self.until("its scene", lambda number=number: self.run(scenes) > number)
        self.run("const held = late; late = null; held.forEach(({ deliver }) => deliver())")
        self.until("the preview", self.drawn)
        self.assertAlmostEqual(self.run("return focusPage.model.numbers().tilt"), 5)

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

    def test_a_broken_line_is_made_anew_and_keeps_the_lens(self):
        watch = """
            window.lines = [], window.clocks = [];
            WebSocket = class extends WebSocket {
                constructor(...a) {
                    super(...a);
                    lines.push(this);
                    this.addEventListener("message", ({ data }) => typeof data === "string" && clocks.push(JSON.parse(data).clock));
                }
            };
        """
        self.run_before_pages(watch)
        self.open(self.scene(SCENE.replace("location <0,", "location <clock,")))
        self.choose("clock", 0.5)
        self.until("the other place", lambda: self.drawn() and self.run("return focusPage.model.camera.location[0]") == 0.5)
        self.set_number("tilt", 5)
        self.run("window.clocks = []")
        # 1006 is the code of a broken connection, which cannot be sent on purpose
        self.run("const [line] = lines, { onclose } = line; line.onclose = line.onmessage = null; line.close(); onclose({ code: 1006 })")
        self.until("a new line", lambda: self.run("return lines.length > 1 && lines[1].readyState === 1"))
        self.until("the same clock", lambda: self.run("return clocks.includes(0.5)") and self.drawn())
        self.assertEqual(self.run("return focusPage.model.camera.location[0]"), 0.5)
        self.assertEqual(self.message(), "")
        self.assertAlmostEqual(self.run("return focusPage.model.numbers().tilt"), 5)
        self.set_number("fStop", 1)
        self.press("#write")
        self.until("an answer over the new line", lambda: "Written" in self.text("file-said"))

    def test_ended_program_has_a_message(self):
        self.open(self.scene())
        self.end()
        self.until("the message", lambda: "has ended" in self.message())
        os.stat(self.folder)


class ChangedBeforeItIsRead(FocusTest):
    def test_the_preview_starts_anew(self):
        options = Options([*harness.SMALL])
        settings = argparse.Namespace(scene=str(self.scene()), program=harness.SETTINGS.povray, options=options, lenses={})
        messages = []

        async def show():
            session = Session(settings, self.folder / "tmp")
            session.connect(messages.append)
            await session.previews[0].task

        with mock.patch.object(SceneFile, "stamp", side_effect=itertools.chain(["before"], itertools.repeat("after"))):
            asyncio.run(show())
        told = [message for message in messages if isinstance(message, dict)]
        self.assertEqual([message["stamp"] for message in told if message["type"] == "scene"], ["after"])
        self.assertEqual(told[-1]["type"], "refined")


if __name__ == "__main__":
    harness.main()

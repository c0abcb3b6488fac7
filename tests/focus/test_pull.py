# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Focus pulls: marked lenses, film, and text."""

import json

from tests.focus import harness
from tests.focus.harness import EXPORTED, SCENE, SETTINGS, PageTest
from tools import povray_run
from tools.focus.messages import BadRequest, read

NEAR, FAR = (-0.41, -0.41), (-0.03, 0.3)  # on the fronts of two towers
THREE = (NEAR, (0.28, -0.055), FAR)
LENS = ("planeNormal", "planeDistance", "fStop")
PULL_AT = """
const [keys, times, done] = arguments;
import(new URL("page/pull.js", location)).then(({ pullAt }) => done(times.map(time => pullAt(keys, time, focusPage.model.camera.location))));
"""
KEPT = "return JSON.parse(atob(location.hash.slice(1).replaceAll('-', '+').replaceAll('_', '/'))).keys"


class PullPage(PageTest):
    def open_pull(self, scene, *words):
        self.open(scene, *words)
        self.press("#pull summary")

    def move_clock(self, value):
        script = "const e = document.getElementById('time'); e.value = arguments[0]; for (const n of ['input', 'change']) e.dispatchEvent(new Event(n))"
        self.run(script, value)

    def mark_two(self):
        self.move_clock(0.2)
        self.set_number("fStop", 0.7)
        self.click_at(*NEAR)
        self.press("#mark")
        self.move_clock(0.8)
        self.press("input[name=mode][value=three]")
        for place in THREE:
            self.click_at(*place)
        self.set_number("fStop", 2)
        self.press("#mark")

    def answer(self, button):
        self.press(button)
        self.until("an answer", lambda: any(word in self.text("pull-said") for word in ("tried there", "could not", "ritten")))
        return self.text("pull-said")

    def block_at(self, scene, clock):
        record, library = self.folder / "record.json", [povray_run.INCLUDE]
        command = povray_run.command(SETTINGS.povray, scene, None, (16, 9), f"+K{clock}", "+SR1", "+ER1", library=library)
        povray_run.run(command, self.folder, povray_run.environment(TILT_LENS_PREVIEW=str(record))).succeeded()
        return json.loads(record.read_text())["view"]["block"]


class Written(PullPage):
    def test_the_written_pull_is_the_film_of_the_page(self):
        scene = self.scene()
        self.open_pull(scene)
        self.mark_two()
        self.assertIn("Tilt_Lens_Pull(clock, <0, 3, -7>)", self.text("pull-text"))
        self.assertIn("tried there", self.answer("#pull-copy"))
        self.assertEqual(scene.read_text(), SCENE)
        keys, times = self.run(KEPT), (0, 0.2, 0.35, 0.5, 0.7, 0.8, 1)
        self.assertIn("Written", self.answer("#pull-write"))
        here = self.browser.execute_async_script(PULL_AT, keys, times)
        self.assertNotEqual(here[1], here[5])
        for time, page in zip(times, here):
            there = self.block_at(scene, time)
            for name in LENS:
                for a, b in zip(*([value] if not isinstance(value, list) else value for value in (page[name], there[name]))):
                    self.assertAlmostEqual(a, b, delta=1e-5 * max(1, abs(b)), msg=f"{name} at {time}")
        self.until("the new preview", lambda: "new preview" in self.text("status") and self.drawn())
        self.run(
            "window.noted = 0; const model = focusPage.model, { note } = model; model.note = view => { window.noted++; note.call(model, view); }"
        )
        self.move_clock(0.5)
        self.set_number("fStop", 5)
        self.until("the camera of this time", lambda: self.run("return window.noted"))
        self.assertEqual(self.run("return focusPage.model.block.fStop"), 5, "the lens being chosen stays")
        self.press("#mark")
        self.assertIn("Written", self.answer("#pull-write"))
        self.assertEqual(scene.read_text().count("Tilt_Lens_Key_Points"), 3)
        self.assertAlmostEqual(self.block_at(scene, 0.5)["fStop"], 5)
        self.press("#undo")
        self.until("the undoing", lambda: scene.read_text().count("Tilt_Lens_Key_Points") == 2)
        self.assertEqual(self.console(), [])

    def test_only_keys_end_up_in_the_scene(self):
        self.open_pull(self.scene())
        self.mark_two()
        self.run(
            "window.sent = []; const { send } = WebSocket.prototype; WebSocket.prototype.send = function (t) { window.sent.push(t); send.call(this, t); }"
        )
        self.answer("#pull-copy")
        (good,) = [text for text in map(json.loads, self.run("return window.sent")) if text["do"] == "pull"]
        self.assertEqual(read(json.dumps(good))[0], "pull")
        for name, bad in {
            "another file": {"head": good["head"].replace("tilt_lens.inc", "other.inc")},
            "a directive": {"head": good["head"] + '#fopen F "a" write\n'},
            "one key": {"head": good["head"][: good["head"].rindex("Tilt_Lens_Key")]},
            "another macro": {"block": good["block"].replace("Tilt_Lens_Pull(clock", "Other(clock")},
            "no check": {"checks": []},
        }.items():
            with self.subTest(name), self.assertRaises(BadRequest):
                read(json.dumps({**good, **bad}))


class Film(PullPage):
    def test_film_is_played_live_and_leaves_the_lens(self):
        self.open_pull(self.scene())
        self.assertTrue(self.run("return document.getElementById('pull-part').hidden"), "two marks are needed")
        self.mark_two()
        self.move_clock(0.2)
        near = self.run("return focusPage.model.block")
        self.assertAlmostEqual(near["fStop"], 0.7)
        self.move_clock(0.5)
        state, drawings = self.run("return JSON.stringify(focusPage.model.state)"), self.run("return focusPage.drawings")
        self.run(
            """
            window.seen = [];
            const { changed } = focusPage.model;
            focusPage.model.changed = () => { window.seen.push(focusPage.model.block.fStop); changed(); };
        """
        )
        self.press("#play")
        self.until("the end of the film", lambda: self.text("play") == "Play")
        seen = self.run("return window.seen")
        self.assertAlmostEqual(seen[0], 0.7, delta=0.1)
        self.assertEqual(seen[:-1], sorted(seen[:-1]), "the f-stop grows from key to key")
        self.assertGreater(seen[-2], 1.5)
        self.assertGreater(self.run("return focusPage.drawings"), drawings)
        self.assertEqual(self.run("return JSON.stringify(focusPage.model.state)"), state)
        self.press("#play")
        self.press("#play")
        self.assertEqual(self.run("return JSON.stringify(focusPage.model.state)"), state, "stopped in the middle")
        self.browser.refresh()
        self.until("the preview", self.drawn)
        rows = self.run("return [...document.querySelectorAll('#keys li')].map(e => e.firstChild.textContent)")
        self.assertEqual(rows, ["clock 0.2: f/0.7", "clock 0.8: f/2"])
        self.press("#keys li:first-child button:last-child")
        self.assertEqual(len(self.run(KEPT)), 1)
        self.assertEqual(self.console(), [])

    def test_a_camera_with_transformations(self):
        scene = self.scene(EXPORTED)
        self.open_pull(scene)
        for time, place in ((0, (-0.1, -0.42)), (1, (0.1, 0.2))):
            self.move_clock(time)
            self.click_at(*place)
            self.set_number("tilt", 3 * time)
            self.press("#mark")
        self.assertIn("tried there", self.answer("#pull-copy"))

    def test_a_camera_that_moves_is_refused(self):
        scene = self.scene(SCENE.replace("location <0, 3, -7>", "location <clock, 3, -7>"))
        self.open_pull(scene)
        first = self.run("return focusPage.model.camera.location[0]")
        self.click_at(*NEAR)
        self.press("#mark")
        self.move_clock(1)
        self.until("the other place", lambda: self.drawn() and self.run("return focusPage.model.camera.location[0]") != first)
        self.click_at(*FAR)
        self.press("#mark")
        self.assertIn("Not written: the changed scene would have another location", self.answer("#pull-write"))
        self.assertNotIn("Tilt_Lens", scene.read_text())


if __name__ == "__main__":
    harness.main()

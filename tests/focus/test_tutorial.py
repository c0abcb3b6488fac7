# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Three clicks in tutorial scenes leave less than half a pixel of blur."""

import re
import shutil

from tests.focus import harness
from tests.focus.harness import ROOT, PageTest

SCENES = sorted((ROOT / "scenes" / "tutorial").glob("*.pov"))
QUICK = ("three_points",)  # the others take too long for each run of the tests
SIZE = (480, 270)
PLACES = ((-0.28, -0.36), (0.31, -0.27), (0.02, 0.01), (-0.2, -0.05), (0.1, -0.42))
NOT_WRITTEN = {"aperture": "directives", "macros": "macro"}
UNITS = {"shift": 50}  # millimetres in a unit of a scene that is too large for blur

PICKED = """
return [...document.querySelectorAll("#points button")].map(point =>
    [point.style.left, point.style.top].map((part, i) => Math.floor(parseFloat(part) / 100 * focusPage.live.size[i])));
"""


class Tutorial(PageTest):
    def pick_three(self):
        for mode in ("one", "three"):  # without the points of the scene's own block
            self.press(f"input[name=mode][value={mode}]")
        for place in PLACES:
            self.click_at(*place)
            if self.run("return focusPage.model.picks.length === 3 && !focusPage.model.error"):
                return self.run(PICKED)
        state = "const { picks, error, mode, third } = focusPage.model; return JSON.stringify({ picks, error, mode, third });"
        return self.fail(f"no three places: {self.run(state)}")

    def test_one_scene(self):
        self.check_scenes([scene for scene in SCENES if scene.stem in QUICK])

    def test_other_scenes(self):
        self.assertGreater(len(SCENES), 6)
        self.check_scenes([scene for scene in SCENES if scene.stem not in QUICK])

    def check_scenes(self, scenes):
        for original in scenes:
            with self.subTest(original.stem):
                scene = self.folder / original.name
                shutil.copy(original, scene)
                self.open(scene, "+W480", "+H270")
                self.set_number("fStop", 1)
                if original.stem in UNITS:
                    self.set_number("sceneUnit", UNITS[original.stem])
                picked = self.pick_three()
                self.assertEqual(self.run("return focusPage.live.size"), list(SIZE))
                self.press("#write")
                self.until("an answer", lambda: self.text("file-said"))
                said = self.text("file-said")
                if "Written" not in said:
                    self.assertIn(NOT_WRITTEN.get(original.stem, "no reason"), said)
                    self.put_in_by_hand(scene)
                self.end()
                self.check(scene, picked)
        self.assertEqual(self.console(), [])

    def put_in_by_hand(self, scene):
        camera = self.run("return focusPage.describe('plane').expect.camera")
        vectors = "".join(f"  {name} <{', '.join(map(repr, value))}>\n" for name, value in camera.items())
        version = re.search(r"#version [^;]+;", scene.read_text()).group()
        behind = f"{version}\ncamera {{\n  perspective\n{vectors}  {self.text('block')}\n}}\n"
        with scene.open("a") as stream:
            stream.write(behind)

    def check(self, scene, picked):
        blur = harness.rendered(scene, self.folder, SIZE, "+N")["blur"]
        for column, row in picked:
            self.assertLess(abs(blur[row, column]), 0.5, f"{column}, {row} of {scene.name}")
        self.assertGreater(abs(blur).max(), 2, "nothing is blurred")


if __name__ == "__main__":
    harness.main()

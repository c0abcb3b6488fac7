# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Blur and f-stop of many points, compared with the report."""

import re

from tests.focus import harness
from tests.focus.harness import SCENE
from tests.focus.more_page import PLACES, WITHIN, MorePage


class Sharp(MorePage):
    def written(self, scene):
        """Copying tries the block, and writes it."""
        self.press("#copy")
        self.until("the trial", lambda: "tried" in self.text("file-said"))
        self.assertIn("tried there, it makes this lens", self.text("file-said"))
        self.press("#write")
        self.until("the change", lambda: "ritten" in self.text("file-said"))
        self.assertIn("Written", self.text("file-said"))
        return scene.read_text()

    def compare(self, scene, size):
        stop, blurs, without = self.reported(scene, size)
        shown = self.rows()
        self.assertEqual([binds for _, binds in shown], [binds for _, binds in blurs])
        for (here, _), (there, _) in zip(shown, blurs, strict=True):
            self.assertAlmostEqual(here, there, delta=0.006 + 1e-3 * abs(there))
        self.assertAlmostEqual(self.run("return focusPage.model.block.fStop"), stop, delta=1e-3 * stop)
        return stop, blurs, without

    def test_blur_and_f_stop_are_those_of_the_report(self):
        scene = self.scene()
        self.open(scene)
        self.click_all()
        self.assertEqual(sum(binds for _, binds in self.rows()), 4)
        self.hold()
        self.assertRegex(self.text("block"), r"sharp_points (<[^>]+>,\s+){4}<[^>]+>\n  sharp_within 1.5\n")
        self.assertNotIn("f_stop", self.text("block"))
        self.assertIn("sharp_within", self.written(scene))
        stop, blurs, without = self.compare(scene, (160, 90))
        self.assertAlmostEqual(max(abs(blur) for blur, _ in blurs), WITHIN, delta=1e-3)
        said = re.search(
            r"^f/([\d.]+) is the widest that keeps all within 1.5 px. A lens without tilt needs f/([\d.]+) ", self.text("sharp-said")
        )
        for shown, found in zip(map(float, said.groups()), (stop, without)):
            self.assertAlmostEqual(shown, found, delta=5e-3 * found)
        layer = abs(harness.rendered(scene, self.folder, (160, 90), "+N")["blur"])
        for x, y in PLACES:
            self.assertLess(layer[int((0.5 - y) * 90), int((x + 0.5) * 160)], WITHIN + 0.3)
        self.assertEqual(self.console(), [])

    def test_a_scene_with_sharp_points_begins_with_them(self):
        for limit in ("sharp_within 2", "circle_of_confusion 0.45"):  # the same, in pixels and in millimetres
            items = f"sharp_points <-2, 0.3, -2>, <1.7, 0.6, 0>, <0, 1, 2>, <2, 0, -1.5> {limit}"
            scene = self.scene(SCENE.replace("  angle 45\n", f"  angle 45\n  tilt_lens {{ scene_unit 20 {items} }}\n"))
            with self.subTest(limit):
                self.open(scene)
                self.assertEqual(self.run("const { mode, hold, within } = focusPage.model; return [mode, hold, within]"), ["more", True, 2])
                self.compare(scene, (160, 90))
                self.assertIn(items, " ".join(self.text("block").split()))
                self.assertIn(limit, self.written(scene))
                self.end()


if __name__ == "__main__":
    harness.main()

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Clicks on three points make them sharp in the written scene."""

from tests.focus import harness
from tests.focus.harness import SCENE, TOWERS, PageTest


# Distances in a pixel of the next preview and in another, before and after its end.
FIND_WHILE_PREVIEW_ARRIVES = """
const done = arguments[0], frame = focusPage.model.lens, { location } = focusPage.model.camera, size = [4, 4];
const newBlur = () => ({
    values: new Float32Array(64).fill(1 / 5), width: 4, height: 4, frame: { ...frame, location },
    begin(width, height) { Object.assign(this, { width, height, values: new Float32Array(4 * width * height) }); },
    take(left, top, width, height, values) { this.values.set(values); },
    draw() {},
});
import(new URL("page/live.js", document.location)).then(({ Live }) => {
    const begun = asked => {
        const live = new Live(newBlur(), focusPage.model, () => {}, () => {});
        live.ownView = { ...frame, location };
        live.expect({ number: 1, frame: asked, size });
        live.take({ number: 1, left: 0, top: 0, width: 1, height: 1, values: new Float32Array(4).fill(1 / 10) });
        return live;
    };
    const distances = live => [[-0.4, 0.4], [0.1, -0.1]].map(([x, y]) => live.surfaceAt(x, y)).map(point => point &&
        point.reduce((sum, value, i) => sum + (value - location[i]) * frame.axis[i], 0));
    const live = begun({ ...frame, location }), found = { arriving: distances(live), readAnew: distances(begun(null)) };
    live.end();
    done({ ...found, ended: distances(live) });
}).catch(error => done({ arriving: [0, String(error)] }));
"""


class Page(PageTest):
    def test_three_clicks_make_a_lens_that_is_sharp_there(self):
        scene = self.scene()
        self.open(scene)
        self.set_number("fStop", 0.7)
        picks = self.pick_towers()
        for pick, depth in zip(picks, (-2, 0, 2)):
            self.assertAlmostEqual(pick[2], depth, delta=0.02)
        self.press("input[name=form][value=points]")
        self.assertRegex(self.text("block"), r"focal_points <[^>]+>, <[^>]+>, <[^>]+>")
        for form in ("points", "plane", "angles"):
            with self.subTest(form):
                self.press(f"input[name=form][value={form}]")
                self.press("#write")
                self.until("the change", lambda: "Written" in self.text("file-said") or "Not" in self.text("file-said"))
                self.assertIn("Written", self.text("file-said"))
                size = (160, 90)
                blur = harness.rendered(scene, self.folder, size, "+N")["blur"]
                for x, y in TOWERS:
                    found = blur[int((0.5 - y) * size[1]), int((x + 0.5) * size[0])]
                    self.assertLess(abs(found), 0.1, f"{x}, {y}")
                self.assertGreater(abs(blur).max(), 0.6, "nothing is blurred")
                self.press("#undo")
                self.until("the undoing", lambda: "is as it was" in self.text("file-said"))
                self.assertEqual(scene.read_text(), SCENE)
        self.assertEqual(self.console(), [])

    def test_true_picture_and_live_picture_agree(self):
        self.open(self.scene())
        self.set_number("fStop", 0.7)
        self.pick_towers()
        self.true_picture(160)
        self.smooth()
        error = self.run(harness.DIFFERENCE)
        self.assertLess(error["rmse"], 0.05)
        self.assertGreater(error["sharp"], 1.3 * error["rmse"], "a sharp picture is not as near")
        self.assertEqual(self.console(), [])

    def test_one_click_focuses_there_and_keeps_the_tilt(self):
        self.open(self.scene())
        self.set_number("tilt", 4)
        self.click_at(*TOWERS[0])
        state = self.run("return [focusPage.model.numbers().tilt, focusPage.model.offPlane(focusPage.model.picks[0])]")
        self.assertAlmostEqual(state[0], 4)
        self.assertAlmostEqual(state[1], 0)

    def test_surfaces_are_found_while_a_new_preview_arrives(self):
        self.open(self.scene())
        found = self.browser.execute_async_script(FIND_WHILE_PREVIEW_ARRIVES)
        here, before = found["arriving"]
        self.assertAlmostEqual(here / before, 2, places=6)
        self.assertEqual(found["ended"], [here, None])
        self.assertEqual(found["readAnew"], [here, None])


if __name__ == "__main__":
    harness.main()

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Joined bands equal one render, or are refused."""

import os
import time

from tests.batch import calls
from tests.batch.calls import LENS, STOCK, BatchTest, picture

SIZE = ("+W100", "+H75", "+WT1")

JITTER = calls.STOCK.replace("light_source { <-4, 9, -5>, rgb 1 }", "light_source { <-4, 9, -5>, rgb 1 area_light x, z, 3, 3 jitter }")
RADIOSITY = calls.STOCK.replace("assumed_gamma 1", "assumed_gamma 1 radiosity { count 20 }")


class Exact(BatchTest):
    def compare(self, text, name, bands, *words):
        scene = self.scene(text)
        self.batch("still", scene, "--output", name, "--bands", bands, "--workers", 4, *SIZE, *words)
        self.assert_same(self.folder / name, self.whole(scene, self.folder / name, *SIZE, *words))

    def test_png_8_bits(self):
        self.compare(LENS, "lens.png", 2, "+FN")

    def test_png_16_bits_with_alpha_cut_anywhere(self):
        text = LENS.replace("sky_sphere", "#declare Unused = sky_sphere")
        self.compare(text, "lens.png", 5, "+FN16", "+UA")

    def test_exr(self):
        self.compare(LENS, "lens.exr", 3, "+FE")

    def test_stock_scene_with_its_anti_aliasing(self):
        self.compare(STOCK, "stock.png", 3, "+FN", "+AM1", "+A0.1")

    def test_scene_with_a_date_in_the_future(self):
        scene = self.scene(LENS)
        os.utime(scene, (time.time() + 1e6, time.time() + 1e6))
        self.batch("still", scene, "--output", "a.png", "--bands", 2, "--retries", 0, *SIZE)
        self.assert_same(self.folder / "a.png", self.whole(scene, self.folder / "a.png", "+FN", *SIZE))

    def test_two_threads(self):
        scene = self.scene(LENS)
        self.batch("still", scene, "--output", "a.png", "--bands", 2, "+W100", "+H75", "+WT2")
        self.assert_same(self.folder / "a.png", self.whole(scene, self.folder / "a.png", "+FN", *SIZE))


class NotCut(BatchTest):
    def test_pixels_that_depend_on_their_rows_are_refused(self):
        for text, said in ((RADIOSITY, "radiosity"), (JITTER, "jitter"), (STOCK, "rendered with them")):
            words = ("+AM1", "+A0.1") if text is STOCK else ()
            bands = 7 if text is STOCK else 2
            told = self.batch("still", self.scene(text), "--bands", bands, "--anew", *SIZE, *words, code=1)
            self.assertIn(said, told)
            self.assertIn("--bands 1", told)
            self.assertFalse(list(self.folder.glob("*.png")))

    def test_whole_pictures_of_such_scenes(self):
        self.batch("still", self.scene(RADIOSITY), "--bands", 1, *SIZE)
        self.assertEqual(picture(self.folder / "scene.png")[:2], (100, 75))


if __name__ == "__main__":
    calls.main()

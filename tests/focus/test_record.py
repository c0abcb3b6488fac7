# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""TILT_LENS_PREVIEW records cameras and renders a pinhole."""

import json
import os
import subprocess

from tests.focus import harness
from tests.focus.harness import SCENE, SETTINGS, FocusTest
from tools import povray_run

LENS = "tilt_lens { scene_unit 10 f_stop 0.7 focus_tilt 30 shift <2, 1> }"
SIZE = (160, 90)
PINHOLE = LENS.replace("f_stop 0.7 ", "")


class Record(FocusTest):
    def render(self, items, preview=True):
        scene = self.scene(SCENE.replace("  angle 45\n", f"  angle 45\n  {items}\n"))
        record, picture = self.folder / "record.json", self.folder / "picture.png"
        record.unlink(missing_ok=True)
        env = povray_run.environment(**({"TILT_LENS_PREVIEW": str(record)} if preview else {}))
        povray_run.run(povray_run.command(SETTINGS.povray, scene, picture, SIZE, "+WL0"), self.folder, env).succeeded()
        self.assertEqual(record.exists(), preview)
        told = subprocess.run(["oiiotool", "--info", "--hash", str(picture)], capture_output=True, text=True, check=True).stdout
        return told.split("SHA-1: ")[1].split()[0], json.loads(record.read_text()) if preview else None

    def test_preview_is_a_pinholes_for_any_blur(self):
        sharp, _ = self.render("", False)
        shifted, _ = self.render(PINHOLE, False)
        self.assertNotEqual(sharp, shifted)
        for items, wanted in (
            (LENS, shifted),
            (LENS.replace("}", "focus_map }"), shifted),
            (PINHOLE + " aperture 0.5 blur_samples 16", shifted),
            (PINHOLE + " aperture 0.5 bokeh { pigment { rgb 1 } }", shifted),
            ("aperture 0.5 focal_point 0 blur_samples 16", sharp),
            ("", sharp),
        ):
            with self.subTest(items):
                self.assertEqual(self.render(items)[0], wanted)
                if items:
                    self.assertNotEqual(self.render(items, False)[0], wanted, "nothing was blurred in the picture itself")

    def test_the_record_tells_the_camera(self):
        _, record = self.render(LENS + " bokeh { pigment { rgb 1 } } normal { bumps 0.1 }")
        (camera,) = record["cameras"]
        self.assertEqual((camera["bokeh"], camera["normal"], camera["perspective"]), (True, True, True))
        self.assertEqual(os.path.basename(camera["file"]), "scene.pov")
        block = camera["block"]
        self.assertEqual((block["family"], block["focusTilt"], block["fStop"], block["shift"]), ("focusTurn", 30, 0.7, [2, 1]))
        self.assertEqual(record["view"]["block"], block, "told before the lens is taken away")
        _, record = self.render("tilt_lens { sharp_points <1, 0, 2>, <-1, 0, 2>, <0, 1, 3>, <0, -1, 4> circle_of_confusion 0.03 }")
        block = record["view"]["block"]
        self.assertEqual((block["family"], block["sharpWithin"]), ("sharp", 0.03))
        self.assertEqual(block["sharpPoints"], [[1, 0, 2], [-1, 0, 2], [0, 1, 3], [0, -1, 4]])
        self.assertGreaterEqual(block["fStop"], 0.5)
        self.assertIn("sharp_points", record["view"]["words"])
        _, record = self.render("aperture 0.5 focal_point 0")
        self.assertEqual((record["view"]["block"], record["view"]["aperture"]), (None, 0.5))


if __name__ == "__main__":
    harness.main()

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The preview of another focus resembles the render."""

import argparse
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

from tools import povray_run

SETTINGS = argparse.Namespace(povray="povray", refocus="refocus")
SCENE = """#version 3.7;
global_settings { assumed_gamma 1 }
#ifndef (Stop) #declare Stop = 64; #end
#ifndef (At) #declare At = 9; #end
camera { location <0, 2, -6> right x*image_width/image_height look_at <0, 0.5, 3> focal_point <0, 0, At> angle 40
  tilt_lens { tilt 3 f_stop Stop scene_unit 50 } blur_samples 32, 128 variance 1/20000 }
light_source { <-4, 9, -5>, rgb 1 }
background { rgb <0.3, 0.5, 0.8> }
plane { y, 0 pigment { checker rgb 0.9, rgb <0.1, 0.3, 0.7> } }
sphere { <0.5, 0.6, -2>, 0.6 pigment { rgb <0.9, 0.4, 0.1> } }
sphere { <-1.2, 0.6, 4>, 0.6 pigment { rgb <0.2, 0.8, 0.1> } }
"""
NORMAL = ("0", "-0.522331", "0.852743")  # normal of the near plane of sharp focus in the report


class Refocus(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        scratch = tempfile.TemporaryDirectory(prefix="tilt lens ")
        cls.addClassCleanup(scratch.cleanup)
        cls.folder = pathlib.Path(scratch.name)
        (cls.folder / "s.pov").write_text(SCENE)
        cls.render("sharp")
        cls.near = cls.render("near", "Declare=Stop=1.4", "Declare=At=0")

    @classmethod
    def render(cls, name, *words):
        command = povray_run.command(SETTINGS.povray, "s.pov", f"{name}.exr", (160, 120), "+FE", "+N", *words)
        return povray_run.run(command, cls.folder).succeeded().said

    def refocus(self, *words, code=0):
        command = [SETTINGS.refocus, "sharp.exr", "sharp.layers.exr", "out.exr", *words]
        done = subprocess.run(command, cwd=self.folder, capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, code, done.stderr)
        return done.stdout + done.stderr

    def difference(self, name):
        done = subprocess.run(["idiff", "-a", "near.exr", name], cwd=self.folder, capture_output=True, text=True, check=False)
        return float(re.search(r"RMS error = (\S+)", done.stdout)[1])

    def test_near_the_real_render(self):
        self.refocus("--plane", *NORMAL, "0", "--f-stop", "1.4")
        self.assertLess(self.difference("out.exr"), 0.25 * self.difference("sharp.exr"))

    def test_the_other_focus_is_another_picture(self):
        self.refocus("--f-stop", "1.4")
        self.assertGreater(self.difference("out.exr"), 0.5 * self.difference("sharp.exr"))

    def test_same_focus_same_picture(self):
        self.refocus()
        done = subprocess.run(["idiff", "-fail", "0", "sharp.exr", "out.exr"], cwd=self.folder, capture_output=True, check=False)
        self.assertEqual(done.returncode, 0, done.stdout)

    def test_focus_on_a_pixel(self):
        said = self.refocus("--at", "107", "98", "--f-stop", "1.4")
        found = re.search(r"plane \{ <(\S+), (\S+), (\S+)>, (\S+) \}, f/1.4", said)
        x, y, z, distance = map(float, found.groups())
        self.assertLess(abs(distance - (0.5 * x + 0.6 * y - 2 * z)), 0.6, said)

    def test_blurred_input_causes_a_warning(self):
        command = [SETTINGS.refocus, "near.exr", "near.layers.exr", "out.exr", "--f-stop", "16"]
        done = subprocess.run(command, cwd=self.folder, capture_output=True, text=True, check=True)
        self.assertRegex(done.stderr, r"refocus: [0-9.]+% of the pixels should be sharper")

    def test_mistakes(self):
        for words, said in (
            (("--at", "10", "3"), "no object in this pixel"),
            (("--at", "160", "3"), "columns 0 to 159"),
            (("--plane", "0", "0", "0", "1"), "has no direction"),
            (("--plane", "0", "1", "0", "2"), "through the camera"),
        ):
            said_now = self.refocus(*words, code=1)
            self.assertIn(said, said_now)
            self.assertEqual(len(said_now.splitlines()), 1)
        command = [SETTINGS.refocus, "sharp.exr", "sharp.exr", "out.exr"]
        done = subprocess.run(command, cwd=self.folder, capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 1)
        self.assertIn("has no channel depth.Z", done.stderr)


def main():
    parser = argparse.ArgumentParser(add_help=False)
    parser.add_argument("--povray", type=os.path.abspath, required=True)
    parser.add_argument("--refocus", type=os.path.abspath, required=True)
    _, rest = parser.parse_known_args(namespace=SETTINGS)
    unittest.main(argv=[sys.argv[0], *rest])


if __name__ == "__main__":
    main()

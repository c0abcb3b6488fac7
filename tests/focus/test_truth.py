# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The true picture: it shows the lens of the live picture; it grows, is wiped, stopped, and saved."""

import math
import os
import pathlib
import struct
import urllib.request

from tests.focus import harness
from tests.focus.harness import ROOT, SCENE, PageTest

VIEW = """#version 3.7;
global_settings { assumed_gamma 1 }
camera {
  location <0, 0, -10>
  look_at 0
  right x*image_width/image_height
  angle 30
}
"""
# one bright spot before the plane of sharp focus and one behind it, on black
SPOTS = (
    VIEW
    + """\
sphere { <-1, 0, -2>, 0.07 pigment { rgb 1 } finish { emission 40 } }
sphere { <1.4, 0, 4>, 0.1 pigment { rgb 1 } finish { emission 40 } }
sphere { <0, -1.2, 0>, 0.1 pigment { rgb 1 } finish { emission 1 } }
"""
)
# a red post before a wall of another colour
POST = (
    VIEW
    + """\
box { <-1, -9, 0>, <1, 9, 0.1> pigment { rgb x } finish { emission 1 diffuse 0 } }
plane { z, 20 pigment { checker rgb z, rgb y scale 0.3 } finish { emission 1 diffuse 0 } }
"""
)
SLOW = SCENE.replace("plane { y", "media { scattering { 1, 1 } intervals 20 samples 50 } plane { y", 1)


class Truth(PageTest):
    def difference(self, width):
        """Differences between the true picture, made now, and the live one."""
        self.true_picture(width)
        self.smooth()
        return self.run(harness.DIFFERENCE)

    def test_live_and_true_picture_agree_in_the_tutorial(self):
        for name, sharp in (("three_points", 0.08), ("tilt", 0.03), ("swing", 0.02)):
            with self.subTest(name):
                self.open(ROOT / "scenes" / "tutorial" / f"{name}.pov")
                found = self.difference(160)
                self.assertLess(found["rmse"], 0.03, found)
                self.assertLess(found["rmse"], 1.1 * found["sharp"], found)
                # if the preview were not a pinhole's, this would be almost 0
                self.assertGreater(found["sharp"], 0.5 * sharp, found)
                self.press("input[name=mode][value=one]")
                for knob, value in (("tilt", 0), ("swing", 0), ("fStop", 1)):
                    self.set_number(knob, value)
                self.click_at(-0.1, -0.4)
                found = self.difference(160)
                self.assertLess(found["rmse"], 0.04, found)
                self.assertGreater(found["sharp"], 1.5 * found["rmse"], found)
                self.end()

    def test_the_blur_has_the_shape_of_the_diaphragm(self):
        self.open(self.scene(SPOTS), "+W320", "+H180")
        for knob, value in (("sceneUnit", 10), ("fStop", 2.5), ("blades", 3), ("bladesAngle", 30)):
            self.set_number(knob, value)
        self.click_at(0, -0.4)
        self.assertAlmostEqual(self.run("return focusPage.model.picks[0][2]"), 0, delta=0.2)
        right = self.difference(320)["rmse"]
        self.assertGreater(self.run("return focusPage.livePixels().filter((x, i) => i % 4 === 0 && x > 60).length"), 500)
        for knob, value in (("bladesAngle", 90), ("blades", 0)):
            self.set_number(knob, value)
            self.smooth()
            self.assertGreater(self.run(harness.DIFFERENCE)["rmse"], 1.5 * right, f"as {knob} {value}")

    def test_a_sharp_edge_does_not_leak_and_a_blurred_one_spreads(self):
        self.open(self.scene(POST), "+W320", "+H180")
        for knob, value in (("sceneUnit", 10), ("fStop", 1.4)):
            self.set_number(knob, value)
        reds = "const pixels = focusPage.livePixels(); return arguments[0].map(x => pixels[4 * (90 * 320 + x)])"
        edge = 160 + round(320 * 1 / (2 * 10 * math.tan(math.radians(15))))  # column of the post's right-hand edge
        places = [edge - 3, edge + 3, edge + 8, edge + 14]
        self.click_at(0, 0.1)
        self.smooth()
        inside, *outside = self.run(reds, places)
        self.assertGreater(inside, 250)
        self.assertEqual(outside, [0, 0, 0], "red of the sharp post in the blurred wall")
        self.click_at(0.4, 0.1)
        self.smooth()
        blurred = self.run(reds, places)
        self.assertLess(blurred[0], 250)
        self.assertEqual(blurred, sorted(blurred, reverse=True))
        self.assertGreater(blurred[2], 30, "the blurred post reaches over the sharp wall")

    def test_it_grows_and_stops(self):
        self.open(self.scene(SLOW), *harness.SMALL)
        self.choose("width", 1920)
        self.press("#render")
        self.until("a part of the picture", lambda: self.run("return document.getElementById('progress').value > 0"))
        grown = "return focusPage.truePixels().some((x, i) => i % 4 === 3 && x > 0)"
        self.assertTrue(self.run(grown))
        self.assertFalse(self.run("return document.getElementById('stop').hidden"))
        self.press("#stop")
        self.until("the stop", lambda: "Stopped at" in self.text("true-said"))
        self.assertTrue(self.run("return document.getElementById('stop').hidden && document.getElementById('save').hidden"))
        self.assertFalse(self.run("return document.getElementById('render').hidden"))
        self.until("the end of the program", lambda: not self.renders("picture_scene"))
        self.assertEqual(self.console(), [])

    def renders(self, name):
        """Running programs that render a file of this name for this test."""
        found = []
        for pid in filter(str.isdigit, os.listdir("/proc")):
            try:
                words = pathlib.Path(f"/proc/{pid}/cmdline").read_bytes().decode(errors="replace")
            except OSError:
                continue
            if name in words and str(self.folder) in words:
                found.append(words)
        return found

    def test_it_is_wiped_and_saved(self):
        from selenium.webdriver.common.keys import Keys

        address = self.open(self.scene(), *harness.SMALL)
        shown = "const t = document.getElementById('truth'); return t.hidden ? '' : getComputedStyle(t).clipPath"
        self.assertEqual(self.run(shown), "")
        self.true_picture(320)
        self.assertEqual(self.run(shown), "inset(0px 0px 0px 50%)")
        wipe = self.element("wipe")
        wipe.send_keys(Keys.HOME)
        self.assertEqual(self.run(shown), "inset(0px 0px 0px 0%)")
        wipe.send_keys(Keys.END)
        self.assertEqual(self.run(shown), "inset(0px 0px 0px 100%)")
        self.assertTrue(self.run("return document.getElementById('save').href").endswith("/picture.png"))
        with urllib.request.urlopen(address + "picture.png") as answer:
            self.assertIn('filename="scene.png"', answer.headers["Content-Disposition"])
            data = answer.read()
        self.assertEqual((data[:8], struct.unpack(">2I", data[16:24])), (b"\x89PNG\r\n\x1a\n", (320, 180)))
        self.press("#hide")
        self.assertEqual(self.run(shown), "")

    def test_scene_broken_meanwhile_has_a_message(self):
        scene = self.scene()
        self.open(scene, *harness.SMALL)
        scene.write_text(SCENE.replace("rgb 1 }", "rgb one }", 1))
        self.press("#render")
        self.until("the message", lambda: "scene.pov, line 9" in self.text("true-said"))
        self.assertFalse(self.run("return document.getElementById('render').hidden"))


if __name__ == "__main__":
    harness.main()

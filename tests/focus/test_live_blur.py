# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
import math

from tests.focus import harness
from tests.focus.harness import PageTest

VIEW = """#version 3.7;
global_settings { assumed_gamma 1 }
camera {
  location <0, 0, -10>
  look_at 0
  right x*image_width/image_height
  angle 30
}
"""
# one spot on either side of the plane of sharp focus
SPOTS = (
    VIEW
    + """\
sphere { <-1, 0, -2>, 0.07 pigment { rgb 1 } finish { emission 40 } }
sphere { <1.4, 0, 4>, 0.1 pigment { rgb 1 } finish { emission 40 } }
sphere { <0, -1.2, 0>, 0.1 pigment { rgb 1 } finish { emission 1 } }
"""
)
POST = (
    VIEW
    + """\
box { <-1, -9, 0>, <1, 9, 0.1> pigment { rgb x } finish { emission 1 diffuse 0 } }
plane { z, 20 pigment { checker rgb z, rgb y scale 0.3 } finish { emission 1 diffuse 0 } }
"""
)


class Shape(PageTest):
    def test_the_blur_has_the_shape_of_the_diaphragm(self):
        self.open(self.scene(SPOTS), "+W256", "+H144")
        for knob, value in (("sceneUnit", 10), ("fStop", 2.5), ("blades", 3), ("bladesAngle", 30)):
            self.set_number(knob, value)
        self.click_at(0, -0.4)
        self.assertAlmostEqual(self.run("return focusPage.model.picks[0][2]"), 0, delta=0.2)
        right = self.difference(256)["rmse"]
        self.assertGreater(self.run("return focusPage.livePixels().filter((x, i) => i % 4 === 0 && x > 60).length"), 500)
        for knob, value in (("bladesAngle", 90), ("blades", 0)):
            self.set_number(knob, value)
            self.smooth()
            self.assertGreater(self.run(harness.DIFFERENCE)["rmse"], 1.5 * right, f"as {knob} {value}")


class Edge(PageTest):
    def test_a_sharp_edge_does_not_leak_and_a_blurred_one_spreads(self):
        self.open(self.scene(POST), "+W320", "+H90")
        for knob, value in (("sceneUnit", 10), ("fStop", 1.4)):
            self.set_number(knob, value)
        reds = "const pixels = focusPage.livePixels(); return arguments[0].map(x => pixels[4 * (45 * 320 + x)])"
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


if __name__ == "__main__":
    harness.main()

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
import math

from tests.focus import harness
from tests.focus.harness import SCENE, PageTest
from tools.focus.picture import display

NEAR, MIDDLE, FAR = (-0.41, -0.41), (0.28, -0.055), (-0.03, 0.3)  # on the fronts of the three towers

AIDS = {"peaking": "focus_peaking rgb <1, 0.05, 0.35>", "map": "focus_map", "planes": "show_planes"}

PIXELS = """
const pixels = focusPage.livePixels(arguments[0]), [width, height] = focusPage.live.size;
return arguments[1].map(([x, y]) => {
    const at = 4 * (Math.floor((0.5 - y) * height) * width + Math.floor((0.5 + x) * width));
    return Array.from(pixels.slice(at, at + 3));
});
"""

# kind -> [x1, y1, x2, y2]; intersection of film, lens and plane
SIDE = """
const found = {};
for (const line of document.querySelectorAll("#side line"))
    (found[line.getAttribute("class")] ??= []).push(["x1", "y1", "x2", "y2"].map(name => Number(line.getAttribute(name))));
const meet = document.querySelector("#side circle.meet");
const dots = document.querySelector("#side path.surface").getAttribute("d").split("M").length - 1;
return { ...found, meet: meet && [Number(meet.getAttribute("cx")), Number(meet.getAttribute("cy"))], dots };
"""


def off_line(line, point):
    x1, y1, x2, y2 = line
    return abs((x2 - x1) * (point[1] - y1) - (y2 - y1) * (point[0] - x1)) / math.hypot(x2 - x1, y2 - y1)


def angle(line):
    x1, y1, x2, y2 = line
    return math.degrees(math.atan2(y1 - y2, x2 - x1)) % 180


class OverlaysPage(PageTest):
    def focus_on(self, place):
        self.open(self.scene(), "+W320", "+H180")
        self.set_number("fStop", 0.5)
        self.click_at(*place)

    def pixels(self, places, **show):
        self.one_pass()
        return self.run(PIXELS, show, places)

    def other(self, live, scene, size):
        return abs(live - display(harness.rendered(scene, self.folder, size)["colours"], 1)[:150, :, :3]).max(2)

    def live(self, show):
        import numpy

        values = self.run("return Array.from(focusPage.livePixels({ blur: false, ...arguments[0] }))", show)
        return numpy.array(values).reshape(180, 320, 4)[:150, :, :3]


class Colours(OverlaysPage):
    def test_the_tint_marks_what_is_sharp_and_nothing_else(self):
        self.focus_on(MIDDLE)
        plain, tinted = self.pixels([NEAR, MIDDLE, FAR]), self.pixels([NEAR, MIDDLE, FAR], peaking=True)
        self.assertEqual([a == b for a, b in zip(plain, tinted)], [True, False, True])

    def test_the_blur_as_colours_has_two_sides(self):
        self.focus_on(MIDDLE)
        near, middle, far = self.pixels([NEAR, MIDDLE, FAR], map=True)
        self.assertGreater(near[0], near[2] + 60, "orange before the plane")
        self.assertGreater(far[2], far[0] + 60, "blue behind it")
        self.assertGreater(min(middle), 200, "white where it is sharp")
        self.press("#show-map")
        self.assertFalse(self.run("return document.getElementById('legend').hidden"))
        self.assertEqual(self.pixels([NEAR, MIDDLE, FAR]), [near, middle, far])

    def test_plane_covers_objects_behind_it(self):
        self.focus_on(MIDDLE)
        plain, planes = self.pixels([NEAR, FAR]), self.pixels([NEAR, FAR], planes=True)
        self.assertEqual(plain[0], planes[0])
        self.assertNotEqual(plain[1], planes[1])
        self.assertGreater(planes[1][2], plain[1][2] + 40)
        # a plane laid through the floor leaves the sky unchanged
        self.set_number("focusTilt", 80)
        laid = self.pixels([(0, -0.45), FAR], planes=True)
        self.assertNotEqual(laid[1], planes[1])


class Aids(OverlaysPage):
    def test_tint_colours_and_planes_are_those_of_the_focus_aids(self):
        scene, size = self.scene(), (320, 180)
        self.open(scene, "+W320", "+H180")
        for knob, value in (("fStop", 1.4), ("tilt", 3), ("swing", -2)):
            self.set_number(knob, value)
        self.press("#write")
        self.until("the change", lambda: "Written" in self.text("file-said"))
        self.until("the new preview", lambda: "new preview" in self.text("status"))
        self.one_pass()
        written = scene.read_text()
        live = {name: self.live({name: True} if name else {}) for name in ("", *AIDS)}
        same = self.other(live[""], self.scene(SCENE, "plain.pov"), size) <= 1
        self.assertGreater(same.mean(), 0.8)
        for name, item in AIDS.items():
            with self.subTest(item):
                copy = self.scene(written.replace("tilt_lens {", f"tilt_lens {{\n    {item}"), "aid.pov")
                self.assertGreater(abs(live[name] - live[""]).max(2).mean(), 2, "nothing is laid over the picture")
                self.assertLess((self.other(live[name], copy, size)[same] > 2).mean(), 0.005)


class Side(OverlaysPage):
    def test_film_lens_and_plane_meet_in_the_side_view(self):
        self.focus_on(MIDDLE)
        self.one_pass()
        flat = self.run(SIDE)
        self.assertIsNone(flat["meet"])
        self.assertAlmostEqual(angle(flat["lens"][0]), 90, delta=0.01)
        self.assertAlmostEqual(angle(flat["plane"][0]), 90, delta=0.01)
        self.assertGreater(flat["dots"], 100)
        for tilt in (4, 8):
            self.set_number("tilt", tilt)
            self.one_pass()
            seen = self.run(SIDE)
            (film,), (lens,), (plane,) = seen["film"], seen["lens"], seen["plane"]
            for line in (film, lens, plane):
                self.assertLess(off_line(line, seen["meet"]), 0.5)
            self.assertAlmostEqual(angle(lens), 90 - tilt, delta=0.01)
            self.assertNotAlmostEqual(angle(plane), 90, delta=5)
            # the limits meet the plane in the hinge line
            hinge = [(lens[0] + lens[2]) / 2, None]
            x1, y1, x2, y2 = plane
            hinge[1] = y1 + (hinge[0] - x1) * (y2 - y1) / (x2 - x1)
            for limit in (seen["near"][0], seen["far"][0]):
                self.assertLess(off_line(limit, hinge), 0.5)
                self.assertGreater(abs(angle(limit) - angle(plane)), 0.01)


if __name__ == "__main__":
    harness.main()

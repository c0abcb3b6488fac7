# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Numbers at the pointer, and the loupe."""

import math
import re

from selenium.webdriver import ActionChains
from selenium.webdriver.common.keys import Keys

from tests.focus import harness
from tests.focus.harness import PageTest

NEAR, MIDDLE, FAR = (-0.41, -0.41), (0.28, -0.055), (-0.03, 0.3)  # on the fronts of the three towers
SIZE = (320, 180)
NUMBER = r"([\d.]+|infinity)"
READING = rf"{NUMBER} from the lens: (?:no blur|blur ([\d.]+) px (before|behind) the plane)\. Sharp here from {NUMBER} to {NUMBER}"

POINT_AT = """
const picture = document.getElementById("picture"), { left, top, width, height } = picture.getBoundingClientRect();
const clientX = Math.round(left + (arguments[0] + 0.5) * width), clientY = Math.round(top + (0.5 - arguments[1]) * height);
picture.dispatchEvent(new PointerEvent("pointermove", { clientX, clientY, bubbles: true, pointerType: "mouse" }));
return [(clientX - left) / width - 0.5, 0.5 - (clientY - top) / height];
"""
# Share of the loupe's pixels that differ from the live picture's.
LOUPE = """
const [[x, y], scale] = arguments, loupe = document.getElementById("loupe"), side = loupe.width, [width, height] = focusPage.live.size;
const copy = new OffscreenCanvas(side, side).getContext("2d");
copy.drawImage(loupe, 0, 0);
const found = copy.getImageData(0, 0, side, side).data, live = focusPage.livePixels();
const left = Math.round((x + 0.5) * width - side / scale / 2), top = Math.round((0.5 - y) * height - side / scale / 2);
let inside = 0, other = 0, contrast = 0;
for (let row = 0; row < side; row++)
    for (let column = 0; column < side; column++) {
        const px = Math.floor(left + (column + 0.5) / scale), py = Math.floor(top + (row + 0.5) / scale);
        if (px < 0 || py < 0 || px >= width || py >= height)
            continue;
        inside++;
        for (const colour of [0, 1, 2]) {
            other += Math.abs(found[4 * (row * side + column) + colour] - live[4 * (py * width + px) + colour]) > 2;
            contrast += Math.abs(found[4 * (row * side + column) + colour] - live[colour]);
        }
    }
return { side, inside, other: other / (3 * inside), contrast: contrast / (3 * inside) };
"""


class Reading(PageTest):
    def open_wide(self):
        scene = self.scene()
        self.open(scene, "+W320", "+H180")
        self.set_number("fStop", 0.7)
        self.click_at(*MIDDLE)
        return scene

    def point_at(self, x, y):
        return tuple(self.run(POINT_AT, x, y))

    def test_numbers_at_the_pointer_are_those_of_the_program(self):
        scene = self.open_wide()
        self.set_number("tilt", 3)
        lens = self.run("return focusPage.model.lens")
        readings = {}
        for place in (NEAR, MIDDLE, FAR):
            at = self.point_at(*place)
            readings[at] = re.match(READING, self.text("reading"))
            self.assertTrue(readings[at], self.text("reading"))
        self.press("#write")
        self.until("the change", lambda: "Written" in self.text("file-said"))
        found = harness.rendered(scene, self.folder, SIZE, "+N")
        for (x, y), said in readings.items():
            row, column = int((0.5 - y) * SIZE[1]), int((x + 0.5) * SIZE[0])
            chief = [d + x * r + y * u for d, r, u in zip(lens["direction"], lens["right"], lens["up"])]
            size, far = math.hypot(*chief), sum(a * b for a, b in zip(lens["direction"], lens["axis"]))
            self.assertAlmostEqual(float(said[1]), found["depth.Z"][row, column] * size / far, delta=0.02 * float(said[1]))
            blur = float(said[2] or 0) * (-1 if said[3] == "behind" else 1)
            self.assertAlmostEqual(blur, found["blur"][row, column], delta=0.1)
            # one pixel of blur: (1/T - k.D) times the lens diameter, in pixels
            w, pixels = sum(k * c for k, c in zip(lens["focus"], chief)), lens["diameter"] * SIZE[0] / math.hypot(*lens["right"])
            for limit, wanted in ((said[4], 1), (said[5], -1)):
                self.assertAlmostEqual((size / float(limit) - w) * pixels, wanted, delta=0.02)
        self.assertEqual(self.nothing(), [None, None])
        self.assertEqual(self.console(), [])

    def nothing(self):
        return self.browser.execute_async_script(
            """
            const done = arguments[0];
            import(new URL("page/reading.js", location)).then(({ readingAt }) => {
                const { surface, blur } = readingAt(focusPage.model.lens, 0, 0, 0, 320);
                done([surface, blur]);
            });
        """
        )

    def test_loupe_shows_the_picture_at_its_own_pixels(self):
        self.open_wide()
        self.press("#show-loupe")
        for place, scale in ((NEAR, 1), (MIDDLE, 2), (FAR, 4)):
            self.choose("loupe-scale", scale)
            at = self.point_at(*place)
            self.one_pass()
            found = self.run(LOUPE, at, scale)
            with self.subTest(scale, found=found):
                self.assertGreater(found["inside"], 0.2 * found["side"] ** 2)
                self.assertLess(found["other"], 0.001)
                self.assertGreater(found["contrast"], 5, "an empty picture would do")
        picture = self.element("picture")
        for place in (picture, self.element("name")):
            ActionChains(self.browser, duration=0).move_to_element(place).perform()
        self.assertTrue(self.run("return document.getElementById('loupe').hidden"), "the pointer has left the picture")
        picture.send_keys("l")
        self.assertFalse(self.run("return document.getElementById('show-loupe').checked"))
        self.assertEqual(self.console(), [])

    def test_two_lenses_change_places_by_a_key(self):
        self.open_wide()
        numbers = "const { tilt, fStop } = focusPage.model.numbers(); return [Math.round(1000 * tilt) / 1000, fStop]"
        shown = "return document.querySelector('input[name=pair]:checked').value"
        self.element("picture").send_keys("x")
        self.assertEqual((self.run(shown), self.run(numbers)), ("B", [0, 0.7]), "it begins as a copy")
        self.set_number("tilt", 4)
        self.set_number("fStop", 2)
        self.element("picture").send_keys("X")
        self.assertEqual((self.run(shown), self.run(numbers)), ("A", [0, 0.7]))
        self.set_number("tilt", -2)
        self.press("input[name=pair][value=B]")
        self.assertEqual((self.run(shown), self.run(numbers)), ("B", [4, 2]))
        self.press("#back")
        self.assertEqual(self.run(numbers), [4, 0.7], "each lens steps back by itself")
        self.element("fStop").send_keys(Keys.END, "x", Keys.TAB)
        self.assertEqual(self.run(shown), "B", "a letter typed into a number changes nothing")
        self.browser.refresh()
        self.until("the preview", self.drawn)
        self.assertEqual((self.run(shown), self.run(numbers)), ("B", [4, 0.7]))
        self.press("input[name=pair][value=A]")
        self.assertEqual(self.run(numbers), [-2, 0.7], "the address has both")
        self.assertEqual(self.console(), [])


if __name__ == "__main__":
    harness.main()

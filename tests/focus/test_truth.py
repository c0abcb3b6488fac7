# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The true picture: growth, end and saving."""

import os
import pathlib
import struct
import urllib.request

from tests.focus import harness
from tests.focus.harness import SCENE, PageTest

SLOW = SCENE.replace("plane { y", "media { scattering { 1, 1 } intervals 20 samples 50 } plane { y", 1)


class Truth(PageTest):
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

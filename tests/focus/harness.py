# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Shared by the tests of ./focus."""

import argparse
import asyncio
import contextlib
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import unittest

from tests.waiting import WaitingTest
from tools import povray_run
from tools.focus.render import Render
from tools.repository import ROOT

SETTINGS = argparse.Namespace(povray=None, cases=None)

# Three towers of different heights on a floor; no lens.
SCENE = """#version 3.7;
global_settings { assumed_gamma 1 }
camera {
  location <0, 3, -7>
  look_at <0, 0.8, 0>
  right x*image_width/image_height
  angle 45
}
light_source { <-4, 9, -9>, rgb 1 }
plane { y, 0 pigment { checker rgb 0.8, rgb <0.2, 0.4, 0.7> } }
plane { z, 9 pigment { brick rgb 0.9, rgb <0.7, 0.3, 0.2> scale 0.2 } }
box { <-2.4, 0, -2>, <-1.4, 0.6, -1> pigment { rgb <0.9, 0.4, 0.1> } }
box { <1.2, 0, 0>, <2.2, 1.2, 1> pigment { rgb <0.2, 0.7, 0.3> } }
box { <-0.8, 0, 2>, <0.4, 2, 3> pigment { rgb <0.8, 0.8, 0.2> } }
"""


def exported_camera(place):
    """Exporters place the camera by a matrix."""
    return f"""camera {{
  location <0, 0, 0>
  look_at <0, 0, -1>
  right <-1.777778, 0, 0>
  up <0, 1, 0>
  angle 49.134343
  matrix <0.685921, 0.727676, 0.0,  -0.324013, 0.305421, 0.895396,  0.651558, -0.614170, 0.445271,  {place}>
}}
"""


EXPORTED = f"""#version 3.7;
global_settings {{ assumed_gamma 1 }}
{exported_camera("73588.9, -69257.9, 49583.1")}\
light_source {{ <40000, -10000, 90000>, rgb 1.2 }}
plane {{ z, 0  pigment {{ checker rgb 0.8 rgb 0.35 scale 4000 }} }}
#for (I, -4, 4) box {{ <10000*I - 3000, -3000, 0>, <10000*I + 3000, 3000, 12000> pigment {{ rgb <0.7, 0.3, 0.2> }} }} #end
"""
TOWERS = ((-0.41, -0.41), (0.28, -0.055), (-0.03, 0.3))  # places in the picture of the fronts of the three towers
SMALL = ("+W160", "+H90")


# Knobs that differ from the lens, and points off the plane of sharp focus.
ONE_LENS = """
const model = focusPage.model, { lens, block } = model, found = model.numbers(), wrong = [];
const numbers = {
    tilt: found.tilt, swing: found.swing, focusTilt: found.focus.tilt, focusSwing: found.focus.swing, angle: found.angle,
    focalLength: found.focalLength, ...(model.error ? {} : { fStop: lens.focalLength / lens.diameter, sceneUnit: 1 / lens.millimetre }),
};
for (const [id, value] of Object.entries(numbers)) {
    const shown = Number(document.getElementById(id).value);
    if (Math.abs(shown - value) > 0.06 + 1e-3 * Math.abs(value))
        wrong.push(`${id} shows ${shown} for ${value}`);
}
const wanted = model.picks.length === model.wantedPicks && !model.error ? model.picks : [];
return [...wrong, ...wanted.map(p => model.offPlane(p)).filter(off => !(Math.abs(off) < 1e-6)).map(off => `a point is off by ${off}`)];
"""

# Root mean square differences from the true picture.
DIFFERENCE = """
const truth = focusPage.truePixels();
const rmse = show => {
    const live = focusPage.livePixels(show);
    return Math.sqrt(live.reduce((sum, x, i) => sum + ((x - truth[i]) / 255) ** 2, 0) / (live.length * 3 / 4));
};
return { rmse: rmse({}), sharp: rmse({ blur: false }) };
"""


class FocusTest(WaitingTest):
    """Its folder's name contains a space."""

    longMessage = True

    def setUp(self):
        scratch = tempfile.TemporaryDirectory(prefix="focus test ")
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)
        (self.folder / "tmp").mkdir()
        self.process = None

    def scene(self, text=SCENE, name="scene.pov"):
        path = self.folder / name
        path.write_text(text)
        return path

    def with_lens(self, block):
        return self.scene(SCENE.replace("  angle 45\n", f"  angle 45\n  {block}\n"))

    def start(self, scene, *words, idle=120, **variables):
        command = [str(ROOT / "focus"), str(scene), "--idle", str(idle), "--povray", SETTINGS.povray]
        said = open(self.folder / "errors", "wb")
        self.addCleanup(said.close)
        self.process = subprocess.Popen(
            [*command, *words],
            cwd=self.folder,
            env=povray_run.user_environment(TMPDIR=str(self.folder / "tmp"), **variables),
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=said,
            text=True,
            start_new_session=True,
        )
        self.addCleanup(self.end)
        for line in self.process.stdout:
            found = re.search(r"http://127\.0\.0\.1:\d+/[\w-]+/", line)
            if found:
                return found.group()
        self.fail(f"no address: {self.evidence()}")

    def evidence(self):
        return (self.folder / "errors").read_text(errors="replace")

    def end(self, number=signal.SIGINT):
        if self.process.poll() is None:
            os.killpg(self.process.pid, number)
        try:
            code = self.process.wait(30)
        except subprocess.TimeoutExpired:
            os.killpg(self.process.pid, signal.SIGKILL)
            code = self.process.wait()
        self.process.stdout.close()
        return code


def rendered(scene, folder, size, *words):
    import numpy

    found = {}

    async def take(tile):
        parts = {"colours": tile.colours} if tile.layers is None else tile.layers
        for name, part in parts.items():
            place = found.setdefault(name, numpy.full((size[1], size[0], *part.shape[2:]), numpy.nan))
            place[tile.top : tile.top + part.shape[0], tile.left : tile.left + part.shape[1]] = part

    render = Render(SETTINGS.povray, folder, "rendered")
    library = f"+L{povray_run.INCLUDE}"
    asyncio.run(render.run(render.words(scene, [library, "-A", *words], size), False, take))
    return found


def open_browser(size=(1280, 1000)):
    """Headless Chromium with software rendering."""
    from selenium import webdriver
    from selenium.webdriver.chrome.service import Service

    options = webdriver.ChromeOptions()
    options.binary_location = "/usr/bin/chromium"
    # its sandbox needs rights that neither root nor a user in a chroot has
    words = ["--headless=new", "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-dev-shm-usage"]
    # composing the page by WebGL's software takes twice the processor time
    words += ["--disable-gpu-compositing", "--hide-scrollbars", f"--window-size={size[0]},{size[1]}"]
    for word in words:
        options.add_argument(word)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    browser = webdriver.Chrome(service=Service("/usr/bin/chromedriver"), options=options)
    browser.set_script_timeout(300)
    browser.set_page_load_timeout(300)
    return browser


class PageTest(FocusTest):
    """The tests of a module share the browser."""

    browser = None

    @classmethod
    def setUpClass(cls):
        cls.browser = open_browser()

    @classmethod
    def tearDownClass(cls):
        with contextlib.suppress(Exception):
            cls.browser.quit()

    def open(self, scene, *words):
        address = self.start(scene, *(words or SMALL))
        self.browser.get(address)
        self.until("the preview", self.drawn)
        return address

    def drawn(self):
        """Afterwards the picture has one pass; smooth() asks for all."""
        script = (
            "const live = window.focusPage?.live; if (!live?.complete || !live.passes) return false; focusPage.patience = 0; return true"
        )
        return self.run(script)

    def refined_sum(self):
        """Sum of the preview's values; its edges change until it is refined."""
        self.until("the refined preview", lambda: self.run("return focusPage.live.refined"))
        return self.run("return focusPage.previewSum()")

    def smooth(self, patience="Infinity"):
        script = f"focusPage.patience = {patience}; return focusPage.live.refined && focusPage.live.smooth"
        self.until("the smooth picture", lambda: self.run(script))
        self.run("focusPage.patience = 0")

    def one_pass(self):
        self.smooth(patience=0)

    def true_picture(self, width):
        self.run("document.getElementById('width').add(new Option(arguments[0], arguments[0], true, true))", str(width))
        self.press("#render")
        self.until("the true picture", lambda: "Done" in self.text("true-said"))

    def difference(self, width):
        self.true_picture(width)
        self.smooth()
        return self.run(DIFFERENCE)

    def choose(self, name, value):
        script = "const s = document.getElementById(arguments[0]); s.value = arguments[1]; s.dispatchEvent(new Event('change'))"
        self.run(script, name, str(value))

    def run(self, script, *arguments):  # pylint: disable=arguments-differ
        """Without a script, runs the test as TestCase.run does."""
        if isinstance(script, str):
            return self.browser.execute_script(script, *arguments)
        return super().run(script)

    def element(self, name):
        return self.browser.find_element("id", name)

    def press(self, selector):
        self.run("document.querySelector(arguments[0]).click()", selector)

    def click_at(self, x, y):
        """x, y: right and up on the film, from -0.5 to 0.5."""
        from selenium.webdriver import ActionChains

        picture = self.element("picture")
        self.run("arguments[0].scrollIntoView({block: 'center'})", picture)
        size = picture.size
        ActionChains(self.browser, duration=0).move_to_element_with_offset(
            picture, round(x * size["width"]), round(-y * size["height"])
        ).click().perform()

    def pick_towers(self):
        self.press("input[name=mode][value=three]")
        for x, y in TOWERS:
            self.click_at(x, y)
        picks = self.run("return focusPage.model.picks")
        self.assertEqual(len(picks), 3)
        return picks

    def set_number(self, name, value):
        script = "const e = document.getElementById(arguments[0]); e.value = arguments[1]; e.dispatchEvent(new Event('change'))"
        self.run(script, name, str(value))

    def text(self, name):
        return self.run("return document.getElementById(arguments[0]).textContent", name)

    def message(self):
        return self.run("const m = document.getElementById('message'); return m.hidden ? '' : m.textContent")

    def console(self):
        log = self.browser.get_log("browser")
        return [entry["message"] for entry in log if "GPU stall due to ReadPixels" not in entry["message"]]


def read_settings():
    arguments = argparse.ArgumentParser(add_help=False)
    arguments.add_argument("--povray", required=True)
    arguments.add_argument("--cases", help="the program lens_cases")
    _, rest = arguments.parse_known_args(namespace=SETTINGS)
    SETTINGS.povray = os.path.abspath(SETTINGS.povray)
    return rest


def main(prefix="test"):
    loader = unittest.TestLoader()
    loader.testMethodPrefix = prefix
    unittest.main(module="__main__", argv=[sys.argv[0], *read_settings()], testLoader=loader)

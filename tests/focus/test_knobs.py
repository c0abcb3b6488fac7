# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The page's lens against the program's, its knobs, impossible lenses, and a hundred random actions."""

import json
import random
import re
import subprocess

from tests.focus import harness
from tests.focus.harness import ROOT, SETTINGS, PageTest

CASES = 4000


# Consistency of knobs and points: knobs that differ from the lens, and the points' distance from the plane of sharp focus. While the wanted
# lens is impossible, the last lens is shown and the points wait.
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


class Knobs(PageTest):
    def test_formulas_are_those_of_the_program(self):
        done = subprocess.run([SETTINGS.cases, "1", str(CASES)], capture_output=True, text=True, check=True)
        self.open(self.scene())
        compare = (ROOT / "tests" / "focus" / "compare_lens.js").read_text().replace("export ", "")
        script = compare + "import(new URL('page/lens.js', location)).then(lens => arguments[1](compareLenses(lens, arguments[0])))"
        cases = json.loads(done.stdout)
        self.assertEqual(len(cases), CASES)
        for start in range(0, CASES, 1000):
            worst = self.browser.execute_async_script(script, cases[start : start + 1000])
            self.assertLess(worst["pixels"], 1e-6, worst["where"])
            self.assertLess(worst["relative"], 1e-8, worst["where"])
            self.assertGreater(worst["pixels"], 0, "nothing was compared")

    def test_each_knob_changes_the_lens_and_the_text(self):
        self.open(self.scene())
        self.press("input[name=form][value=angles]")
        for knob, value, numbers in (
            ("tilt", 6, "m.numbers().tilt"),
            ("swing", -3, "m.numbers().swing"),
            ("focusTilt", 40, "m.numbers().focus.tilt"),
            ("focusSwing", 10, "m.numbers().focus.swing"),
            ("fStop", 1.8, "m.lens.focalLength / m.lens.diameter"),
            ("angle", 60, "m.numbers().angle"),
            ("focalLength", 35, "m.numbers().focalLength"),
            ("sceneUnit", 50, "1 / m.lens.millimetre"),
            ("shiftRight", 4, "m.block.shift[0]"),
            ("shiftUp", -2, "m.block.shift[1]"),
            ("blades", 5, "m.block.blades"),
            ("bladesAngle", 20, "m.block.bladesAngle"),
        ):
            with self.subTest(knob):
                before = self.text("block")
                self.set_number(knob, value)
                self.assertAlmostEqual(self.run(f"const m = focusPage.model; return {numbers}"), value, places=6)
                self.assertAlmostEqual(float(self.run("return document.getElementById(arguments[0]).value", knob)), value, places=3)
                if knob != "bladesAngle" or "blades" in self.text("block"):
                    self.assertNotEqual(self.text("block"), before)
                self.assertRegex(self.text("block"), r"^(\w+ .+\n)*tilt_lens \{\n(  .+\n)+\}$")
        self.assertEqual(self.console(), [])

    def test_what_cannot_be_is_said_beside_the_knob(self):
        self.open(self.scene())
        said = "return document.querySelector('[data-said=' + arguments[0] + ']').textContent"
        self.set_number("tilt", 95)
        self.assertIn("less than 90", self.run(said, "turn"))
        self.assertTrue(self.run("return document.getElementById('render').disabled"))
        self.set_number("tilt", 5)
        self.assertEqual(self.run(said, "turn"), "")
        self.set_number("focalLength", 500000)
        self.assertIn("focal length", self.run(said, "focalLength"))
        self.set_number("focalLength", 50)
        self.choose("real", 1)
        self.set_number("tilt", 12)
        self.assertIn("8.5", self.run(said, "turn"))
        self.set_number("shiftUp", 15)
        self.assertIn("12 mm", self.run(said, "shift"))
        self.set_number("fStop", 2)
        self.assertIn("f/3.5", self.run(said, "fStop"))
        self.assertEqual(self.console(), [])

    def test_plane_through_the_lens_has_a_remark_beside_the_points(self):
        self.open(self.scene())
        self.press("input[name=mode][value=three]")
        self.choose("third", "upright")
        # straight before the camera: a vertical plane through both contains the lens
        self.run("focusPage.model.pick([0, 0, 1])")
        before = self.run("return focusPage.model.lens.focus")
        self.run("focusPage.model.pick([0, 0, -1])")
        said = "return document.querySelector('[data-said=points]').textContent"
        self.assertIn("passes through the lens", self.run(said))
        self.assertTrue(self.run("return [...document.querySelectorAll('#points button')].every(p => p.className === 'bad')"))
        self.assertEqual(self.run("return focusPage.model.lens.focus"), before, "the picture stays that of the last lens")
        self.click_at(0.3, -0.3)
        self.assertEqual(self.run(said), "")
        self.assertNotEqual(self.run("return focusPage.model.lens.focus"), before)
        self.assertEqual(self.run(ONE_LENS), [])

    def test_sliders_and_lists_turn_the_lens_too(self):
        self.open(self.scene())
        slide = """
        const slider = document.getElementById(arguments[0]).previousElementSibling, before = focusPage.model.lens;
        slider.value = Number(slider.min) + 0.7 * (slider.max - slider.min);
        slider.dispatchEvent(new Event("input"));
        slider.dispatchEvent(new Event("change"));
        return JSON.stringify(before) !== JSON.stringify(focusPage.model.lens);
        """
        for knob in ("tilt", "swing", "fStop", "angle", "focalLength", "focusTilt", "focusSwing", "sceneUnit", "shiftRight", "shiftUp"):
            with self.subTest(knob):
                self.assertTrue(self.run(slide, knob))
                self.assertEqual(self.run(ONE_LENS), [])
        for name, value, width in (("film", 7, 127), ("real", 1, 36)):
            self.choose(name, value)
            self.assertAlmostEqual(self.run("return focusPage.model.block.filmWidth"), width, places=6)
            self.assertEqual(self.run(f"return document.getElementById('{name}').value"), str(value))
        self.assertAlmostEqual(self.run("return focusPage.model.numbers().focalLength"), 24, places=9)

    def test_page_contacts_no_other_host(self):
        address = self.open(self.scene())
        names = self.run("return performance.getEntriesByType('resource').map(e => e.name)")
        self.assertGreater(len(names), 5)
        origin = re.match(r"http://[^/]+/", address).group()
        self.assertEqual([name for name in names if not name.startswith(origin)], [])
        for path in (ROOT / "tools" / "focus" / "page").iterdir():
            addresses = set(re.findall(r"(?:https?|wss?):?//[\w.]+", path.read_text()))
            self.assertLessEqual(addresses, {"http://www.w3.org"}, path.name)

    def test_program_contacts_no_other_host(self):
        clients = (
            r"^\s*(?:import|from) (?:urllib|http|socket|ssl|requests|ftplib|smtplib)\b|ClientSession|open_connection|create_connection"
        )
        for path in (ROOT / "tools" / "focus").glob("*.py"):
            text = path.read_text()
            self.assertEqual(re.findall(clients, text, re.MULTILINE), [], path.name)
            self.assertEqual(re.findall(r"(?:https?|wss?)://[\w.]+", text), [], path.name)

    def test_a_hundred_random_actions_make_no_error(self):
        self.open(self.scene())
        chance = random.Random(7)
        ids = "tilt swing fStop angle focalLength focusTilt focusSwing sceneUnit shiftRight shiftUp bladesAngle".split()
        for _ in range(100):
            action = chance.randrange(6)
            if action == 0:
                self.click_at(chance.uniform(-0.48, 0.48), chance.uniform(-0.48, 0.48))
            elif action == 1:
                self.set_number(chance.choice(ids), chance.choice([0, -1, 3, 8, 14.5, 40, 70, 1e9, -1e9, ""]))
            elif action == 2:
                self.press(
                    chance.choice(
                        [
                            "input[name=mode][value=one]",
                            "input[name=mode][value=three]",
                            "input[name=mode][value=more]",
                            "#hold",
                            "input[name=pair][value=A]",
                            "input[name=pair][value=B]",
                            "#back",
                        ]
                    )
                )
            elif action == 3:
                self.press(chance.choice(["#show-blur", "#show-peaking", "#show-map", "#show-planes"]))
            elif action == 4:
                name = chance.choice(["third", "film", "real", "blades"])
                script = (
                    "const s = document.getElementById(arguments[0]); s.selectedIndex = Math.floor(arguments[1] * s.options.length);"
                    "s.dispatchEvent(new Event('change'))"
                )
                self.run(script, name, chance.random())
            else:
                self.press(chance.choice([f"input[name=form][value={form}]" for form in ("points", "plane", "angles")]))
            finite = self.run("return [...focusPage.model.lens.focus, focusPage.model.lens.diameter].every(Number.isFinite)")
            self.assertTrue(finite)
            self.assertEqual(self.run(ONE_LENS), [])
            self.assertNotRegex(self.text("block"), r"NaN|undefined|Infinity|null")
        self.assertEqual(self.console(), [])
        self.assertEqual(self.message_of_page(), "")

    def message_of_page(self):
        """The error on the page, if any."""
        return self.run("const m = document.getElementById('message'); return m.hidden ? '' : m.textContent")


if __name__ == "__main__":
    harness.main()

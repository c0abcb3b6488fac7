# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""A hundred random actions on the page."""

import random

from tests.focus import harness
from tests.focus.harness import ONE_LENS, PageTest


class RandomActions(PageTest):
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
        self.assertEqual(self.message(), "")


if __name__ == "__main__":
    harness.main()

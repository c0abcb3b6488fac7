# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The live picture resembles the true one."""

from tests.focus import harness
from tests.focus.harness import ROOT, PageTest


class Agreement(PageTest):
    def test_live_and_true_picture_agree_in_the_tutorial(self):
        for name, sharp in (("three_points", 0.08), ("tilt", 0.03), ("swing", 0.02)):
            with self.subTest(name):
                self.open(ROOT / "scenes" / "tutorial" / f"{name}.pov", "+W320", "+H180")
                found = self.difference(320)
                self.assertLess(found["rmse"], 0.03, found)
                self.assertLess(found["rmse"], 1.1 * found["sharp"], found)
                # near 0 if the preview were not a pinhole's
                self.assertGreater(found["sharp"], 0.5 * sharp, found)
                self.press("input[name=mode][value=one]")
                for knob, value in (("tilt", 0), ("swing", 0), ("fStop", 1)):
                    self.set_number(knob, value)
                self.click_at(-0.1, -0.4)
                found = self.difference(320)
                self.assertLess(found["rmse"], 0.04, found)
                self.assertGreater(found["sharp"], 1.5 * found["rmse"], found)
                self.end()


if __name__ == "__main__":
    harness.main()

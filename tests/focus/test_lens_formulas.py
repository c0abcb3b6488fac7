# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The page's lens equals the program's."""

import json
import subprocess

from tests.focus import harness
from tests.focus.harness import ROOT, SETTINGS, PageTest

CASES = 4000


class LensFormulas(PageTest):
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


if __name__ == "__main__":
    harness.main()

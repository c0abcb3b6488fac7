# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
import re

from tests.focus.harness import SETTINGS, PageTest
from tools import povray_run

PLACES = ((-0.41, -0.41), (0.28, -0.055), (-0.03, 0.3), (0.3, -0.4), (0.4, 0.3))
WITHIN = 1.5  # pixels
ROW = r"(?P<blur>[\d.]+) px (?P<side>before|behind)(?P<binds>, binds)?|sharp"


class MorePage(PageTest):
    def click_all(self, places=PLACES):
        self.press("input[name=mode][value=more]")
        for x, y in places:
            self.click_at(x, y)
        self.assertEqual(len(self.run("return focusPage.model.picks")), len(places))

    def rows(self):
        texts = self.run("return [...document.querySelectorAll('#sharp-points li span')].map(e => e.textContent)")
        found = [re.fullmatch(ROW, text) for text in texts]
        self.assertTrue(all(found), texts)
        return [(float(row["blur"] or 0) * (1 if row["side"] == "before" else -1), bool(row["binds"])) for row in found]

    def hold(self, within=WITHIN):
        self.set_number("within", within)
        self.press("#hold")

    def reported(self, scene, size):
        command = povray_run.command(SETTINGS.povray, scene, None, size, "+SR1", "+ER1", library=[povray_run.INCLUDE])
        said = povray_run.run(command, self.folder).succeeded().said
        text = re.sub(r"\n (?! )", " ", said)  # what the console has wrapped
        points = re.findall(r"^    \d+\.+<[^>]*>: ([\d.e-]+) pixels \([\d.e-]+ mm\) (before|behind)(, binds)?", text, re.MULTILINE)
        blurs = [(float(blur) * (1 if side == "before" else -1), bool(binds)) for blur, side, binds in points]
        without = re.search(r"without tilt\.+f/([\d.]+)", text)
        return float(re.search(r"Aperture\.+f/([\d.]+)", text)[1]), blurs, without and float(without[1])

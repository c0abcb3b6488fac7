# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Common to the tests of many points: clicks, and the page's list of them."""

import re

from tests.focus.harness import PageTest

# on the fronts of the three towers, on the floor and on the wall
PLACES = ((-0.41, -0.41), (0.28, -0.055), (-0.03, 0.3), (0.3, -0.4), (0.4, 0.3))
WITHIN = 1.5  # pixels
ROW = r"(?P<blur>[\d.]+) px (?P<side>before|behind)(?P<binds>, binds)?|sharp"


class MorePage(PageTest):
    """A test with points of "More"."""

    def click_all(self, places=PLACES):
        """Clicks the places as points of "More"."""
        self.press("input[name=mode][value=more]")
        for x, y in places:
            self.click_at(x, y)
        self.assertEqual(len(self.run("return focusPage.model.picks")), len(places))

    def rows(self):
        """(signed blur, whether it binds) of each row of the page's list."""
        texts = self.run("return [...document.querySelectorAll('#sharp-points li span')].map(e => e.textContent)")
        found = [re.fullmatch(ROW, text) for text in texts]
        self.assertTrue(all(found), texts)
        return [(float(row["blur"] or 0) * (1 if row["side"] == "before" else -1), bool(row["binds"])) for row in found]

    def hold(self, within=WITHIN):
        """Has the f-stop found."""
        self.set_number("within", within)
        self.press("#hold")

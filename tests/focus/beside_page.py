# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
from tests.focus.harness import PageTest

FIGURES = """
return ["figures", "other-figures"].map(id => {
    const place = document.getElementById(id);
    return [place.querySelector("b").textContent, place.childNodes[1].data.trim(), ...[...place.querySelectorAll("li")].map(li => li.textContent)];
});
"""


class BesidePage(PageTest):
    def open_pair(self, scene=None):
        """A passes through the three towers; B is shown."""
        self.open(scene or self.scene())
        self.set_number("fStop", 0.7)
        self.pick_towers()
        self.press("#beside")
        self.assertEqual(self.run(FIGURES)[1][1:], self.run(FIGURES)[0][1:], "it begins as a copy")
        self.press("input[name=pair][value=B]")
        self.set_number("fStop", 2)
        self.set_number("tilt", 0)

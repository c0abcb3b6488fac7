# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Reload, Back and a second tab keep the lens in the page's address."""

import base64
import json

from tests.focus import harness
from tests.focus.harness import SCENE, PageTest

PLACES = ((-0.41, -0.41), (0.28, -0.055), (-0.03, 0.3), (0.3, -0.4))
STATE = "return JSON.stringify(focusPage.model.state)"


class AddressPage(PageTest):
    def state(self):
        return json.loads(self.run(STATE))

    def kept(self):
        text = self.browser.current_url.partition("#")[2]
        return json.loads(base64.urlsafe_b64decode(text + "=" * (-len(text) % 4)))

    def said(self):
        return self.run("return document.querySelector('[data-said=points]').textContent")

    def choose_lens(self):
        self.press("input[name=mode][value=more]")
        for x, y in PLACES:
            self.click_at(x, y)
        self.set_number("sceneUnit", 20)
        self.set_number("within", 0.5)
        self.press("#hold")
        self.set_number("shiftUp", 1)


class Kept(AddressPage):
    def test_nothing_is_lost(self):
        address = self.open(self.scene())
        self.choose_lens()
        wanted, shown = self.state(), self.text("block")
        self.assertEqual((len(wanted["picks"]), wanted["hold"], wanted["block"]["shift"]), (4, True, [0, 1]))
        self.assertTrue(self.browser.current_url.startswith(f"{address}#"))
        self.browser.refresh()
        self.until("the preview", self.drawn)
        self.assertEqual((self.state(), self.text("block")), (wanted, shown), "after a reload")
        self.browser.get("about:blank")
        self.browser.back()
        self.until("the preview", self.drawn)
        self.assertEqual(self.state(), wanted, "after Back")
        here, first = self.browser.current_url, self.browser.current_window_handle
        self.browser.switch_to.new_window("tab")
        self.browser.get(here)
        self.until("the preview", self.drawn)
        self.assertEqual(self.state(), wanted, "in a second tab")
        self.set_number("tilt", 2)
        self.browser.close()
        self.browser.switch_to.window(first)
        self.assertEqual(self.state(), wanted, "in the first tab")
        self.set_number("tilt", 2)
        self.assertEqual(self.kept()["state"], self.state())
        self.press("#back")
        self.assertEqual(self.kept()["state"], wanted, "a step back is kept as well")
        self.assertEqual(self.console(), [])

    def test_the_lens_stays_when_it_has_been_written(self):
        scene = self.scene()
        self.open(scene)
        self.choose_lens()
        wanted, old = self.state(), self.browser.current_url
        self.press("#write")
        self.until("the change", lambda: "Written" in self.text("file-said"))
        self.until("the new preview", lambda: "new preview" in self.text("status") and self.drawn())
        self.assertEqual(self.state(), wanted)
        for address, words in ((old, "the moment after the change"), (self.browser.current_url, "later")):
            with self.subTest(words):
                self.browser.get("about:blank")
                self.browser.get(address)
                self.until("the preview", self.drawn)
                self.assertEqual((self.state(), self.said()), (wanted, ""))


class Others(AddressPage):
    def test_a_chosen_camera_stays_chosen(self):
        self.open(self.scene(SCENE + "camera { location <6, 2, -6> look_at <0, 0.5, 0> right x*image_width/image_height angle 50 }\n"))
        self.choose("camera", 0)
        at = "return [document.getElementById('camera').value, focusPage.model.camera.location[2], focusPage.live.location[2]]"
        self.until("the other camera", lambda: self.drawn() and self.run(at) == ["0", -7, -7])
        self.set_number("tilt", 3)
        self.browser.refresh()
        self.until("the other camera again", lambda: self.drawn() and self.run(at) == ["0", -7, -7])
        self.assertAlmostEqual(self.run("return focusPage.model.numbers().tilt"), 3)

    def test_an_address_that_fits_not_is_refused_with_a_word(self):
        address = self.open(self.scene())
        good = self.kept()
        own = self.state()
        block = good["state"]["block"]
        for name, bad in {
            "another camera": {**good, "of": "1234"},
            "no block": {**good, "state": {**good["state"], "block": None}},
            "a number of words": {**good, "state": {**good["state"], "block": {**block, "fStop": "2"}}},
            "half a point": {**good, "state": {**good["state"], "picks": [[1, 2]]}},
            "an endless list": {**good, "state": {**good["state"], "picks": [[1, 2, 3]] * 101}},
            "an unknown family": {**good, "state": {**good["state"], "block": {**block, "family": "constructor"}}},
            "a list": [],
        }.items():
            with self.subTest(name):
                text = base64.urlsafe_b64encode(json.dumps(bad).encode()).decode().rstrip("=")
                self.browser.get("about:blank")
                self.browser.get(f"{address}#{text}")
                self.until("the preview", self.drawn)
                self.assertIn("The address holds a lens of another camera or scene", self.said())
                self.assertEqual(self.state()["block"]["family"], own["block"]["family"])
        self.browser.get("about:blank")
        self.browser.get(f"{address}#nonsense%F0")
        self.until("the preview", self.drawn)
        self.assertEqual(self.said(), "")
        self.assertEqual(self.console(), [])


if __name__ == "__main__":
    harness.main()

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Typed numbers, early clicks, and remarks."""

from selenium.webdriver.common.keys import Keys

from tests.focus import harness
from tests.focus.harness import PageTest

EARLY_CLICK = """
const done = arguments[0];
import(new URL("page/model.js", document.location)).then(({ Model }) => {
    const model = new Model(), page = focusPage.model, view = { ...page.camera, ...page.place, aperture: 0, block: null };
    model.take(view);
    const before = model.open;
    model.pick(page.picks[0]);
    done([before, model.open, model.block.sceneUnit === page.block.sceneUnit, model.picks.length]);
}).catch(error => done(String(error)));
"""


class Typed(PageTest):
    def said(self, knob):
        return self.run("return document.getElementById(arguments[0]).closest('.knob').querySelector('.said').textContent", knob)

    def typed(self, knob, words):
        field = self.element(knob)
        self.run("arguments[0].scrollIntoView({ block: 'center' })", field)
        field.send_keys(Keys.CONTROL, "a", Keys.NULL, words, Keys.TAB)
        return self.run("return arguments[0].value", field), self.said(knob)

    def test_a_number_is_taken_or_refused_with_a_word(self):
        self.open(self.scene())
        for knob, words, shown, said in (
            ("fStop", "3,5", "3.5", ""),
            ("fStop", "0", "3.5", "0 is refused: a number above 0 is needed."),
            ("fStop", "-1", "3.5", "-1 is refused: a number above 0 is needed."),
            ("fStop", " 4. ", "4", ""),
            ("fStop", "1.234,5", "4", "1.234,5 is refused: a number above 0 is needed."),
            ("fStop", "1e999", "4", "1e999 is refused: a number above 0 is needed."),
            ("fStop", "f/8", "4", "f/8 is refused: a number above 0 is needed."),
            ("angle", "180", "45", "180 is refused: an angle of more than 0 and less than 180 is needed."),
            ("shiftUp", Keys.DELETE, "0", "Nothing is refused: a number is needed."),
            ("shiftUp", "-,5", "-0.5", ""),
            ("tilt", "1,25", "1.25", ""),
            ("sceneUnit", "0", None, "0 is refused: a number above 0 is needed."),
        ):
            with self.subTest(knob, words=words):
                found, beside = self.typed(knob, words)
                self.assertEqual(beside, said)
                if shown is not None:
                    self.assertEqual(found, shown)
        self.assertEqual(self.run("return focusPage.model.block.fStop"), 4)
        self.element("fStop").send_keys(Keys.ARROW_UP)
        self.assertEqual(self.run("return focusPage.model.block.fStop"), 5)
        self.assertEqual(self.said("sceneUnit"), "", "what was refused before")

    def test_an_early_click_stays_and_takes_the_scale_of_a_model(self):
        self.open(self.scene())
        self.until("a proposed focus", lambda: self.run("return focusPage.model.picks.length"))
        self.assertEqual(self.browser.execute_async_script(EARLY_CLICK), [True, False, True, 1])

    def test_reason_ends_with_one_full_stop(self):
        scene = self.scene()
        self.open(scene)
        scene.write_text(scene.read_text().replace("angle 45", "angle 45 tilt_lens { f_stop 2 } tilt_lens { f_stop 3 }"))
        self.press("#write")
        self.until("the refusal", lambda: "Not written" in self.text("file-said"))
        self.assertIn("merge the two. Copy the text", self.text("file-said"))


if __name__ == "__main__":
    harness.main()

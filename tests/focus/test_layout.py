# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
from tests.focus import harness
from tests.focus.harness import PageTest

SMALLEST = 24  # pixels: least size of a touch target (WCAG 2.2, target size)

# Least side of touch targets, labels included.
TARGETS = """
return [...document.querySelectorAll("button, select, a[href], input[inputmode], .switch label")].filter(e => e.checkVisibility()).map(e => {
    const box = e.getBoundingClientRect();
    return [Math.min(box.width, box.height), e.id || e.textContent];
});
"""
# Least contrast of text (WCAG 2.2).
CONTRAST = """
const rgb = text => text.match(/[\\d.]+/g).map(Number);
const luminance = c => c.slice(0, 3).map(v => v / 255).map(v => v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4)
    .reduce((sum, v, i) => sum + v * [0.2126, 0.7152, 0.0722][i], 0);
const behind = e => {
    for (; e; e = e.parentElement) {
        const colour = rgb(getComputedStyle(e).backgroundColor);
        if (colour.length < 4 || colour[3] === 1)
            return colour;
    }
    return [255, 255, 255];
};
let worst = [21, ""];
for (const e of document.querySelectorAll("body *"))
    if (e.checkVisibility() && !e.disabled && !e.closest("svg, #points") && [...e.childNodes].some(n => n.nodeType === 3 && n.data.trim())) {
        const [a, b] = [luminance(rgb(getComputedStyle(e).color)), luminance(behind(e))];
        const ratio = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
        if (ratio < worst[0])
            worst = [ratio, e.textContent];
    }
return worst;
"""


CLIPPED = """
const { left, right, top, bottom } = document.getElementById("side").getBoundingClientRect();
return [...document.querySelectorAll("#side text")].filter(text => {
    const box = text.getBoundingClientRect();
    return box.left < left || box.right > right || box.top < top || box.bottom > bottom;
}).map(text => text.textContent);
"""


class Layout(PageTest):
    def set_device(self, width, height):
        metrics = {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": width < 800}
        self.browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", metrics)
        self.addCleanup(self.browser.execute_cdp_cmd, "Emulation.clearDeviceMetricsOverride", {})

    def test_on_a_phone_all_fits_and_nothing_covers_the_points(self):
        self.open(self.scene())
        for width in (360, 412):
            self.set_device(width, 780)
            self.assertLessEqual(self.run("return document.documentElement.scrollWidth"), width)
            small = [name for size, name in self.run(TARGETS) if size < SMALLEST]
            self.assertEqual(small, [])
        self.press("input[name=mode][value=three]")
        for x, y in ((-0.4, -0.45), (0.3, -0.45), (0, 0.2)):
            self.click_at(x, y)
        self.true_picture(160)
        top = """
        return [...document.querySelectorAll("#points button")].map(point => {
            const box = point.getBoundingClientRect(), x = box.left + box.width / 2, y = box.top + box.height / 2;
            return document.elementFromPoint(x, y) === point;
        });
        """
        self.run("scrollTo(0, 0)")
        self.assertEqual(self.run(top), [True, True, True])
        boxes = self.run("return ['stage', 'wipe'].map(id => document.getElementById(id).getBoundingClientRect().toJSON())")
        self.assertGreaterEqual(boxes[1]["top"], boxes[0]["bottom"])

    def test_on_a_phone_the_labels_of_the_side_view_are_whole(self):
        self.open(self.scene())
        self.set_device(360, 780)
        self.until("the side view", lambda: self.run("return document.getElementById('side').viewBox.baseVal.width") < 360)
        seen = set()
        for tilt in (-8, -2, 0, 2, 8):
            self.set_number("tilt", tilt)
            for place in ((-0.41, -0.41), (0.28, -0.055), (-0.03, 0.3), (0.4, 0.4)):
                self.click_at(*place)
                with self.subTest(tilt=tilt, place=place):
                    self.assertEqual(self.run(CLIPPED), [])
                seen |= set(self.run("return [...document.querySelectorAll('#side text')].map(text => text.textContent)"))
        self.assertLessEqual({"film", "lens", "plane of sharp focus", "film, lens and plane meet"}, seen)

    def test_on_a_phone_the_picture_stays_in_view_beside_the_knobs(self):
        self.open(self.scene())
        self.set_device(360, 780)
        self.run("document.getElementById('bladesAngle').scrollIntoView({ block: 'end' })")
        box = self.run("return document.getElementById('stage').getBoundingClientRect().toJSON()")
        self.assertAlmostEqual(box["top"], 0, delta=1)
        knob = self.run("return document.getElementById('bladesAngle').getBoundingClientRect().toJSON()")
        self.assertGreater(knob["top"], box["bottom"])

    def test_texts_can_be_read_in_the_light_and_in_the_dark(self):
        self.open(self.scene())
        self.set_number("tilt", 95)  # with a remark
        backgrounds = []
        for scheme in ("light", "dark"):
            features = [{"name": "prefers-color-scheme", "value": scheme}]
            self.browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": features})
            self.addCleanup(self.browser.execute_cdp_cmd, "Emulation.setEmulatedMedia", {"features": []})
            contrast, where = self.run(CONTRAST)
            self.assertGreater(contrast, 4.5, f"{where} in the {scheme}")
            backgrounds.append(self.run("return getComputedStyle(document.body).backgroundColor"))
        self.assertNotEqual(*backgrounds)


if __name__ == "__main__":
    harness.main()

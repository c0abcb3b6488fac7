# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Measures the page, writes the tables of docs/focus.md and takes its pictures:

    /usr/bin/python3 run_module.py tests.focus.measure --povray build/bin/povray

Times are those of headless Chromium with graphics done by the processor, on this machine as it is."""

import os
import re
import statistics
import subprocess
import time

from tests.focus import harness
from tests.focus.harness import ROOT, PageTest

PAGE = ROOT / "docs" / "focus.md"
PICTURES = ROOT / "docs" / "pictures" / "focus"
SCENES = ("three_points", "tilt", "swing")
LARGE, SIZE = ("+W960", "+H540"), ("+W480", "+H270")
CLICKS = 12
TIME_A_CLICK = """
const done = arguments[2], picture = document.getElementById("picture"), box = picture.getBoundingClientRect(), begun = performance.now();
picture.dispatchEvent(new MouseEvent("click", { clientX: box.left + (0.5 + arguments[0]) * box.width, clientY: box.top + (0.5 - arguments[1]) * box.height }));
focusPage.nextDrawing().then(() => done(performance.now() - begun));
"""


class Measure(PageTest):
    """Not a test of its own: it makes the page's figures."""

    def start_times(self, scene, *words):
        """Seconds from the command to the first picture through the lens, and to the whole preview."""
        begun = time.monotonic()
        self.browser.get(self.start(scene, *words))
        self.until("a first picture", lambda: self.run("return window.focusPage?.live"), 300)
        self.run("focusPage.nextDrawing()")
        first = time.monotonic() - begun
        self.until("the preview", lambda: self.run("return focusPage.live.complete"), 300)
        return first, time.monotonic() - begun

    def difference(self):
        """Differences of the live picture and the true one, at the size of the preview."""
        self.true_picture(480)
        self.smooth()
        return self.run(harness.DIFFERENCE)

    def shot(self, name):
        """Keeps what the browser shows."""
        shown = "const end = arguments[0]; requestAnimationFrame(() => requestAnimationFrame(() => requestAnimationFrame(end)))"
        self.browser.execute_async_script(shown)
        time.sleep(0.3)  # a change of the page's size draws anew
        self.smooth()
        PICTURES.mkdir(parents=True, exist_ok=True)
        png = self.folder / "shot.png"
        self.browser.save_screenshot(str(png))
        subprocess.run(["oiiotool", str(png), "--nosoftwareattrib", "--ch", "R,G,B", "--compression", "jpeg:88", "-o", str(PICTURES / f"{name}.jpg")], check=True)

    def pictures(self):
        """The page as the documents show it: its parts, in the dark, and on a phone."""
        self.shot("page")
        for name in ("map", "planes"):
            self.press(f"#show-{name}")
            self.shot(name)
            self.press(f"#show-{name}")
        feature = {"name": "prefers-color-scheme", "value": "dark"}
        self.browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": [feature]})
        self.shot("dark")
        self.browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": []})
        phone = {"width": 400, "height": 860, "deviceScaleFactor": 1, "mobile": True}
        self.browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", phone)
        self.run("scrollTo(0, 0)")
        self.shot("phone")
        self.browser.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})

    def test_pictures(self):
        self.open(ROOT / "scenes" / "tutorial" / f"{SCENES[0]}.pov", "+W640", "+H360")
        self.smooth()
        self.pictures()

    def test_measure(self):
        rows, clicks = [], []
        for name in SCENES:
            scene = ROOT / "scenes" / "tutorial" / f"{name}.pov"
            first, start = self.start_times(scene, *LARGE)
            self.press("input[name=mode][value=one]")
            for i in range(CLICKS):
                clicks.append(self.browser.execute_async_script(TIME_A_CLICK, 0.3 * (i % 3 - 1), -0.1 - 0.03 * i))
                time.sleep(0.2)
            self.end()
            self.open(scene, *SIZE)
            found = self.difference()
            rows.append(f"| `{name}.pov` | {first:.1f} s | {start:.1f} s | {found['rmse']:.4f} | {found['sharp']:.4f} |")
            self.end()
        load = os.getloadavg()[0]
        text = "\n".join(
            [
                f"Measured by `tests/focus/measure.py`, on {os.cpu_count()} processors with a load of {load:.0f}, with Chromium's graphics done by the",
                f"processor. From a click to the first blurred picture for it: {statistics.median(clicks):.0f} ms in the median of {len(clicks)} clicks, "
                f"{min(clicks):.0f} to {max(clicks):.0f} ms.",
                "",
                "| scene | to the first picture | to the whole preview | RMSE of the live picture | RMSE without blur |",
                "| --- | --- | --- | --- | --- |",
                *rows,
                "",
                "Times are from the command on, with the browser open already, those of clicks too for a preview of 960 by 540. RMSE is against the true",
                "picture of quality *good*, of values as displayed, white being 1, at 480 by 270; the last column is how far the picture without any",
                "blur is from it. In `tilt.pov` and `swing.pov` nearly all is sharp.",
            ]
        )
        page = PAGE.read_text()
        marked = re.compile(r"(<!-- measured: tests/focus/measure.py -->\n).*(<!-- end of measured -->)", re.DOTALL)
        PAGE.write_text(marked.sub(lambda m: m[1] + text + "\n" + m[2], page))


if __name__ == "__main__":
    harness.main()

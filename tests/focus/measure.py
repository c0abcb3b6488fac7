# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Measures the page, writes the tables of docs/focus.md and takes its pictures:

/usr/bin/python3 run_module.py tests.focus.measure --povray build/bin/povray [Measure.make_times]

Times are those of software rendering."""

import os
import statistics
import subprocess
import time

from tests.focus import harness
from tests.focus.harness import ROOT, PageTest
from tools.docs import marked

PAGE = ROOT / "docs" / "focus.md"
PICTURES = ROOT / "docs" / "pictures" / "focus"
TUTORIAL = sorted(path.stem for path in (ROOT / "scenes" / "tutorial").glob("*.pov"))
SCENES = ("three_points", "tilt", "swing")  # for the live picture against the true one
LARGE, SIZE = ("+W960", "+H540"), ("+W480", "+H270")
POINTS = ((-0.28, -0.36), (0.31, -0.27), (0.02, 0.01), (-0.2, -0.05), (0.1, -0.42))
SET_CLOCK = (
    "const e = document.getElementById('time'); e.value = arguments[0]; for (const n of ['input', 'change']) e.dispatchEvent(new Event(n))"
)
CLICKS = 12
STARTS = 3  # of each scene; the median is reported
# Milliseconds from a click until its first blurred picture is drawn and shown.
TIME_A_CLICK = """
const done = arguments[2], picture = document.getElementById("picture"), box = picture.getBoundingClientRect(), begun = performance.now();
picture.dispatchEvent(new MouseEvent("click", { clientX: box.left + (0.5 + arguments[0]) * box.width, clientY: box.top + (0.5 - arguments[1]) * box.height }));
const shown = drawn => requestAnimationFrame(() => done([drawn, performance.now() - begun]));
focusPage.nextDrawing().then(() => shown(performance.now() - begun));
"""
# Frames per second, milliseconds of drawing, and widths while the tilt turns.
TURN = """
const [seconds, done] = arguments, slider = document.querySelector("#tilt").previousElementSibling, work = [], widths = [];
const canvas = document.getElementById("picture"), begun = performance.now();
let seen = focusPage.drawings;
const step = now => {
    if (focusPage.drawings !== seen) {
        seen = focusPage.drawings;
        work.push(focusPage.live.work);
        widths.push(canvas.width);
    }
    if (now - begun > 1000 * seconds)
        return done({ rate: 1000 * work.length / (now - begun), work, widths });
    slider.value = 5 * Math.sin((now - begun) / 300);
    slider.dispatchEvent(new Event("input"));
    requestAnimationFrame(step);
};
requestAnimationFrame(step);
"""


class Measure(PageTest):
    def start_times(self, scene, *words):
        begun = time.monotonic()
        self.browser.get(self.start(scene, *words))
        page = time.monotonic() - begun
        self.until("a first picture", lambda: self.run("return window.focusPage?.live"))
        self.run("focusPage.nextDrawing()")
        first = time.monotonic() - begun
        self.until("the preview", lambda: self.run("return focusPage.live.complete"))
        return page, first, time.monotonic() - begun

    def shot(self, name):
        shown = "const end = arguments[0]; requestAnimationFrame(() => requestAnimationFrame(() => requestAnimationFrame(end)))"
        self.browser.execute_async_script(shown)
        time.sleep(0.3)  # a change of the page's size redraws
        self.smooth()
        PICTURES.mkdir(parents=True, exist_ok=True)
        png = self.folder / "shot.png"
        self.browser.save_screenshot(str(png))
        subprocess.run(
            ["oiiotool", str(png), "--nosoftwareattrib", "--ch", "R,G,B", "--compression", "jpeg:88", "-o", str(PICTURES / f"{name}.jpg")],
            check=True,
        )

    def pictures(self):
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
        self.points()
        self.beside()
        self.pull()

    def points(self):
        self.press("input[name=mode][value=one]")
        self.press("input[name=mode][value=more]")
        for place in POINTS:
            self.click_at(*place)
        self.press("#hold")
        self.shot("points")

    def beside(self):
        self.press("#beside")
        self.press("input[name=pair][value=B]")
        for knob in ("tilt", "swing"):
            self.set_number(knob, 0)
        self.press("input[name=pair][value=A]")
        self.shot("beside")
        self.press("#beside")

    def pull(self):
        self.press("#pull summary")
        for time_, place in ((0, POINTS[0]), (1, POINTS[2])):
            self.run(SET_CLOCK, time_)
            self.press("input[name=mode][value=one]")
            self.click_at(*place)
            self.set_number("fStop", 2.8)
            self.press("#mark")
        self.run("document.getElementById('pull').scrollIntoView()")
        self.shot("pull")

    def make_pictures(self):
        self.open(ROOT / "scenes" / "tutorial" / f"{SCENES[0]}.pov", "+W640", "+H360")
        self.smooth()
        self.pictures()

    def clicks(self):
        self.press("input[name=mode][value=one]")
        found = []
        for i in range(CLICKS):
            found.append(self.browser.execute_async_script(TIME_A_CLICK, 0.3 * (i % 3 - 1), -0.1 - 0.03 * i))
            time.sleep(0.2)
        return found

    def make_times(self):
        rows, clicks, turns = [], [], []
        for name in TUTORIAL:
            starts = []
            for again in range(STARTS):
                starts.append(self.start_times(ROOT / "scenes" / "tutorial" / f"{name}.pov", *LARGE))
                if name in SCENES and again == 0:
                    clicks += self.clicks()
                    turns.append(self.browser.execute_async_script(TURN, 3))
                self.end()
            medians = " | ".join(f"{statistics.median(times):.1f} s" for times in zip(*starts))
            rows.append(f"| `{name}.pov` | {medians} |")
        heads = ["| scene | to the page | to the first picture | to the whole preview |", "| --- | --- | --- | --- |"]
        self.put("times", [*self.words(clicks, turns), "", *heads, *rows])

    def words(self, clicks, turns):
        drawn, shown = zip(*clicks)
        work = [time for turn in turns for time in turn["work"]]
        widths = [width for turn in turns for width in turn["widths"]]
        rate = statistics.mean(turn["rate"] for turn in turns)
        return [
            f"On {os.cpu_count()} processors with a load of {os.getloadavg()[0]:.0f}, with Chromium's graphics done by the processor, a preview of 960 by 540, and the",
            "browser open already:",
            "",
            f"- From a click to the first blurred picture for it: {statistics.median(drawn):.0f} ms in the median of {len(clicks)} clicks until it is drawn",
            f"  ({min(drawn):.0f} to {max(drawn):.0f} ms), {statistics.median(shown):.0f} ms until the browser begins its next picture ({min(shown):.0f} to {max(shown):.0f} ms).",
            f"- While the tilt is turned, {rate:.0f} pictures in a second; the median takes {statistics.median(work):.0f} ms to draw, at a width that falls",
            f"  to {statistics.median(widths):.0f} of 960 pixels.",
            f"- From the command to the page, to the first picture through the lens, and to the whole preview (medians of {STARTS} starts):",
        ]

    def make_differences(self):
        rows = []
        for name in SCENES:
            self.open(ROOT / "scenes" / "tutorial" / f"{name}.pov", *SIZE)
            found = self.difference(480)
            rows.append(f"| `{name}.pov` | {found['rmse']:.4f} | {found['sharp']:.4f} |")
            self.end()
        self.put("differences", ["| scene | RMSE of the live picture | RMSE without blur |", "| --- | --- | --- |", *rows])

    def put(self, name, lines):
        place = (f"measured: tests/focus/measure.py, {name}", f"end of {name}")
        PAGE.write_text(marked.filled(PAGE, *place, "\n".join(lines) + "\n"))


if __name__ == "__main__":
    harness.main("make")

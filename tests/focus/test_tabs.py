# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Each tab keeps its own camera, clock and frame."""

import asyncio

from tests.focus import harness
from tests.focus.client import WORDS, ClientTest, page_at
from tests.focus.harness import SCENE, PageTest

MOVING = SCENE.replace("location <0, 3, -7>", "location <clock, 3, -7>")
TWO = MOVING + "camera { location <6, 2, -6 - clock> look_at <0, 0.5, 0> right x*image_width/image_height angle 50 }\n"
FIRST = 0  # index of the camera that the scene is not rendered with


class Tabs(ClientTest):
    def test_each_page_keeps_its_clock_and_camera(self):
        scene = self.scene(TWO)
        address = self.start(scene, *WORDS)

        async def use():
            async with page_at(address) as one, page_at(address) as two:
                for page in (one, two):
                    await page.told("preview", "done")
                self.assertEqual(one.view["location"], [6, 2, -6])
                await one.ask("preview", clock=0.5)
                told = await one.told("scene")
                self.assertEqual((told["clock"], told["view"]["location"]), (0.5, [6, 2, -6.5]))
                await one.told("preview", "done")
                await one.ask("preview", chosen=FIRST, camera={**one.camera(), "location": [0.5, 3, -7]})
                self.assertEqual((await one.told("preview", "done"))["frame"]["location"], [0.5, 3, -7])
                before = len(two.kinds)
                await two.render()
                self.assertIsNone((await two.told("picture", "done"))["lens"]["clock"])
                self.assertEqual({"scene", "preview"} & set(two.kinds[before:]), set(), "messages about the other page's choices")
                self.assertIsNone((await one.told("picture", "done"))["lens"]["clock"], "all pages see the picture")
                await one.render()
                self.assertEqual((await one.told("picture", "done"))["lens"]["clock"], 0.5)
                scene.write_text(TWO + "sphere { 0, 0.1 }\n")
                times = [(await page.told("scene"))["clock"] for page in (one, two)]
                self.assertEqual(times, [0.5, None])

        asyncio.run(use())
        self.assertEqual(self.evidence(), "")

    def test_each_page_writes_into_its_camera(self):
        scene = self.scene(TWO)
        address = self.start(scene, *WORDS)
        first = TWO.partition("light_source")[0]

        async def use():
            async with page_at(address) as one, page_at(address) as two:
                for page in (one, two):
                    cameras = (await page.told("scene"))["cameras"]
                    await page.told("preview", "done")
                one.view = cameras[FIRST]
                await one.ask("preview", chosen=FIRST, camera=one.camera())
                await one.told("preview", "done")
                await two.write()
                self.assertEqual((await two.told("file"))["state"], "written")
                text = scene.read_text()
                self.assertTrue(text.startswith(first), "the camera of the first page")
                self.assertIn("focal_plane", text)
                self.assertEqual((await one.told("file"))["chosen"], FIRST)
                await one.told("preview", "done")
                one.view = cameras[FIRST]
                await one.write()
                self.assertEqual((await one.told("file"))["state"], "written")
                self.assertEqual(scene.read_text().count("focal_plane"), 2)

        asyncio.run(use())
        self.assertEqual(self.evidence(), "")

    def test_files_that_only_one_page_reads_are_watched(self):
        scene = self.scene(SCENE + '#if (clock > 0.4) #include "late.inc" #end\n')
        (self.folder / "late.inc").write_text("sphere { 0, 0.1 }\n")
        address = self.start(scene, *WORDS)

        async def use():
            async with page_at(address) as one, page_at(address) as two:
                for page, clock in ((one, 0.5), (two, 0.25)):
                    await page.told("preview", "done")
                    await page.ask("preview", clock=clock)
                    await page.told("preview", "done")
                (self.folder / "late.inc").write_text("sphere { 0, 0.2 }\n")
                self.assertEqual((await one.told("changed"))["files"], ["late.inc"])
                await one.told("preview", "done")

        asyncio.run(use())

    def test_pages_that_show_the_same_share_a_render(self):
        text, gate = self.gated()
        address = self.start(self.scene(text), *WORDS)

        async def use():
            async with page_at(address) as one:
                await one.told("preview", "done")
                gate.touch()
                async with page_at(address) as two:
                    self.assertEqual((await two.told("preview", "done"))["number"], 1)
                    self.assertGreater(two.tiles, 0)
                gate.unlink()

        asyncio.run(use())


class Reload(PageTest):
    def test_the_clock_and_the_picture_of_its_time(self):
        self.open(self.scene(MOVING))
        at = "return focusPage.model.camera.location[0]"
        script = (
            "const e = document.getElementById('clock'); e.value = 0.5; for (const n of ['input', 'change']) e.dispatchEvent(new Event(n))"
        )
        self.choose("quality", 0)
        self.true_picture(160)
        self.assertNotIn("Of another", self.text("true-said"))
        self.run(script)
        self.until("the other place", lambda: self.drawn() and self.run(at) == 0.5)
        self.assertIn("Of another lens: render again.", self.text("true-said"))
        self.set_number("tilt", 3)
        self.browser.refresh()
        self.until("the other place again", lambda: self.drawn() and self.run(at) == 0.5)
        self.assertAlmostEqual(self.run("return focusPage.model.numbers().tilt"), 3)
        self.assertEqual(self.text("clock-value"), "0.5")
        self.end()
        address = self.open(self.scene(SCENE + "sphere { clock, 0.1 }\n", "still.pov"))
        self.true_picture(160)
        self.run(script)
        self.until("the word", lambda: "Of another time: render again." in self.text("true-said"))
        first = self.browser.current_window_handle
        self.browser.switch_to.new_window("tab")
        self.browser.get(address)
        self.until("the preview", self.drawn)
        self.assertEqual(self.text("clock-value"), "0", "a second tab begins with the clock of the command line")
        self.browser.close()
        self.browser.switch_to.window(first)
        self.assertEqual(self.text("clock-value"), "0.5")
        self.assertEqual(self.console(), [])


if __name__ == "__main__":
    harness.main()

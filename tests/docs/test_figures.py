# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The manual's pictures have their scenes, scripts and portraits, and the lines of its report are explained."""

import pathlib
import re
import tempfile
import unittest

from tools.docs import figures, lens_portraits, marked, pages
from tools.repository import ROOT


class Pictures(unittest.TestCase):
    def setUp(self):
        text = figures.MANUAL.read_text()
        self.shown = sorted(re.findall(r"pictures/manual/([\w.-]+)\.jpg", text))
        self.scenes = {example.name for example in pages.examples_of(pages.blocks_of("manual.md", text)) if example.name}

    def test_each_is_shown_once(self):
        self.assertEqual(self.shown, sorted(figures.MADE))
        self.assertEqual(sorted(path.stem for path in figures.PICTURES.iterdir()), sorted(figures.MADE))

    def test_scenes(self):
        self.assertEqual({scene for scene, _, _ in figures.MADE.values()} - self.scenes, set())
        for name, (scene, options, _) in figures.MADE.items():
            code = next(
                example.block.text
                for example in pages.examples_of(pages.blocks_of("manual.md", figures.MANUAL.read_text()))
                if example.name == scene
            )
            for option in options:
                if option.startswith("Declare="):
                    self.assertIn(f"#ifndef ({option.split('=')[1]})", code, f"{name}: {scene} ignores {option}")

    def test_they_are_small(self):
        for path in figures.PICTURES.iterdir():
            self.assertLess(path.stat().st_size, 60_000, path.name)


class Report(unittest.TestCase):
    def test_its_lines_are_explained(self):
        before, shown, after = marked.parts(figures.MANUAL, *figures.REPORT)
        lines = re.findall(r"^  (\w[\w ]*)\.", shown, re.MULTILINE)
        self.assertGreater(len(lines), 5)
        for line in lines:
            self.assertIn(f"| `{line}` |", after)


class Marked(unittest.TestCase):
    def page(self, text):
        folder = tempfile.TemporaryDirectory(prefix="tilt_lens.")
        self.addCleanup(folder.cleanup)
        page = pathlib.Path(folder.name) / "page.md"
        page.write_text(text)
        return page

    def test_filled(self):
        page = self.page("a\n<!-- table -->\nold\n<!-- end -->\nb <!-- end -->\n")
        self.assertEqual(marked.filled(page, "table", "end", "new\n"), "a\n<!-- table -->\nnew\n<!-- end -->\nb <!-- end -->\n")

    def test_faults(self):
        for text in ("", "<!-- table -->\n", "<!-- end -->\n<!-- table -->\n", 2 * "<!-- table -->\n<!-- end -->\n"):
            with self.subTest(text), self.assertRaisesRegex(SystemExit, "page.md needs the lines <!-- table --> and <!-- end --> once"):
                marked.parts(self.page(text), "table", "end")


class Portraits(unittest.TestCase):
    def test_each_lens_is_shown(self):
        self.assertEqual(
            lens_portraits.PAGE.read_text(encoding="utf-8"), lens_portraits.page(), "python3 -m tools.docs.lens_portraits --table"
        )
        made = {f"{lens}_{shape}.jpg" for lens in lens_portraits.lenses() for shape in lens_portraits.SHAPES}
        self.assertEqual({path.name for path in lens_portraits.PICTURES.iterdir()}, made)
        for path in lens_portraits.PICTURES.iterdir():
            self.assertLess(path.stat().st_size, 30_000, path.name)

    def test_the_scene_has_the_lenses_in_their_order(self):
        files = re.findall(r'"(\w+)\.(?:dat|json)"', lens_portraits.SCENE.read_text())
        self.assertEqual(["ideal", *files], list(lens_portraits.lenses()))


def drawn_by(svg):
    """Other versions of gnuplot write the same lines differently."""
    return re.search(r"Produced by (GNUPLOT [^<]*\S)", svg)[1]


class Drawings(unittest.TestCase):
    def test_up_to_date(self):
        with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
            made = figures.make_drawings([], pathlib.Path(name))
            self.assertEqual(sorted(made), sorted(path.stem for path in figures.DRAWINGS.iterdir()))
            for drawing in made:
                new, old = ((folder / f"{drawing}.svg").read_text() for folder in (pathlib.Path(name), figures.DRAWINGS))
                if drawn_by(new) != drawn_by(old):
                    self.skipTest(f"{drawing}.svg was drawn by {drawn_by(old)}, and here is {drawn_by(new)}")
                self.assertEqual(new, old, f"{drawing}.svg is not what its script draws: python3 -m tools.docs.figures drawings {drawing}")

    def test_each_is_shown(self):
        text = (ROOT / "docs" / "optics.md").read_text()
        self.assertEqual(sorted(re.findall(r"pictures/optics/(\w+)\.svg", text)), sorted(path.stem for path in figures.DRAWINGS.iterdir()))


if __name__ == "__main__":
    unittest.main()

#!/usr/bin/env python3
# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The pictures of the manual and the drawings of the optics are those that docs/figures/make.py makes: no picture
without its scene, none that is not shown, and no drawing older than its script."""

import pathlib
import re
import sys
import tempfile
import unittest

import pages

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "docs" / "figures"))
import make  # noqa: E402


class Pictures(unittest.TestCase):
    def setUp(self):
        text = make.MANUAL.read_text()
        self.shown = sorted(re.findall(r"pictures/manual/([\w.-]+)\.jpg", text))
        self.scenes = {example.name for example in pages.examples_of(pages.blocks_of("manual.md", text)) if example.name}

    def test_each_is_shown_once(self):
        self.assertEqual(self.shown, sorted(make.MADE))
        self.assertEqual(sorted(path.stem for path in make.PICTURES.iterdir()), sorted(make.MADE))

    def test_scenes(self):
        self.assertEqual({scene for scene, _, _ in make.MADE.values()} - self.scenes, set())
        for name, (scene, options, _) in make.MADE.items():
            code = next(example.block.text for example in
                        pages.examples_of(pages.blocks_of("manual.md", make.MANUAL.read_text())) if example.name == scene)
            for option in options:
                if option.startswith("Declare="):
                    self.assertIn(f"#ifndef ({option.split('=')[1]})", code, f"{name}: {scene} ignores {option}")

    def test_they_are_small(self):
        for path in make.PICTURES.iterdir():
            self.assertLess(path.stat().st_size, 60_000, path.name)


class Drawings(unittest.TestCase):
    def test_up_to_date(self):
        with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
            made = make.make_drawings([], pathlib.Path(name))
            self.assertEqual(sorted(made), sorted(path.stem for path in make.DRAWINGS.iterdir()))
            for drawing in made:
                new, old = (folder / f"{drawing}.svg" for folder in (pathlib.Path(name), make.DRAWINGS))
                self.assertEqual(new.read_text(), old.read_text(),
                                 f"{drawing}.svg is not what its script draws: docs/figures/make.py drawings {drawing}")

    def test_each_is_shown(self):
        text = (ROOT / "docs" / "optics.md").read_text()
        self.assertEqual(sorted(re.findall(r"pictures/optics/(\w+)\.svg", text)), sorted(path.stem for path in make.DRAWINGS.iterdir()))


if __name__ == "__main__":
    unittest.main()

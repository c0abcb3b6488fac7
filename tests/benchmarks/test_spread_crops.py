# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The crops of docs/sampling.md agree with benchmarks/spread_crops.py."""

import re
import unittest

from benchmarks import spread_crops
from tools.repository import ROOT

BLOCK = 16


class Crops(unittest.TestCase):
    def test_each_is_made_and_shown(self):
        shown = re.findall(r"pictures/sampling/(\w+)\.jpg", (ROOT / "docs" / "sampling.md").read_text())
        made = [f"spread_{scene}" for scene in spread_crops.CROPS]
        self.assertEqual(sorted(shown), sorted(made))
        self.assertEqual(sorted(path.stem for path in spread_crops.PICTURES.iterdir()), sorted(made))

    def test_they_are_whole_blocks_inside_the_picture(self):
        for scene, corner in spread_crops.CROPS.items():
            for begin, size, most in zip(corner, spread_crops.SIZE, spread_crops.PICTURE):
                self.assertEqual((begin % BLOCK, size % BLOCK), (0, 0), scene)
                self.assertLessEqual(begin + size, most, scene)


if __name__ == "__main__":
    unittest.main()

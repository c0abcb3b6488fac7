# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The pictures of docs/sampling.md are those of benchmarks/spread_crops.py and lamp_crops.py."""

import re
import unittest

from benchmarks import lamp_crops, spread_crops
from tools.repository import ROOT

BLOCK = 16


class Crops(unittest.TestCase):
    def test_each_is_made_and_shown(self):
        page = (ROOT / "docs" / "sampling.md").read_text()
        for folder, made in (
            (spread_crops.PICTURES, [f"spread_{scene}" for scene in spread_crops.CROPS]),
            (lamp_crops.PICTURES, [*lamp_crops.CROPS]),
        ):
            self.assertEqual(sorted(re.findall(rf"pictures/{folder.name}/(\w+)\.jpg", page)), sorted(made))
            self.assertEqual(sorted(path.stem for path in folder.iterdir()), sorted(made))

    def test_they_are_whole_blocks_inside_the_picture(self):
        for scene, corner in spread_crops.CROPS.items():
            for begin, size, most in zip(corner, spread_crops.SIZE, spread_crops.PICTURE):
                self.assertEqual((begin % BLOCK, size % BLOCK), (0, 0), scene)
                self.assertLessEqual(begin + size, most, scene)


if __name__ == "__main__":
    unittest.main()

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The benchmark's parts about the sampler.

usage: test_sampler_parts PROGRAM TOOLS"""

import dataclasses
import pathlib
import sys
import tempfile
import unittest
import unittest.mock

from benchmarks import allocation, found_lamps, report, suite, threads
from benchmarks.lab import TILT_LENS, Failed, Lab

PROGRAM, TOOLS = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
SIZE = (24, 18)
HAVE_KNOWN = ("sky", "pigments")  # scenes whose references have lamps that are easily found


def errors_of(noisy, sharp, counts=(2, 4, 8)):
    return {n: [[noisy / n, sharp / n]] * 4 for n in counts}


class Allocation(unittest.TestCase):
    def test_groups_get_what_they_need(self):
        points = allocation.ideal(errors_of(8.0, 0.0), [100, 100])
        self.assertEqual((points[0], points[-1]), ((2.0, 4.0 / 200), ((8 + 2) / 2, 1.0 / 200)))

    def test_luck_is_not_taken_for_knowledge(self):
        even = {2: [[0.0], [0.0], [10.0], [10.0]], 4: [[10.0], [10.0], [0.0], [0.0]]}
        self.assertEqual(min(error for _, error in allocation.ideal(even, [10])), 1.0)

    def test_as_many_rays_spread_evenly(self):
        even = errors_of(8.0, 8.0)
        adaptive = [
            {"variance": 1e-3, "samples": 4.0, "squares": [[1.0, 1.0]] * 4, "reference_mse": 0.0},
            {"variance": 1e-4, "samples": 9.0, "squares": [[1.0, 1.0]] * 4, "reference_mse": 0.0},
        ]
        (row,) = allocation.compare(even, adaptive, [100, 100])  # nine samples are more than were tried
        self.assertAlmostEqual(row["over_uniform"], 0.5)
        self.assertAlmostEqual(row["over_ideal"], 0.5)

    def test_groups_at_the_edge_are_smaller(self):
        self.assertEqual(allocation.sizes_of_groups(10, 9), [3 * 64, 3 * 16, 3 * 8, 3 * 2])

    def test_section(self):
        row = {
            "scene": "checks",
            "whole": [1000, 750],
            "size": [48, 48],
            "variance": 1e-3,
            "samples": 8.0,
            "mse": 1e-3,
            "over_uniform": 0.9,
            "over_ideal": 1.2,
            "reference_mse": 1e-5,
        }
        text = report.section("allocation", [row, {**row, "scene": "town", "over_uniform": 1.1}])
        for words in ("| emissive checks and spheres | 1000 by 750 | 8 to 8 | 0.90 | 0.75 | 1.20 | 0.01 |", "1.10 at the most (missed)"):
            self.assertIn(words, text)


class Threads(unittest.TestCase):
    MESSAGES = "  Trace Time:       0 hours  0 minutes 25 seconds (25.810 seconds)\n              using 2 thread(s) with 17.232 CPU-seconds total\n"

    def test_times_of_tracing(self):
        self.assertEqual(threads.traced("Radiosity Time: none\n" + self.MESSAGES), (25.81, 17.232))
        with self.assertRaises(Failed):
            threads.traced("no times")

    def test_numbers_of_threads(self):
        for processors, most in ((1, 2), (2, 2), (6, 4), (16, 16), (64, 16)):
            self.assertEqual(threads.numbers_of_threads(processors)[-1], most)

    def test_section(self):
        rows = [
            {
                "scene": "miniature_town",
                "size": [320, 180],
                "threads": count,
                "wall": wall,
                "cpu": 10.0,
                "waited": 1 - 10.0 / (count * wall),
                "run": 2 * wall,
                "idle": 0.25,
            }
            for count, wall in ((1, 10.0), (2, 6.25))
        ]
        slept = [{"scene": "miniature_town", "threads": count, "busy": busy} for count, busy in ((4, 0.98), (16, 0.96), (64, 0.85))]
        text = report.section("threads", {"traced": rows, "slept": slept})
        for words in (
            "| town | 2 | 6.25 | 10.00 | 0.80 | 20.0 % | 12.50 | 25.0 % |",
            "0.80 at the least (missed)",
            "| town | 0.980 | 0.960 | 0.850 |",
            "0.960 at the least (reached)",
            "0.850 at the least (missed)",
        ):
            self.assertIn(words, text)


class FoundLamps(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.lab = Lab(PROGRAM, pathlib.Path("/usr/bin/povray"), TOOLS, pathlib.Path(folder.name), quick=True)
        self.lab.say = lambda text: None

    def test_lamps_that_are_easily_found_make_the_same_picture(self):
        for scene in (scene for scene in found_lamps.SCENES if scene.name in HAVE_KNOWN):
            with self.subTest(scene.name):
                shot = dataclasses.replace(scene.shots(True)[-1][1], size=SIZE)
                known = found_lamps.Reference(self.lab, shot).of(64)
                hidden = found_lamps.Reference(self.lab, shot)
                hidden.shot = shot
                hidden = hidden.of(512)
                (off,) = self.lab.tool("noise", "errors", known, hidden)
                own = self.lab.tool("noise", "errors", hidden, hidden)[0]["reference_mse"]
                self.assertLess(off["mse"], 3 * own)
                dark = found_lamps.Reference(self.lab, found_lamps.declared(shot, Lamps=0)).of(16)
                (kept,) = self.lab.tool("noise", "lamps", known, dark, hidden)
                self.assertAlmostEqual(kept["kept"], 1.0, delta=0.05)

    def test_scenes_without_them_know_of_none(self):
        for path in found_lamps.FOLDER.glob("*.pov"):
            text = path.read_text()
            self.assertEqual("Known" in text, path.stem in HAVE_KNOWN, path.name)

    def test_each_scene_is_measured(self):
        self.assertEqual(sorted(path.stem for path in found_lamps.FOLDER.glob("*.pov")), sorted(found_lamps.NAMES))
        self.assertTrue(set(suite.DISPLAY).isdisjoint(found_lamps.NAMES))

    def test_rows(self):
        with unittest.mock.patch.object(found_lamps, "QUICK_SIZE", (40, 30)):
            rows = found_lamps.measure(self.lab, ["pigments"])
        small, large = rows
        self.assertEqual((small["radius"], large["radius"]), (0.04, 0.08))
        self.assertTrue(0.8 < large["fixed_kept"] < 1.2 and large["disc_pixels"] > 20, large)
        self.assertLess(large["fixed_dark"], small["fixed_dark"])
        self.assertAlmostEqual(large["fixed"], large["samples"], delta=2.0)
        self.assertEqual(large["fixed"] % 4, 0)
        with unittest.mock.patch.object(found_lamps, "QUICK_SIZE", (40, 30)):
            self.lab.render = lambda *_: self.fail("rendered again")
            self.assertEqual(found_lamps.measure(self.lab, ["pigments"]), rows)

    def test_section(self):
        row = {
            "scene": "textures",
            "radius": 0.04,
            "size": [160, 120],
            "samples": 10.0,
            "fixed": 10.0,
            "mse": 4e-4,
            "fixed_mse": 2e-4,
            "reference_mse": 1e-5,
            "kept": 0.8,
            "fixed_kept": 1.0,
            "dark": 0.2,
            "fixed_dark": 0.0,
            "disc_pixels": 9.0,
            "estimated": 0.01,
            "true": 0.02,
        }
        text = report.section("found_lamps", [row, {**row, "scene": "stars", "radius": None, "disc_pixels": 0.0}])
        for words in (
            "| lamps by a `texture_map`, radius 0.04 | 10.0 | 0.0004 | 2.00 | 80.0 % (100.0 %) | 20.0 % (0.0 %) | 0.50 | 0.05 |",
            "| 300 stars | 10.0 | 0.0004 | 2.00 | 80.0 % (100.0 %) | - |",
            "2.00 at the most (missed)",
            "80.0 % at the least (missed)",
        ):
            self.assertIn(words, text)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])

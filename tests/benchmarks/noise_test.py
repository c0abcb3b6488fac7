# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The tool that measures errors, with pictures whose errors are known: noise_test.py TOOL."""

import json
import pathlib
import struct
import subprocess
import sys
import tempfile
import unittest

TOOL = sys.argv[1]


class Noise(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def grey(self, name, value, size=(16, 8)):
        path = self.folder / f"{name}.pfm"
        width, height = size
        path.write_bytes(f"PF\n{width} {height}\n-1.0\n".encode() + 3*width*height*struct.pack("<f", value))
        return path

    def tool(self, *arguments, fails=False):
        done = subprocess.run([TOOL, *map(str, arguments)], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode != 0, fails, done.stderr)
        return [json.loads(line) for line in done.stdout.splitlines()] if not fails else done.stderr

    def reference(self, *values):
        pictures = [self.grey(f"batch{i}", value) for i, value in enumerate(values)]
        self.tool("reference", self.folder / "reference.exr", *pictures, "--size", 16, 8)
        return self.folder / "reference.exr"

    def test_error_of_a_constant_difference(self):
        line, = self.tool("errors", self.reference(0.5, 0.5), self.grey("a", 0.625))
        self.assertAlmostEqual(line["mse"], 0.125**2, places=7)
        self.assertAlmostEqual(line["mean"], 0.125, places=6)

    def test_the_references_own_error_is_taken_off(self):
        # two pictures that differ by 0.2: the mean has a standard error of 0.1
        line, = self.tool("errors", self.reference(0.4, 0.6), self.grey("a", 0.75))
        self.assertAlmostEqual(line["reference_mse"], 0.01, places=5)
        self.assertAlmostEqual(line["mse"], 0.0625 - 0.01, places=5)

    def test_values_above_white_count_as_white(self):
        line, = self.tool("errors", self.reference(1.5, 1.5), self.grey("a", 3.0))
        self.assertEqual(line["mse"], 0.0)

    def test_share_of_pixels_beyond_a_limit(self):
        line, = self.tool("errors", self.reference(0.5, 0.5), self.grey("a", 0.625), "--limits", "1e-3,1e-2")
        self.assertEqual(line["beyond"], [1.0, 0.0])

    def test_a_border_is_cut_off(self):
        line, = self.tool("errors", self.reference(0.5, 0.5), self.grey("a", 0.5, (32, 24)))
        self.assertEqual(line["mse"], 0.0)
        self.assertIn("16 x 8", self.tool("errors", self.reference(0.5, 0.5), self.grey("b", 0.5, (18, 8)),
                                         fails=True))

    def test_pixels_that_took_more_samples(self):
        """The left half of the picture took 8 samples and is right, the right half took 32 and is off by 0.25."""
        halves = [self.folder / "left.pfm", self.folder / "right.pfm"]
        for path, name, value in zip(halves, ("l", "r"), (0.5, 0.75)):
            self.grey(name, value, (8, 8)).rename(path)
        picture, layers = self.folder / "both.exr", self.folder / "both.layers.exr"
        subprocess.run(["oiiotool", *map(str, halves), "--mosaic", "2x1", "-o", str(picture)], check=True)
        subprocess.run(["oiiotool", "--pattern", "constant:color=8", "8x8", "1", "--pattern", "constant:color=32", "8x8", "1",
                        "--mosaic", "2x1", "--chnames", "samples", "-d", "float", "-o", str(layers)], check=True)
        arguments = ("errors", self.reference(0.5, 0.5), picture, "--layers", layers, "--more-than")
        line, = self.tool(*arguments, 8)
        self.assertAlmostEqual(line["mse_more"], 0.0625, places=6)
        self.assertEqual(line["share_more"], 0.5)
        line, = self.tool(*arguments, 32)
        self.assertEqual((line["mse_more"], line["share_more"]), (0.0, 0.0))
        self.assertIn("no channel samples", self.tool("errors", self.reference(0.5, 0.5), picture, "--layers", picture,
                                                      fails=True))

    def test_means_of_the_first_pictures(self):
        pictures = [self.grey("a", 0.25), self.grey("b", 0.75), self.grey("c", 0.5)]
        lines = self.tool("prefixes", self.reference(0.5, 0.5), *pictures, "--counts", "1,2")
        self.assertEqual([line["count"] for line in lines], [1, 2])
        self.assertAlmostEqual(lines[0]["mse"], 0.0625, places=6)
        self.assertAlmostEqual(lines[1]["mse"], 0.0, places=6)

    def test_lights_are_clipped_after_they_are_averaged(self):
        pictures = [self.grey("a", 0.0), self.grey("b", 1.5)]
        line, = self.tool("prefixes", self.reference(0.5, 0.5), *pictures, "--counts", "2")
        self.assertAlmostEqual(line["mse"], 0.0625, places=6)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])

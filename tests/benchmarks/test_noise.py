# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Measured errors equal the known ones.

usage: test_noise TOOL"""

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
        path.write_bytes(f"PF\n{width} {height}\n-1.0\n".encode() + 3 * width * height * struct.pack("<f", value))
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
        (line,) = self.tool("errors", self.reference(0.5, 0.5), self.grey("a", 0.625))
        self.assertAlmostEqual(line["mse"], 0.125**2, places=7)
        self.assertAlmostEqual(line["mean"], 0.125, places=6)

    def test_the_references_own_error_is_taken_off(self):
        # two pictures that differ by 0.2: their mean has a standard error of 0.1
        (line,) = self.tool("errors", self.reference(0.4, 0.6), self.grey("a", 0.75))
        self.assertAlmostEqual(line["reference_mse"], 0.01, places=5)
        self.assertAlmostEqual(line["mse"], 0.0625 - 0.01, places=5)

    def test_values_above_white_count_as_white(self):
        (line,) = self.tool("errors", self.reference(1.5, 1.5), self.grey("a", 3.0))
        self.assertEqual(line["mse"], 0.0)

    def test_a_border_is_cut_off(self):
        (line,) = self.tool("errors", self.reference(0.5, 0.5), self.grey("a", 0.5, (32, 24)))
        self.assertEqual(line["mse"], 0.0)
        self.assertIn("16 x 8", self.tool("errors", self.reference(0.5, 0.5), self.grey("b", 0.5, (18, 8)), fails=True))

    def test_a_part_is_taken_from_its_place(self):
        halves = [self.grey("l", 0.5, (16, 8)), self.grey("r", 0.625, (16, 8))]
        whole = self.folder / "whole.exr"
        subprocess.run(["oiiotool", *map(str, halves), "--mosaic", "2x1", "-o", str(whole)], check=True)
        for at, mse in (("16,0", 0.125**2), ("0,0", 0.0)):
            (line,) = self.tool("errors", self.reference(0.5, 0.5), whole, "--at", at)
            self.assertAlmostEqual(line["mse"], mse, places=7)
        self.assertIn("from there on", self.tool("errors", self.reference(0.5, 0.5), whole, "--at", "17,0", fails=True))

    def halves(self, name, left, right):
        paths = [self.grey(f"{name}{side}", value, (8, 8)) for side, value in (("l", left), ("r", right))]
        picture = self.folder / f"{name}.exr"
        subprocess.run(["oiiotool", *map(str, paths), "--mosaic", "2x1", "-o", str(picture)], check=True)
        subprocess.run(
            [
                "oiiotool",
                "--pattern",
                "constant:color=8",
                "8x8",
                "1",
                "--pattern",
                "constant:color=32",
                "8x8",
                "1",
                "--mosaic",
                "2x1",
                "--chnames",
                "samples",
                "-d",
                "float",
                "-o",
                str(self.folder / f"{name}.layers.exr"),
            ],
            check=True,
        )
        return picture

    def claims(self, *pictures, more_than=8, reference=(0.5, 0.5)):
        (line,) = self.tool("claims", self.reference(*reference), *pictures, "--variance", 1e-2, "--more-than", more_than)
        return line

    def test_pixels_that_took_more_samples(self):
        pictures = [self.halves("a", 0.5, 0.75), self.halves("b", 0.5, 0.25)]
        line = self.claims(*pictures)
        self.assertAlmostEqual(line["mse"], 0.03125, places=6)
        self.assertAlmostEqual(line["mse_more"], 0.0625, places=6)
        self.assertEqual((line["share_more"], line["beyond"]), (0.5, 0.5))
        self.assertAlmostEqual(line["room"], 0.64, places=6)
        line = self.claims(*pictures, more_than=32)
        self.assertEqual((line["mse_more"], line["share_more"]), (0.0, 0.0))

    def test_true_error_is_relative_above_white(self):
        line = self.claims(self.halves("a", 0.25, 0.75), self.halves("b", 0.75, 0.25))
        self.assertAlmostEqual(line["true"], 0.25, places=6)
        batches = [self.grey(f"bright{i}", 4.0) for i in range(2)]
        bright = self.folder / "bright.exr"
        self.tool("reference", bright, *batches, "--unclipped", "--size", 16, 8)
        pictures = [self.halves("c", 5.0, 4.0), self.halves("d", 4.0, 4.0)]
        (line,) = self.tool("claims", bright, *pictures, "--variance", 1e-2, "--more-than", 8)
        self.assertAlmostEqual(line["true"], 0.125, places=6)
        self.assertEqual(line["mse"], 0.0)

    def test_claims_need_the_layers(self):
        pictures = [self.grey("a", 0.5), self.grey("b", 0.5)]
        self.assertIn(
            "a.layers.exr", self.tool("claims", self.reference(0.5, 0.5), *pictures, "--variance", 1e-2, "--more-than", 8, fails=True)
        )

    def test_means_of_the_first_pictures(self):
        pictures = [self.grey("a", 0.25), self.grey("b", 0.75), self.grey("c", 0.5)]
        lines = self.tool("prefixes", self.reference(0.5, 0.5), *pictures, "--counts", "1,2")
        self.assertEqual([line["count"] for line in lines], [1, 2])
        self.assertAlmostEqual(lines[0]["mse"], 0.0625, places=6)
        self.assertAlmostEqual(lines[1]["mse"], 0.0, places=6)

    def test_lights_are_clipped_after_they_are_averaged(self):
        pictures = [self.grey("a", 0.0), self.grey("b", 1.5)]
        (line,) = self.tool("prefixes", self.reference(0.5, 0.5), *pictures, "--counts", "2")
        self.assertAlmostEqual(line["mse"], 0.0625, places=6)

    def mosaic(self, name, left, right):
        paths = [self.grey(f"{name}{side}", value, (8, 8)) for side, value in (("l", left), ("r", right))]
        picture = self.folder / f"{name}.exr"
        subprocess.run(["oiiotool", *map(str, paths), "--mosaic", "2x1", "-o", str(picture)], check=True)
        return picture

    def unclipped(self, name, *pictures):
        path = self.folder / f"{name}.exr"
        self.tool("reference", path, *pictures, "--unclipped", "--size", 16, 8)
        return path

    def test_light_of_lamps_is_counted_above_white(self):
        lamps, dark = self.mosaic("lamps", 0.25, 3.25), self.grey("dark", 0.25)
        reference, without = self.unclipped("with", lamps, lamps), self.unclipped("without", dark, dark)
        pictures = [lamps, dark, self.mosaic("weak", 0.25, 2.25), self.mosaic("weaker", 0.25, 2.75)]
        lines = self.tool("lamps", reference, without, *pictures)
        self.assertEqual([line["disc_pixels"] for line in lines], [64] * 4)
        for line, kept, share in zip(lines, (1, 0, 2 / 3, 2.5 / 3), (0, 1, 1, 0)):
            self.assertAlmostEqual(line["kept"], kept, places=5)
            self.assertEqual(line["dark"], share)

    def test_what_is_less_than_half_as_bright_as_the_disc_beside_it_is_no_disc(self):
        reference, without = (
            self.unclipped(name, picture, picture)
            for name, picture in (("with", self.mosaic("lamps", 0.2, 0.5)), ("without", self.grey("dark", 0.0)))
        )
        (line,) = self.tool("lamps", reference, without, self.grey("dark", 0.0))
        self.assertEqual((line["disc_pixels"], line["dark"]), (64, 1.0))

    def test_a_scene_needs_lamps(self):
        reference = self.unclipped("with", self.grey("a", 0.5), self.grey("b", 0.5))
        self.assertIn("no brighter", self.tool("lamps", reference, reference, self.grey("a", 0.5), fails=True))
        self.assertIn("size", self.tool("lamps", reference, reference, self.grey("c", 0.5, (8, 8)), fails=True))

    def test_white_of_an_unclipped_reference_has_no_error(self):
        reference = self.unclipped("with", self.grey("a", 2.0), self.grey("b", 4.0))
        (line,) = self.tool("errors", reference, self.grey("c", 5.0))
        self.assertEqual((line["mse"], line["reference_mse"]), (0.0, 0.0))

    def test_groups_of_pixels(self):
        lines = self.tool("groups", self.reference(0.5, 0.5), self.mosaic("a", 0.5, 0.75), self.grey("b", 0.75), "--side", 8)
        for line, wanted in zip(lines, ([0.0, 12.0], [12.0, 12.0])):
            self.assertEqual([round(square, 5) for square in line["squares"]], wanted)
        (line,) = self.tool("groups", self.reference(0.4, 0.6), self.grey("c", 0.75), "--side", 10)
        for square, pixels in zip(line["squares"], (80, 48)):
            self.assertAlmostEqual(square, 3 * pixels * (0.0625 - 0.01), places=2)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])

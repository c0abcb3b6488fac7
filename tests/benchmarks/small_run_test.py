# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The benchmark in very small: small_run_test.py PROGRAM TOOLS. It says nothing about time, but that all ways
to a blurred picture are ways to the same picture, and that what is measured arrives in tables and plots."""

import copy
import dataclasses
import math
import pathlib
import sys
import tempfile
import unittest

from benchmarks import (
    accumulation,
    camera_share,
    contract,
    instructions,
    pan_focus,
    plots,
    post,
    reconstruction,
    report,
    suite,
    tilted,
    versus_stock,
)
from benchmarks.lab import TILT_LENS, Lab

PROGRAM, TOOLS = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
SIZE = (40, 30)
SCENE = dataclasses.replace(suite.SCENES[0], reference=(2, 512), frames=64, size=SIZE)


class SmallRun(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.lab = Lab(PROGRAM, pathlib.Path("/usr/bin/povray"), TOOLS, pathlib.Path(cls.folder.name), quick=True)
        cls.lab.say = lambda text: None
        suite.TARGETS = (37, 100)
        suite.STOCK_ADAPTIVE = suite.STOCK_ADAPTIVE[:1]
        suite.OURS["quick"] = [(8, (1e-2, 1e-3, 1e-4))]
        cls.records = versus_stock.measure(cls.lab, SCENE)
        cls.lines = versus_stock.compare(cls.records)

    def test_tilt_lens_and_stock_approach_the_same_picture(self):
        stock = {record["setting"]: record["rmse"] for record in self.records if record["program"] == "stock"}
        self.assertLess(stock["100"], 0.75*stock["37"])
        self.assertLess(stock["100"], 0.03)
        # the chain of settings ends with the first that is better than stock's errors: ask for a finer one
        reference = self.lab.reference(SCENE.shot(TILT_LENS), *SCENE.reference)
        fine = self.lab.run(self.lab.ours, SCENE.shot(TILT_LENS, declare=suite.limits(8, 16384, 1e-4)), reference)
        self.assertLess(math.sqrt(fine["mse"]), 0.01)

    def test_every_target_has_a_ratio(self):
        self.assertEqual([line["target"] for line in self.lines], [37, 100])
        for line in self.lines:
            self.assertGreater(line["ratio"], 0)

    def apart(self):
        """Mean square difference of the tilted and the untilted picture."""
        untilted = self.lab.reference(SCENE.shot(TILT_LENS), *SCENE.reference)
        shot = SCENE.shot(TILT_LENS, 1, declare=suite.limits(256, 256, 0))
        return self.lab.run(self.lab.ours, shot, untilted)["mse"]

    def test_accumulation_buffer_approaches_its_own_picture(self):
        mistaken = copy.copy(self.lab)      # takes the untilted picture for the tilted one, and the reverse
        mistaken.reference = lambda shot, *settings: self.lab.reference(
            dataclasses.replace(shot, tilted=1 - shot.tilted), *settings)
        for tilt in (0, 1):
            records = accumulation.measure(self.lab, SCENE, tilt)
            self.assertEqual([record["setting"] for record in records], ["8", "16", "32", "64"])
            self.assertLess(records[-1]["rmse"], 0.5*records[0]["rmse"], f"tilted {tilt}")
            wrong = accumulation.measure(mistaken, SCENE, tilt)
            self.assertGreater(wrong[-1]["mse"] - records[-1]["mse"], 0.25*self.apart(), f"tilted {tilt}")

    def test_blur_after_the_fact_resembles_the_picture(self):
        for tilt in (0, 1):
            record, = post.measure(self.lab, SCENE, tilt)
            self.assertLess(record["rmse"], 0.08, f"tilted {tilt}")

    def test_reconstruction_brings_a_ratio_and_a_small_bias(self):
        # rays instead of callgrind's instructions, which take long
        rows = reconstruction.measure(self.lab, SCENE, lambda lab, program, shot: lab.run(program, shot).get("samples", 0))
        self.assertEqual(len(rows), 2*len(reconstruction.VARIANCES[:3]))
        self.assertTrue(all(0.5 < ratio < 3.0 for ratio in reconstruction.compare(rows).values()), rows)
        for row in rows:
            self.assertLess(row["bias"], (0.7 if row["denoise"] else 0.3)*row["rmse"], row)
        self.assertIn("in each scene at each setting: at least 1", report.section("denoise", rows))

    def test_share_of_camera_and_sampler(self):
        rows = camera_share.measure(self.lab, lambda *_, within: 1000 if within == camera_share.ALL else 750)
        self.assertEqual([row["share"] for row in rows], [0.25])
        self.assertIn("25.0 % at the most (missed)", report.section("camera", rows))

    def test_inner_loops_are_timed(self):
        loops = instructions.inner_loops(self.lab)
        self.assertEqual(len(loops), len({name for name, _ in loops}))
        self.assertTrue(all(math.isfinite(ns) for _, ns in loops), loops)  # how long they take is not for a test

    def test_what_was_measured_is_not_measured_again(self):
        again = Lab(self.lab.ours, self.lab.stock, self.lab.tools, self.lab.work, quick=True)
        again.say = lambda text: None
        again.render = lambda *_: self.fail("rendered again")
        self.assertEqual(versus_stock.measure(again, SCENE), self.records)

    def test_tables_and_plots(self):
        errors = {line["target"]: line["rmse"] for line in self.lines}
        records = tilted.measure(self.lab, SCENE, errors)
        results = {"stock": {"checks": self.lines},
                   "tilted": {"checks": tilted.compare(records, errors)},
                   "pan": pan_focus.compare(pan_focus.measure(self.lab, SCENE)),
                   "contract": contract.measure(self.lab, dataclasses.replace(SCENE, reference=(2, 128)), 0)}
        text = report.text(results) + report.overview(results) + report.goals(results)
        for words in ("error of stock with 100 samples", "geometric mean: at least 8", "at most 1.3. Measured", "MSE/V",
                      "| all |", "| figure | goal |"):
            self.assertIn(words, text)
        plots.errors(self.lab.work / "plot.svg", "checks", self.records)
        self.assertIn("tilt_lens", (self.lab.work / "plot.svg").read_text())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""In miniature, all methods of blur approach the same picture.

usage: test_small_run PROGRAM TOOLS"""

import copy
import dataclasses
import math
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest
import unittest.mock

from benchmarks import (
    accumulation,
    camera_share,
    comparison,
    contract,
    cycles,
    gallery,
    glass_cost,
    instructions,
    pan_focus,
    plots,
    post,
    reconstruction,
    report,
    sample_cost,
    speedups,
    suite,
    tilted,
    versus_stock,
)
from benchmarks.lab import STOCK, TILT_LENS, Failed, Lab, Part

PROGRAM, TOOLS = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
SIZE = (40, 30)
SCENE = dataclasses.replace(suite.SCENES[0], reference=(2, 512), frames=64, size=SIZE, targets=(37, 100))
LARGE = Part(80, 60, 200, 150)


class SmallRun(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.lab = Lab(PROGRAM, pathlib.Path("/usr/bin/povray"), TOOLS, pathlib.Path(cls.folder.name), quick=True)
        cls.lab.say = lambda text: None
        suite.STOCK_ADAPTIVE = suite.STOCK_ADAPTIVE[:1]
        suite.OURS["quick"] = [(8, (1e-2, 1e-3, 1e-4))]
        cls.records = versus_stock.measure(cls.lab, SCENE)
        cls.lines = versus_stock.compare(SCENE, cls.records)

    def test_tilt_lens_and_stock_approach_the_same_picture(self):
        stock = {record["setting"]: record["rmse"] for record in self.records if record["program"] == "stock"}
        self.assertLess(stock["100"], 0.75 * stock["37"])
        self.assertLess(stock["100"], 0.03)
        reference = self.lab.reference(SCENE.shot(TILT_LENS), *SCENE.reference)
        fine = self.lab.run(self.lab.ours, SCENE.shot(TILT_LENS, declare=suite.limits(8, 16384, 1e-4)), reference)
        self.assertLess(math.sqrt(fine["mse"]), 0.01)

    def test_reference_is_finer_than_the_errors(self):
        rough = dataclasses.replace(SCENE, reference=(2, 32))
        fine = versus_stock.with_fine_reference(self.lab, rough)
        self.assertGreater(fine.reference[1], rough.reference[1])
        reference = self.lab.reference(SCENE.shot(TILT_LENS), *fine.reference)
        record = self.lab.run(self.lab.stock, SCENE.shot(STOCK, declare=suite.limits(100, 100, 0)), reference)
        self.assertLess(record["reference_mse"], 0.15 * record["mse"])

    def test_every_target_has_a_ratio(self):
        self.assertEqual([line["target"] for line in self.lines], [37, 100])
        for line in self.lines:
            self.assertGreater(line["ratio"], 0)

    def apart(self):
        untilted = self.lab.reference(SCENE.shot(TILT_LENS), *SCENE.reference)
        shot = SCENE.shot(TILT_LENS, 1, declare=suite.limits(256, 256, 0))
        return self.lab.run(self.lab.ours, shot, untilted)["mse"]

    def test_accumulation_buffer_approaches_its_own_picture(self):
        mistaken = copy.copy(self.lab)  # takes the untilted picture for the tilted one, and the reverse
        mistaken.reference = lambda shot, *settings: self.lab.reference(dataclasses.replace(shot, tilted=1 - shot.tilted), *settings)
        for tilt in (0, 1):
            records = accumulation.measure(self.lab, SCENE, tilt)
            self.assertEqual([record["setting"] for record in records], ["8", "16", "32", "64"])
            self.assertLess(records[-1]["rmse"], 0.5 * records[0]["rmse"], f"tilted {tilt}")
            wrong = accumulation.measure(mistaken, SCENE, tilt)
            self.assertGreater(wrong[-1]["mse"] - records[-1]["mse"], 0.25 * self.apart(), f"tilted {tilt}")

    def test_part_equals_the_part_of_the_whole(self):
        scene = dataclasses.replace(SCENE, part=LARGE)
        whole = self.lab.reference(dataclasses.replace(scene.shot(TILT_LENS), size=(200, 150), part=None), 2, 256)
        cut = whole.with_name("cut.exr")
        subprocess.run(
            ["oiiotool", str(whole), "--cut", "{2}x{3}+{0}+{1}".format(LARGE.left, LARGE.top, *SIZE), "-o", str(cut)], check=True
        )
        many = suite.limits(256, 256, 0)
        for binary, form in ((self.lab.ours, TILT_LENS), (self.lab.stock, STOCK)):
            record = self.lab.run(binary, scene.shot(form, declare=many), cut)
            self.assertLess(record["mse"], 5e-4, form)
            self.assertGreater(record["rays"], 0.0)
        wrong = dataclasses.replace(LARGE, left=LARGE.left + 3)
        moved = self.lab.run(self.lab.ours, dataclasses.replace(scene, part=wrong).shot(TILT_LENS, declare=many), cut)
        self.assertGreater(moved["mse"], 1e-2)

    def test_gallery_at_viewing_size(self):
        folder = gallery.copy(self.lab, "city_lights")
        scene = dataclasses.replace(
            suite.of_gallery("city_lights", folder), reference=(2, 128), size=(24, 16), targets=(16, 37), quick_frames=32
        )
        found, runs = comparison.compare(self.lab, [scene])
        for name in ("untilted", "tilted"):
            lines = found[name]["city_lights"]
            self.assertEqual([line["target"] for line in lines], [16, 37])
            self.assertTrue(all(line["tilt_lens"] for line in lines), lines)
            self.assertLess(lines[1]["rmse"], 0.9 * lines[0]["rmse"])
        self.assertEqual({run["program"] for run in runs}, {"stock", "tilt_lens", "accumulation"})
        results = {"display": {"part": [24, 16, 1280, 720], **found}, "lamps": {"untilted": {"dim": self.lines}, "tilted": {}}}
        for words in ("city lights", "24 by 16 pixels", "in large pictures", "not brighter than white"):
            self.assertIn(words, report.text(results) + report.goals(results))

    def test_cycles_is_compared_at_its_own_errors(self):
        lines = cycles.compare(
            [{"setting": "16", "cpu": 4.0, "rmse": 0.02}, {"setting": "8,64 0.1", "cpu": 2.0, "rmse": 0.02}], [{"cpu": 0.5, "rmse": 0.02}]
        )
        self.assertEqual([(line["target"], line["ratio"]) for line in lines], [(16, 4.0)])
        self.assertIn("| 16 | 0.0200 | 2.00 | 0.50 | 4.0 |", report.section("cycles", {"version": "Blender 0", "lines": lines}))

    def test_cycles_is_skipped_without_blender(self):
        said = []
        lab = copy.copy(self.lab)
        lab.say = said.append
        with unittest.mock.patch.object(cycles, "installed", lambda: None):
            self.assertIsNone(cycles.measure(lab))
        self.assertIn("Blender is not installed", said[0])

    def test_blur_after_the_fact_resembles_the_picture(self):
        for tilt in (0, 1):
            (record,) = post.measure(self.lab, SCENE, tilt)
            self.assertLess(record["rmse"], 0.08, f"tilted {tilt}")

    def test_reconstruction_brings_a_ratio_and_a_small_bias(self):
        # counts rays, because callgrind takes long
        rows = reconstruction.measure(self.lab, SCENE, lambda lab, program, shot: lab.run(program, shot).get("samples", 0))
        self.assertEqual(len(rows), 2 * len(reconstruction.VARIANCES[:3]))
        self.assertTrue(all(0.5 < ratio < 3.0 for ratio in reconstruction.compare(rows).values()), rows)
        for row in rows:
            self.assertLess(row["bias"], (0.7 if row["denoise"] else 0.3) * row["rmse"], row)
        self.assertIn("in each scene at each setting: at least 1", report.section("denoise", rows))

    def test_share_of_camera_and_sampler(self):
        rows = camera_share.measure(self.lab, lambda *_, within: 1000 if within == camera_share.ALL else 750)
        self.assertEqual([row["share"] for row in rows], [0.25])
        self.assertIn("25.0 % at the most (missed)", report.section("camera", rows))

    def test_cost_of_glass(self):
        rows = glass_cost.measure(
            self.lab, lambda _, __, shot, within: 1000 * (1 + (("Glass", 8) in shot.declare)) if within == glass_cost.ALL else 750
        )
        self.assertEqual([row["share"] for row in rows], [0.25, 0.25, 0.625])
        self.assertIn("5.0 times at the most (missed)", report.section("glass", rows))

    def test_cost_of_a_sample(self):
        counts = {sample_cost.ALL: 800, sample_cost.INTERSECTIONS: 200}
        for before, words in ((None, "| 25 % | - | - |"), ("before", "0.50 (reached)"), ("before", "0.75 (missed)")):
            rows = sample_cost.measure(
                self.lab,
                before,
                lambda lab, program, shot, within: (1600 if program == "before" else counts[within])
                * sample_cost.SAMPLES
                * math.prod(shot.size),
                lambda *_: 0.75,
            )
            self.assertEqual({row["instructions"] for row in rows}, {800})
            self.assertIn(words, report.section("samples", rows))

    def test_a_program_of_before_may_be_another_one(self):
        before = pathlib.Path(shutil.copy(PROGRAM, self.lab.work / "before"))
        with unittest.mock.patch.object(sample_cost, "TIMED_SIZE", (160, 120)):
            ratio = sample_cost.seconds_over_before(self.lab, SCENE.shot(TILT_LENS), before)
        self.assertTrue(ratio > 0.0, ratio)

    def test_worth_of_the_speedups(self):
        rows = speedups.measure(self.lab, "without", lambda lab, program, shot: 3e9 if program == "without" else 2e9, lambda *_: 1.6)
        self.assertEqual([row["scene"] for row in rows], list(speedups.QUICK))
        self.assertIn("| 3.00 | 2.00 | 1.50 | 1.60 |", report.section("speedups", rows))

    def test_speedups_are_compared_with_the_same_picture(self):
        other = pathlib.Path(shutil.copy(PROGRAM, self.lab.work / "without"))
        with unittest.mock.patch.object(speedups, "PAIRS", 1):
            self.assertTrue(speedups.cpu_ratio(self.lab, SCENE.shot(TILT_LENS), other) > 0.0)
            same = self.lab.run
            changed = lambda program, *rest, **named: {**same(program, *rest, **named), "samples": 1.0 + (program == other)}
            with unittest.mock.patch.object(self.lab, "run", changed), self.assertRaises(Failed):
                speedups.cpu_ratio(self.lab, SCENE.shot(TILT_LENS), other)

    def test_inner_loops_are_timed(self):
        loops = instructions.inner_loops(self.lab)
        self.assertEqual(len(loops), len({name for name, _ in loops}))
        self.assertTrue(all(math.isfinite(ns) for _, ns in loops), loops)

    def test_what_was_measured_is_not_measured_again(self):
        again = Lab(self.lab.ours, self.lab.stock, self.lab.tools, self.lab.work, quick=True)
        again.say = lambda text: None
        again.render = lambda *_: self.fail("rendered again")
        self.assertEqual(versus_stock.measure(again, SCENE), self.records)

    def test_tables_and_plots(self):
        errors = {line["target"]: line["rmse"] for line in self.lines}
        records = tilted.measure(self.lab, SCENE, errors)
        results = {
            "stock": {"checks": self.lines},
            "tilted": {"checks": tilted.compare(records, errors)},
            "pan": pan_focus.compare(pan_focus.measure(self.lab, SCENE)),
            "contract": contract.measure(self.lab, dataclasses.replace(SCENE, reference=(2, 128)), 0),
            "crops": contract.measure(self.lab, dataclasses.replace(SCENE, reference=(2, 128)), 1, contract.CROP),
        }
        self.assertTrue(all(0.3 < row["estimated"] / row["true"] < 3.0 for row in results["contract"]), results["contract"])
        text = report.text(results) + report.overview(results) + report.goals(results)
        for words in (
            "error of stock with 100 samples",
            "geometric mean: at least 8",
            "at most 1.3. Measured",
            "MSE/V",
            "parts of large pictures",
            "0.8 to 1.2 times the true one",
            "| all |",
            "| figure | goal |",
        ):
            self.assertIn(words, text)
        plots.errors(self.lab.work / "plot.svg", "checks", self.records)
        self.assertIn("tilt_lens", (self.lab.work / "plot.svg").read_text())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])

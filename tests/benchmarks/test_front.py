# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The arithmetic of the benchmark's ratios."""

import unittest

from benchmarks import suite, versus_stock
from benchmarks.front import error_after, geometric_mean, pareto, seconds_for


class Front(unittest.TestCase):
    POINTS = [(1.0, 0.1), (100.0, 0.01), (2.0, 0.2), (50.0, 0.05)]

    def test_dominated_settings_do_not_count(self):
        self.assertEqual(pareto(self.POINTS), [(1.0, 0.1), (50.0, 0.05), (100.0, 0.01)])
        self.assertEqual(pareto([(1.0, 0.1), (1.0, 0.05)]), [(1.0, 0.05)])

    def test_between_settings_time_follows_a_power_of_the_error(self):
        points = [(1.0, 0.1), (100.0, 0.01)]
        self.assertAlmostEqual(seconds_for(points, 0.1), 1.0)
        self.assertAlmostEqual(seconds_for(points, 0.01), 100.0)
        self.assertAlmostEqual(seconds_for(points, 10**-1.5), 10.0)

    def test_fastest_setting_keeps_its_own_time(self):
        self.assertEqual(seconds_for(self.POINTS, 0.5), 1.0)

    def test_unreached_error_has_no_time(self):
        self.assertIsNone(seconds_for(self.POINTS, 0.009))
        self.assertIsNone(seconds_for([], 0.1))

    def test_error_after_some_time_is_the_inverse(self):
        for seconds in (1.0, 7.0, 50.0, 99.0, 100.0):
            self.assertAlmostEqual(seconds_for(self.POINTS, error_after(self.POINTS, seconds)), seconds)

    def test_outside_the_settings_nothing_is_made_up(self):
        self.assertIsNone(error_after(self.POINTS, 0.9))
        self.assertIsNone(error_after([], 1.0))
        self.assertEqual(error_after(self.POINTS, 1000.0), 0.01)

    def test_geometric_mean(self):
        self.assertAlmostEqual(geometric_mean([1.0, 100.0]), 10.0)
        self.assertIsNone(geometric_mean([]))


class Comparison(unittest.TestCase):
    @staticmethod
    def record(program, setting, cpu, rmse):
        return {"program": program, "setting": setting, "cpu": cpu, "rmse": rmse, "mse": rmse**2, "reference_mse": 1e-5}

    def test_stock_is_taken_at_its_best_setting_for_the_error(self):
        records = [
            self.record("stock", "100", 10.0, 0.02),
            self.record("stock", "64,1600 0.001 0.9", 4.0, 0.02),
            self.record("tilt_lens", "8 0.001", 2.0, 0.02),
        ]
        (line,) = versus_stock.compare(suite.SCENES[0], records)
        self.assertEqual((line["target"], line["rmse"], line["ratio"]), (100, 0.02, 2.0))
        self.assertAlmostEqual(line["noise"], 0.025)

    def test_error_unreached_by_tilt_lens_has_no_ratio(self):
        records = [self.record("stock", "100", 10.0, 0.02), self.record("tilt_lens", "8 0.001", 2.0, 0.03)]
        self.assertIsNone(versus_stock.compare(suite.SCENES[0], records)[0]["ratio"])


if __name__ == "__main__":
    unittest.main()

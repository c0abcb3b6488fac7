# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The ablation's arithmetic; its rules and programs know the numbers of settings.h."""

import re
import unittest

from benchmarks import ablation
from tools.repository import ROOT


def curve(constant, samples=(8, 16, 64)):
    """Independent samples: an error of constant/samples."""
    return [{"mse": constant/n, "samples": n, "variance": 1e-3, "beyond": 0.0} for n in samples]


class Ratios(unittest.TestCase):
    def test_are_1_for_the_same_curve(self):
        self.assertAlmostEqual(ablation.ratio(curve(0.1), curve(0.1)), 1.0)
        self.assertAlmostEqual(ablation.ratio(curve(0.1), curve(0.1, (4, 30, 500))), 1.0)

    def test_are_the_work_for_the_same_error(self):
        self.assertAlmostEqual(ablation.ratio(curve(0.1), curve(0.3)), 3.0)
        self.assertAlmostEqual(ablation.ratio(curve(0.3), curve(0.1)), 1/3)

    def test_leave_errors_of_zero_out(self):
        self.assertEqual(ablation.ratio(curve(0.1), curve(0.0)), 1.0)

    def test_contract_is_the_worst_pictures(self):
        records = [{"mse": 1e-3, "variance": 1e-3, "beyond": 0.01}, {"mse": 6e-3, "variance": 2e-3, "beyond": 0.0},
                   {"mse": 1.0, "variance": ablation.LEAST_KEPT/2, "beyond": 1.0}]
        self.assertEqual(ablation.kept(records), (6e-3/2e-3, 0.01))


class Rules(unittest.TestCase):
    def test_name_numbers_of_the_header(self):
        header = ablation.settings_of_header((ROOT / "povray-src/tilt_lens/settings.h").read_text())
        program = re.findall(r"FIELD\((\w+)\)[,}]", (ROOT / "benchmarks/tools/variable_settings.cpp").read_text())
        self.assertEqual(sorted(header), sorted(program))
        for rule, _, settings in ablation.RULES + ablation.EMITTER_RULES:
            for item in settings.split(","):
                self.assertIn(item.split("=")[0], header, rule)

    def test_every_number_is_varied_or_has_its_reason_in_the_docs(self):
        header = (ROOT / "povray-src/tilt_lens/settings.h").read_text()
        varied = {item.split("=")[0] for _, _, settings in ablation.RULES + ablation.EMITTER_RULES for item in settings.split(",")}
        constants = {name for line in re.findall(r"static constexpr [\w:]+ (.*);", header) for name in re.findall(r"(\w+) = ", line)}
        page = (ROOT / "docs/sampling.md").read_text()
        reasons = page[page.index("### Numbers that are not varied"):]
        told = {name for line in reasons.splitlines() if line.startswith("| `") for name in re.findall(r"`(\w+)`", line.split("|")[1])}
        wanted = {*ablation.settings_of_header(header), *constants} - varied - {"neighbourhoodPixels"}
        self.assertEqual(told, wanted)

    def test_are_told_apart_by_their_settings(self):
        settings = [settings for _, _, settings in ablation.RULES + ablation.EMITTER_RULES]
        self.assertEqual(len(settings), len(set(settings)))


if __name__ == "__main__":
    unittest.main()

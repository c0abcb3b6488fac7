# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The ablation's arithmetic and numbers of settings.h."""

import re
import unittest

from benchmarks import ablation, report
from tools.repository import ROOT


def curve(constant, samples=(8, 16, 64)):
    return [{"mse": constant / n, "samples": n, "variance": 1e-3, "beyond": 0.0} for n in samples]


class Ratios(unittest.TestCase):
    def test_are_1_for_the_same_curve(self):
        self.assertAlmostEqual(ablation.ratio(curve(0.1), curve(0.1)), 1.0)
        self.assertAlmostEqual(ablation.ratio(curve(0.1), curve(0.1, (4, 30, 500))), 1.0)

    def test_are_the_work_for_the_same_error(self):
        self.assertAlmostEqual(ablation.ratio(curve(0.1), curve(0.3)), 3.0)
        self.assertAlmostEqual(ablation.ratio(curve(0.3), curve(0.1)), 1 / 3)

    def test_leave_errors_of_zero_out(self):
        self.assertEqual(ablation.ratio(curve(0.1), curve(0.0)), 1.0)

    def test_contract_is_the_worst_pictures(self):
        records = [
            {"mse": 1e-3, "variance": 1e-3, "beyond": 0.01},
            {"mse": 6e-3, "variance": 2e-3, "beyond": 0.0},
            {"mse": 1.0, "variance": ablation.LEAST_KEPT / 2, "beyond": 1.0},
        ]
        self.assertEqual(ablation.kept(records), (6e-3 / 2e-3, 0.01))


class Summary(unittest.TestCase):
    ROWS = [
        {"scene": "town", "part": False, "denoise": False, "ratio": 2.0, "error": 0.3, "beyond": 0.01},
        {"scene": "town", "part": False, "denoise": True, "ratio": 9.0, "error": 0.2, "beyond": 0.02},
        {"scene": "night", "part": False, "denoise": False, "ratio": 8.0, "error": None, "beyond": None},
        {"scene": "night", "part": False, "denoise": True, "ratio": 1.0, "error": None, "beyond": None},
        {"scene": "town, part", "part": True, "denoise": True, "ratio": 5.0, "error": None, "beyond": None},
    ]

    def test_has_means_and_the_worst_scenes(self):
        made = ablation.summary(("a rule", 8, "number=0"), self.ROWS)
        self.assertEqual([round(mean, 9) for mean in made["means"]], [4.0, 3.0, 5.0])
        self.assertEqual((made["ratio"], made["error"], made["beyond"]), ((9.0, "town"), (0.3, "town"), (0.02, "town")))

    def test_is_a_line_of_the_page(self):
        made = {"size": [96, 64], "samples": 1024, "rules": [ablation.summary(("a rule", 8, "number=0"), self.ROWS)]}
        text = report.section("ablation", made)
        self.assertIn("| a rule | 8 | `number=0` | 4.00 | 3.00 | 5.00 | 9.00 town | 0.3 town | 2 % town |", text)
        self.assertIn("Pictures of 96 by 64, and parts of 64 by 48", text)


class Rules(unittest.TestCase):
    def test_name_numbers_of_the_header(self):
        header = ablation.settings_of_header((ROOT / "povray-src/tilt_lens/settings.h").read_text())
        program = re.findall(r"FIELD\((\w+)\)[,}]", (ROOT / "benchmarks/tools/named_settings.cpp").read_text())
        self.assertEqual(sorted(header), sorted(program))
        for rule, _, settings in ablation.RULES + ablation.EMITTER_RULES:
            for item in settings.split(","):
                self.assertIn(item.split("=")[0], header, rule)

    def test_every_number_is_varied_or_has_its_reason_in_the_docs(self):
        header = (ROOT / "povray-src/tilt_lens/settings.h").read_text()
        varied = {item.split("=")[0] for _, _, settings in ablation.RULES + ablation.EMITTER_RULES for item in settings.split(",")}
        constants = {name for line in re.findall(r"static constexpr [\w:]+ (.*);", header) for name in re.findall(r"(\w+) = ", line)}
        page = (ROOT / "docs/sampling.md").read_text()
        reasons = page[page.index("### Numbers that are not varied") :]
        told = {name for line in reasons.splitlines() if line.startswith("| `") for name in re.findall(r"`(\w+)`", line.split("|")[1])}
        wanted = {*ablation.settings_of_header(header), *constants} - varied - {"neighbourhoodPixels"}
        self.assertEqual(told, wanted)

    def test_are_told_apart_by_their_settings(self):
        settings = [settings for _, _, settings in ablation.RULES + ablation.EMITTER_RULES]
        self.assertEqual(len(settings), len(set(settings)))


if __name__ == "__main__":
    unittest.main()

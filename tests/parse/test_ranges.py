# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Numbers are taken up to the ends of their range."""

import argparse
import math
import subprocess
import sys
import unittest

from tests.parse import items
from tests.waiting import PATIENCE

SETTINGS = argparse.Namespace(parser=None)


def written(value):
    return f"{value:.17g}" if math.isfinite(value) else "1e999"


def allowed(number):
    return number.most if math.isfinite(number.most) else max(1.0, number.least)


def answers(blocks):
    done = subprocess.run(
        [SETTINGS.parser], input="".join(block + "\0" for block in blocks), capture_output=True, text=True, timeout=PATIENCE, check=True
    )
    return done.stdout.splitlines()


class Ranges(unittest.TestCase):
    def setUp(self):
        self.items = items.items(SETTINGS.parser)

    def check(self, values_of, judge):
        tried = [
            (item, number, value, ", ".join([*(written(allowed(n)) for n in item.numbers[:place]), value]))
            for item in self.items
            for place, number in enumerate(item.numbers)
            for value in values_of(number)
        ]
        self.assertGreater(len(tried), 20)
        blocks = [f"{item.word} {values}" for item, _, _, values in tried]
        said = answers(blocks)
        self.assertEqual(len(said), len(blocks))
        for (_, number, value, _), block, answer in zip(tried, blocks, said):
            with self.subTest(block=block, answer=answer):
                judge(number, value, answer)

    def test_ends_are_taken(self):
        def judge(number, value, answer):
            del value
            self.assertNotIn(f"{number.name} ", answer.split("in tilt_lens.")[0] if "in tilt_lens." in answer else "")

        self.check(lambda number: [written(end) for end in (number.least, number.most) if math.isfinite(end)], judge)

    def test_numbers_beyond_are_refused(self):
        def beyond(number):
            step = (lambda end, way: end + math.copysign(1, way)) if number.whole else math.nextafter
            ends = [(number.least, -math.inf), (number.most, math.inf)]
            fraction = [written(number.least + 0.5)] if number.whole else []
            return fraction + [written(step(end, way)) for end, way in ends if math.isfinite(end)]

        def judge(number, value, answer):
            self.assertRegex(answer, rf"^error Parse Error: {number.name} \S+ in tilt_lens\. ", value)
            self.assertIn(number.range(), answer)

        self.check(beyond, judge)

    def test_other_values_are_refused(self):
        cases = {
            "1e999": " inf in tilt_lens. It must be a finite number",
            "1e999 - 1e999": "nan in tilt_lens. It must be a finite number",
            "<1, 2>": " in tilt_lens: found a value of 2 numbers. It takes one number",
            "}": " in tilt_lens has no value: found '}'",
            "Unknown": " in tilt_lens has no value: found the undeclared 'Unknown'",
        }

        def judge(number, value, answer):
            self.assertIn(cases[value], answer)
            self.assertTrue(answer.startswith(f"error Parse Error: {number.name} "))

        self.check(lambda number: cases, judge)

    def test_examples(self):
        examples = [item.example.replace("frame_number", "1") for item in self.items]  # these scenes have no frames
        for item, answer in zip(self.items, answers(examples)):
            with self.subTest(example=item.example, answer=answer):
                self.assertTrue(item.example.startswith(item.word))
                for fault in ("has no value", "has no file", "has no colour", "It must be", "It takes a"):
                    self.assertNotIn(fault, answer.replace(f"{item.word} in tilt_lens: found 'Ball'", ""))


def main():
    parser = argparse.ArgumentParser(add_help=False)
    parser.add_argument("--parser", required=True)
    _, rest = parser.parse_known_args(namespace=SETTINGS)
    unittest.main(argv=[sys.argv[0], *rest])


if __name__ == "__main__":
    main()

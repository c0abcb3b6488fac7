# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The parser's table of items, printed by `parse_blocks`."""

import dataclasses
import json
import math
import subprocess

from tests.waiting import PATIENCE


@dataclasses.dataclass
class Number:
    name: str
    least: float
    most: float
    whole: bool

    def range(self):
        """As pages state it; None for any finite number."""
        if math.isfinite(self.least) and math.isfinite(self.most):
            return f"{self.least:.10g} to {self.most:.10g}"
        return "larger than 0" if self.least > 0 else None


@dataclasses.dataclass
class Item:
    word: str
    values: str  # placeholders, as in the manual
    example: str  # the word with values
    numbers: list


def items(parse_blocks):
    told = subprocess.run([parse_blocks, "--items"], capture_output=True, timeout=PATIENCE, check=True).stdout
    return [
        Item(
            entry["word"],
            entry["values"],
            entry["example"],
            [
                Number(
                    number["name"],
                    -math.inf if number["least"] is None else number["least"],
                    math.inf if number["most"] is None else number["most"],
                    number["whole"],
                )
                for number in entry["numbers"]
            ],
        )
        for entry in json.loads(told)
    ]

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later

import dataclasses
import itertools
import json
import math

from experiments.laboratory import Claim

# by chance, the pixel's own variance, 1/12, is included: against d^2/16, d^2 is uncertain by 16/12 square pixels
GRID = 16 / 12


def beyond_grid(diameter):
    return math.sqrt(max(0.0, diameter * diameter - GRID))


@dataclasses.dataclass
class Region:
    """Edges along the world's axes."""

    name: str
    low: tuple
    high: tuple

    def corners(self):
        return list(itertools.product(*zip(self.low, self.high)))

    def window(self, lens):
        pixels = [lens.pixel(p) for p in self.corners()]
        left, right = (f(p[0] for p in pixels) for f in (min, max))
        top, bottom = (f(p[1] for p in pixels) for f in (min, max))
        left, top = max(0, math.floor(left)), max(0, math.floor(top))
        return [left, top, min(lens.view.width, math.ceil(right)) - left, min(lens.view.height, math.ceil(bottom)) - top]

    def diameters(self, lens):
        found = [(lens.blur_diameter(p), lens.vergence(p)) for p in self.corners()]
        sizes = [size for size, _ in found]
        crosses = min(v for _, v in found) <= 0 <= max(v for _, v in found)
        return 0.0 if crosses else min(sizes), max(sizes)


def measure(lab, sharp, blurred, windows, widest):
    found = lab.json([lab.tool("profile"), "blur", sharp, blurred, "--widest", widest], stdin=json.dumps(windows))
    return [entry["diameter"] for entry in found]


def regions(lab, sharp, blurred, lens, places):
    spans = [place.diameters(lens) for place in places]
    widest = 1.5 * max(high for _, high in spans) + 4
    found = measure(lab, sharp, blurred, [place.window(lens) for place in places], widest)
    claims = []
    for place, (low, high), diameter in zip(places, spans, found):
        claims.append(
            Claim(
                f"{place.name}: blur, closed form {low:.1f} to {high:.1f}",
                diameter,
                math.sqrt(high * high + GRID),
                "pixels",
                beyond_grid(low),
            )
        )
    return dict(zip((place.name for place in places), found)), claims

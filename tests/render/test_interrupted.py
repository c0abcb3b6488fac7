# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Interrupted renders continue with +C to the same pixels."""

import pathlib
import re
import signal
import tempfile

from tests.render import rendering, scenes

SLOW = scenes.camera(samples="blur_samples 600 variance 0 ") + scenes.WORLD
SIZE = {"width": 96, "height": 72}


class Interrupted(rendering.RenderTest):
    @classmethod
    def setUpClass(cls):
        cls.whole = rendering.render(SLOW, "+WT2", **SIZE)

    def check(self, stop):
        with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
            folder = pathlib.Path(name)
            rendering.Job(SLOW, ("+WT1", "+BS8"), **SIZE).stop(folder, stop, 8000)
            again = rendering.Job(SLOW, ("+WT2", "+BS8", "+C"), **SIZE)
            said = again.run(folder)
            self.assert_same(again.result(folder), self.whole, f"continued after {stop.name}")
        pixels = re.search(r"^Pixels: +(\d+)", said, re.MULTILINE)
        self.assertIsNotNone(pixels, said)
        self.assertLess(int(pixels[1]), SIZE["width"] * SIZE["height"], f"it began again from the start\n{said}")

    def test_killed(self):
        self.check(signal.SIGKILL)

    def test_interrupted(self):
        self.check(signal.SIGINT)


if __name__ == "__main__":
    rendering.main()

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Memory for a band of a huge picture."""

import pathlib
import tempfile
import unittest

from tests.render import rendering, scenes
from tools import povray_run

SIZE = {"width": 6000, "height": 3000}
BAND = ("+SR1000", "+ER1003", "+WT1")
CHANNELS = 7  # depth, position, blur, samples, standard error
WHOLE = CHANNELS * 4 * SIZE["width"] * SIZE["height"]  # bytes
SCENE = scenes.camera("tilt 3", samples="blur_samples 1, 1 variance 0 ") + scenes.WORLD


def memory(*options):
    job = rendering.Job(SCENE, (*BAND, *options), **SIZE)
    with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
        job.write(pathlib.Path(name))
        return povray_run.run(job.command(), name).succeeded().memory


class BandMemory(unittest.TestCase):
    def test_layers_of_a_band(self):
        added = memory("+N") - memory()
        self.assertLess(added, WHOLE / 8, f"{added / 1e6:.0f} MB more with +N")


if __name__ == "__main__":
    rendering.main()

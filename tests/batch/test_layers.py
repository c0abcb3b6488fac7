# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Joined layers of bands."""

import re
import subprocess

from tests.batch import calls
from tests.batch.calls import LENS, BatchTest, picture

SIZE = ("+W64", "+H75", "+WT1", "+FE", "Output_Layers=on")


def attributes(path):
    done = subprocess.run(["oiiotool", "--info", "-v", str(path)], capture_output=True, text=True, check=True)
    lines = [line.strip() for line in done.stdout.splitlines()]
    return {line for line in lines if ": " in line and not re.match(r"creation|DateTime|Reading|\S*/|\S+\.exr", line)}


class Layers(BatchTest):
    def test_still_in_bands(self):
        scene = self.scene(LENS)
        self.batch("still", scene, "--bands", 3, "--output", "a.exr", *SIZE)
        whole = self.whole(scene, self.folder / "a.exr", *SIZE)
        self.assert_same(self.folder / "a.exr", whole)
        layers, wanted = self.folder / "a.layers.exr", whole.with_name("a.layers.exr")
        self.assertEqual(picture(layers), picture(wanted))
        self.assertEqual(attributes(layers), attributes(wanted))
        self.assertTrue(any(line.startswith("tiltLens:") for line in attributes(wanted)))

    def test_frames_keep_their_layers(self):
        self.batch("film", self.scene(LENS), "--frames", 2, *SIZE)
        names = {path.name for path in (self.folder / "scene_film").iterdir()}
        self.assertEqual(names, {f"scene000{n}{rest}" for n in (1, 2) for rest in (".exr", ".layers.exr")})


if __name__ == "__main__":
    calls.main()

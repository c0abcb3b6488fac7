# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Whatever further OpenEXR a render writes beside its picture is put together as the picture is.

The program here is POV-Ray with a layers file made from its picture: other names of channels, 32-bit
float, an attribute of its own.
"""

import shlex
import subprocess

import common
from common import LENS, SETTINGS, BatchTest, picture

SIZE = ("+W64", "+H75", "+WT1", "+FE")
LAYERS = "--ch depth=R,blur=G,position.X=B -d float --attrib tiltLens:tilt 4"


def attribute(path):
    """The attribute of the layers' own."""
    done = subprocess.run(["oiiotool", "--info", "-v", str(path)], capture_output=True, text=True, check=True)
    return [line.strip() for line in done.stdout.splitlines() if line.strip().startswith(("tiltLens", "channel list"))]


class Layers(BatchTest):
    def setUp(self):
        super().setUp()
        self.program = self.folder / "povray with layers"
        self.program.write_text(f"""#!/bin/bash
{shlex.quote(str(SETTINGS.povray))} "$@" || exit
shopt -s nullglob
for picture in picture*.exr; do
    [[ $picture == *.layers.exr ]] || oiiotool "$picture" {LAYERS} -o "${{picture%.exr}}.layers.exr" || exit
done
""")
        self.program.chmod(0o755)

    def words(self, *words):
        return [str(common.REPOSITORY / "batch"), *map(str, words), "--povray", str(self.program)]

    def test_still_in_bands(self):
        scene = self.scene(LENS)
        self.batch("still", scene, "--bands", 3, "--output", "a.exr", *SIZE)
        whole = self.whole(scene, self.folder / "a.exr", *SIZE)
        wanted = self.folder / "wanted.exr"
        subprocess.run(["oiiotool", str(whole), *LAYERS.split(), "-o", str(wanted)], check=True)
        self.assertEqual(picture(self.folder / "a.layers.exr"), picture(wanted))
        self.assertEqual(attribute(self.folder / "a.layers.exr"), attribute(wanted))
        self.assertTrue(attribute(wanted))

    def test_frames_keep_their_layers(self):
        self.batch("film", self.scene(LENS), "--frames", 2, *SIZE)
        names = {path.name for path in (self.folder / "scene_film").iterdir()}
        self.assertEqual(names, {f"scene000{n}{rest}" for n in (1, 2) for rest in (".exr", ".layers.exr")})


if __name__ == "__main__":
    common.main()

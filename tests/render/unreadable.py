# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Folders where a scene wants files: refused at once, with the name and the line."""

import pathlib
import subprocess
import tempfile

from tests.render import rendering, scenes

UNREADABLE = {
    '#include "folder"': "Cannot open include file folder",
    '#fopen F "folder" read': "Cannot open user file folder",
    'plane { z, 9 pigment { image_map { png "folder" } } }': "Cannot find image file",
    'text { ttf "folder" "a", 1, 0 }': "Cannot open font file",
}


class Folders(rendering.RenderTest):
    def refused(self, scene, *options):
        """What POV-Ray says, in a folder that holds a folder; no picture may be there."""
        with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
            folder = pathlib.Path(name)
            (folder / "folder").mkdir()
            job = rendering.Job(scene, options)
            process = job.start(folder)
            try:
                said = process.communicate(timeout=60)[0].decode(errors="replace")
            except subprocess.TimeoutExpired:
                process.kill()
                process.communicate()
                raise AssertionError(f"no end after 60 s\n{job.told()}") from None
            self.assertEqual(process.returncode, 1, said)
            self.assertEqual(list(folder.glob("*.png")), [], said)
        return " ".join(said.split())

    def test_in_a_scene(self):
        for line, error in UNREADABLE.items():
            with self.subTest(line):
                scene = scenes.TILTED + line + "\n"
                said = self.refused(scene)
                place = f"File 'scene.pov' line {len((rendering.HEAD + scene).splitlines())}: "
                self.assertIn(place + "Possible Parse Error: Cannot find file 'folder'", said)
                self.assertRegex(said, place + f"(Possible )?Parse Error: {error}")

    def test_as_the_scene(self):
        said = self.refused(scenes.TILTED, "+Ifolder")
        self.assertIn("Cannot find file 'folder'", said)
        self.assertIn("Parse Error: Cannot open input file.", said)


if __name__ == "__main__":
    rendering.main()

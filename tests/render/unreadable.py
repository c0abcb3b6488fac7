# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Folders where a scene wants files: refused at once, with the name and the line. Pictures that the tests themselves cannot read."""

import pathlib
import tempfile
import unittest

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
            code, said = rendering.Job(scene, options).attempt(folder, 60)
            self.assertEqual(code, 1, said)
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


class Pictures(unittest.TestCase):
    def test_one_that_is_torn(self):
        """It is told from the others, which are read before and after it."""
        with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
            folder = pathlib.Path(name)
            job = rendering.Job(scenes.TILTED)
            job.run(folder)
            whole, torn = folder / "picture.png", folder / "torn.png"
            torn.write_bytes(whole.read_bytes()[:whole.stat().st_size // 2])
            before = job.result(folder)
            for path in (torn, folder / "none.png"):
                with self.assertRaisesRegex(rendering.UnreadablePicture, path.name):
                    rendering.read_picture(path, "")
            self.assertEqual(job.result(folder).values, before.values)


if __name__ == "__main__":
    rendering.main()

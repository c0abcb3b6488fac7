# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later

import concurrent.futures
import pathlib
import struct
import tempfile
import unittest

from tests.render import rendering, scenes
from tools import povray_run

UNREADABLE = {
    '#include "folder"': "Cannot open include file folder",
    '#fopen F "folder" read': "Cannot open user file folder",
    'plane { z, 9 pigment { image_map { png "folder" } } }': "Cannot find image file",
    'text { ttf "folder" "a", 1, 0 }': "Cannot open font file",
}


class Folders(rendering.RenderTest):
    def refused(self, scene, *options):
        with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
            folder = pathlib.Path(name)
            (folder / "folder").mkdir()
            code, said = rendering.Job(scene, options).attempt(folder)
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
    def test_truncated_picture(self):
        with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
            folder = pathlib.Path(name)
            job = rendering.Job(scenes.TILTED)
            job.run(folder)
            whole, torn = folder / "picture.png", folder / "torn.png"
            torn.write_bytes(whole.read_bytes()[: whole.stat().st_size // 2])
            before = job.result(folder)
            for path in (torn, folder / "none.png"):
                with self.assertRaisesRegex(povray_run.UnreadablePicture, path.name):
                    rendering.read_picture(path, "")
            self.assertEqual(job.result(folder).values, before.values)

    def test_threads_get_the_pictures_that_they_ask_for(self):
        with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
            paths = [pathlib.Path(name) / f"{width}.pfm" for width in range(1, 9)]
            for width, path in enumerate(paths, 1):
                path.write_bytes(f"PF\n{width} 1\n-1.0\n".encode() + struct.pack(f"<{3*width}f", *[width] * 3 * width))

            def read(width):
                return [rendering.read_picture(paths[width - 1], "").values for _ in range(100)]

            with concurrent.futures.ThreadPoolExecutor(len(paths)) as threads:
                for width, pictures in enumerate(threads.map(read, range(1, 9)), 1):
                    self.assertEqual(pictures, [[width] * 3 * width] * 100)


if __name__ == "__main__":
    rendering.main()

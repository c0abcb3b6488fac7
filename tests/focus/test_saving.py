# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Writing into the scene's file."""

import asyncio
import os
import pathlib
import signal
import tempfile
import unittest
from unittest import mock

from tests.focus import harness
from tests.focus.client import PLANE, WORDS, ClientTest, page_at
from tests.focus.harness import SCENE
from tools.focus import replacing
from tools.focus.scene_file import SceneFile
from tools.focus.scene_text import EditError, with_block


class WhileItIsChecked(ClientTest):
    def write(self, scene, gate, then):
        address = self.start(scene, *WORDS)

        async def ask():
            async with page_at(address, autoclose=False) as page:
                await page.told("preview", "done")
                gate.touch()
                await page.write()
                while not (self.scratch() / "changed.log").exists():
                    await asyncio.sleep(0.01)
                return await then(page)

        return asyncio.run(ask())

    def test_what_is_saved_meanwhile_stays(self):
        text, gate = self.gated()
        scene = self.scene(text)

        async def save(page):
            scene.write_text(text + "// mine\n")
            gate.unlink()
            return await page.told("file")

        told = self.write(scene, gate, save)
        self.assertEqual(told["state"], "refused")
        self.assertIn("changed meanwhile", told["reason"])
        self.assertEqual(scene.read_text(), text + "// mine\n")
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), ["errors", "scene.pov", "tmp"])

    def test_the_end_of_the_program_writes_nothing(self):
        text, gate = self.gated()
        scene = self.scene(text)

        async def end(page):
            self.process.send_signal(signal.SIGTERM)
            await page.closed()
            gate.unlink()  # now the check could succeed
            return await asyncio.to_thread(self.process.wait, 120)

        self.assertEqual(self.write(scene, gate, end), 0)
        self.assertEqual(scene.read_text(), text)
        self.assertEqual(self.left(), [])
        self.assertNotIn("Traceback", self.evidence())


class Files(ClientTest):
    def written(self, scene):
        address = self.start(scene, *WORDS)

        async def write():
            async with page_at(address) as page:
                await page.told("preview", "done")
                await page.write()
                return await page.told("file")

        told = asyncio.run(write())
        self.end()
        return told

    def test_a_protected_file_is_refused(self):
        scene = self.scene()
        scene.chmod(0o444)
        told = self.written(scene)
        self.assertEqual((told["state"], told["reason"]), ("refused", "scene.pov is write-protected, or belongs to somebody else"))
        self.assertEqual(scene.read_text(), SCENE)

    def test_owner_rights_links_and_ends_of_lines_stay(self):
        scene, other = self.scene(SCENE.replace("\n", "\r\n")), self.folder / "other.pov"
        os.link(scene, other)
        scene.chmod(0o640)
        if os.geteuid() == 0:
            os.chown(scene, 1234, 1235)
        before = scene.stat()
        self.assertEqual(self.written(scene)["state"], "written")
        for path in (scene, other):
            text, after = path.read_bytes(), path.stat()
            self.assertIn(b"\r\n  tilt_lens {\r\n    f_stop 2\r\n    focal_plane { <0, 0, 1>, 2 }\r\n  }\r\n}", text)
            self.assertEqual(text.count(b"\n"), text.count(b"\r\n"))
            self.assertEqual(
                (after.st_uid, after.st_gid, after.st_mode, after.st_ino), (before.st_uid, before.st_gid, before.st_mode, before.st_ino)
            )


class Replacing(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.path = pathlib.Path(scratch.name) / "file"
        self.path.write_bytes(b"before, and longer")

    def replace(self, before=b"before, and longer"):
        replacing.replace(str(self.path), before, b"after")

    def test_owner_stays_without_the_right_to_change_it(self):
        number = self.path.stat().st_ino
        with mock.patch("os.chown", side_effect=PermissionError(1, "Operation not permitted")):
            self.replace()
        self.assertEqual((self.path.read_bytes(), self.path.stat().st_ino), (b"after", number))
        self.assertEqual(os.listdir(self.path.parent), ["file"])

    def test_a_file_of_one_name_is_replaced_in_one_step(self):
        number = self.path.stat().st_ino
        if os.geteuid() == 0:
            os.chown(self.path, 1234, 1235)
        self.path.chmod(0o604)
        owner = self.path.stat()
        self.replace()
        after = self.path.stat()
        self.assertNotEqual(after.st_ino, number)
        self.assertEqual((after.st_uid, after.st_gid, after.st_mode), (owner.st_uid, owner.st_gid, owner.st_mode))

    def test_what_somebody_else_has_written_stays(self):
        for links in (1, 2):
            with self.subTest(links), self.assertRaisesRegex(EditError, "changed meanwhile"):
                self.replace(b"another beginning")
            self.assertEqual(self.path.read_bytes(), b"before, and longer")
            self.assertEqual(len(os.listdir(self.path.parent)), links)
            if links == 1:
                os.link(self.path, self.path.with_name("second"))

    def test_without_a_copy_nothing_is_written(self):
        scene = self.path.with_name("s" * 250 + ".pov")  # the backup's name is too long
        scene.write_text(SCENE)
        with self.assertRaisesRegex(EditError, "^no copy of the scene can be kept in its folder: File name too long$"):
            SceneFile(str(scene)).replace(SCENE.encode(), b"after")
        self.assertEqual(scene.read_text(), SCENE)

    def test_full_disk_leaves_the_file_unchanged(self):
        os.link(self.path, self.path.with_name("second"))
        with mock.patch("os.posix_fallocate", side_effect=OSError(28, "No space left on device")):
            with self.assertRaisesRegex(EditError, "cannot be written: No space left"):
                self.replace()
        self.assertEqual(self.path.read_bytes(), b"before, and longer")


class EndsOfLines(unittest.TestCase):
    def test_they_stay_wherever_the_block_goes(self):
        for camera in ("camera {\n  location 0\n}", "camera {\n  tilt_lens { tilt 3 }\n}", "camera {\n  angle 3\n  location 0\n}"):
            text = ("#version 3.7;\n" + camera + "\n").replace("\n", "\r\n")
            changed = with_block(text, camera.count("\n") + 2, PLANE, {"focal_point": "<1, 2, 3>", "angle": None})
            with self.subTest(camera):
                self.assertIn("f_stop 2\r\n", changed)
                self.assertEqual(changed.count("\n"), changed.count("\r\n"))


if __name__ == "__main__":
    harness.main()

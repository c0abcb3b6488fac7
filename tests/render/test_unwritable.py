# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Unwritable output gives one message."""

import pathlib
import re
import resource
import tempfile
import unittest

from tests.render import rendering, scenes
from tools.povray_run import held_to_permissions


class Unwritable(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory(prefix="tilt_lens.")
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)

    def refused(self, *options, **settings):
        code, said = self.attempt(scenes.TILTED, *options, **settings)
        self.assertNotEqual(code, 0, said)
        return said

    def attempt(self, scene, *options, **settings):
        code, said = rendering.Job(scene, options, width=16, height=12).attempt(self.folder, before=held_to_permissions(), **settings)
        return code, " ".join(said.split())

    def assert_once(self, said, *parts):
        self.assertRegex(said, ".*".join(map(re.escape, parts)))
        self.assertEqual(said.count(parts[0]), 1, said)

    def test_missing_folder(self):
        said = self.refused("+Onowhere/a.png")
        self.assert_once(said, "Cannot write '", "nowhere/a.pov-state' (No such file or directory)", "nothing was rendered")
        self.assertNotIn("Rendered", said)

    def test_folder_without_permission(self):
        (self.folder / "locked").mkdir(mode=0o555)
        self.assert_once(self.refused("+Olocked/a.png"), "Cannot write '", "locked/a.pov-state' (Permission denied)")

    def test_folder_in_place_of_the_picture(self):
        (self.folder / "picture.png").mkdir()
        (self.folder / "picture.png" / "used").touch()
        self.assert_once(self.refused(), "Cannot write the picture '", "picture.png'", "directory)", "+C")

    def test_ini_file(self):
        self.assert_once(self.refused("+GInowhere/a.ini"), "Cannot write the INI file 'nowhere/a.ini' (No such file or directory)", "+GI")

    def test_state_file_beyond_the_size_limit(self):
        def limit():
            resource.setrlimit(resource.RLIMIT_FSIZE, (4096, 4096))

        said = self.refused("+W64", "+H64", "+BS8", "+WT1", preexec_fn=limit)
        self.assertRegex(
            said, r"Cannot write the state file '[^']*picture\.pov-state' \(File too large\)\. Make room there, then continue with \+C"
        )
        self.assertNotIn("Cannot access data in file", said)
        self.assertEqual(said.count("Cannot write the state file"), 1, said)
        state = self.folder / "picture.pov-state"
        self.assertLessEqual(state.stat().st_size, 4096)
        again = rendering.Job(scenes.TILTED, ("+W64", "+H64", "+BS8", "+C"), width=16, height=12).attempt(self.folder)
        self.assertEqual(again[0], 0, again[1])

    def test_text_file_beyond_the_size_limit(self):
        def limit():
            resource.setrlimit(resource.RLIMIT_FSIZE, (8192, 8192))

        for count, reason in ((300, "File too large"), (3000, "not all of it was taken; is the disk full?")):
            for close, kind in (("#fclose F", "Parse Error"), ("", "Possible Parse Error")):
                with self.subTest(count=count, close=close):
                    scene = f'#fopen F "text" write #for (I, 1, {count}) #write (F, "0123456789 0123456789 012345678\\n") #end\n{close}\n'
                    code, said = self.attempt(scenes.TILTED + scene, preexec_fn=limit)
                    self.assert_once(said, f"{kind}: Cannot write the file 'text' ({reason})")
                    self.assertEqual(said.count("Cannot write"), 1, said)
                    self.assertEqual(code, 1 if close else 0, said)
        code, said = self.attempt(scenes.TILTED + scene)
        self.assertNotIn("Cannot write", said)
        self.assertEqual((self.folder / "text").stat().st_size, 32 * count)

    def test_lost_messages_do_not_end_the_render(self):
        scene = '#debug "text\\n"\n' + scenes.TILTED
        code, said = self.attempt(scene)
        self.assertEqual(code, 0, said)
        picture = self.folder / "picture.png"
        whole = rendering.read_pixels(picture)
        picture.unlink()
        files = {"All_File": "all.txt", "Debug_File": "debug.txt"}
        for name in files.values():
            (self.folder / name).symlink_to("/dev/full")
        code, said = self.attempt(scene, "+Opicture.png", *(f"{option}={name}" for option, name in files.items()))
        self.assertEqual(code, 0, said)
        self.assertEqual(rendering.read_pixels(picture), whole)
        for name in files.values():
            self.assert_once(said, f"Warning: Cannot write the file '{name}' (No space left on device)", "make room there")

    def test_messages_in_a_missing_folder(self):
        said = self.refused("+Onowhere/a.png", "All_File=all.txt")
        self.assert_once(said, "Cannot open file 'nowhere/all.txt' for output (No such file or directory)")

    def test_long_text_is_in_the_console_text(self):
        text = f'"{"long " * 40}"'
        warning = f'#warning concat({", ".join([text] * 9)}, "end")\n'
        code, said = self.attempt(warning + scenes.TILTED, "+Opicture.png", "All_File=all.txt")
        self.assertEqual(code, 0, said)
        self.assertIn("long end", " ".join((self.folder / "all.txt").read_text(encoding="utf-8").split()))

    def test_closed_standard_streams_are_no_place_for_messages(self):
        names = "ABCD"
        opened = "".join(f'#fopen {name} "{name}" write\n' for name in names)
        closed = "".join(f'#write ({name}, "own\\n") #fclose {name}\n' for name in names)
        job = rendering.Job(
            scenes.TILTED + opened + '#debug "stray\\n" #warning "stray"\n#for (I, 1, 1000000) #local X = sin(I)*I; #end\n' + closed,
            ("-F",),
            width=16,
            height=12,
        )
        job.attempt(self.folder, before=("sh", "-c", 'exec "$@" <&- >&- 2>&-', "sh"))
        self.assertEqual([(self.folder / name).read_text(encoding="utf-8") for name in names], ["own\n"] * len(names))

    def test_refused_state_file(self):
        (self.folder / "picture.pov-state").write_bytes(b"garbage" * 100)
        self.assert_once(self.refused("+C"), "is not one of POV-Ray's")


if __name__ == "__main__":
    rendering.main()

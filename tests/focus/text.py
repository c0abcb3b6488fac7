# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Parts of ./focus without a page: the text of scenes, messages of POV-Ray, options, the include file's lenses."""

import re
import unittest

from tests.focus import harness
from tools.focus import focus, povray, scene_text
from tools.focus.scene_text import Doubt, with_block
from tools.repository import ROOT

BLOCK = "tilt_lens {\n  f_stop 2\n}"
HIDDEN = """// camera { }
/* camera { /* nested */ } */
#declare Name = "camera { \\" }";
camera {
  location 0   // } no end
  angle 40
  look_at z
}
sphere { 0, 1 }
"""


class SceneText(unittest.TestCase):
    def test_comments_and_strings_are_no_code(self):
        changed = with_block(HIDDEN, 8, BLOCK, {})
        self.assertEqual(changed, HIDDEN.replace("look_at z\n", "look_at z\n  tilt_lens {\n    f_stop 2\n  }\n"))

    def test_an_old_block_is_replaced_and_all_else_stays(self):
        before = "camera {\n  location 0\n    tilt_lens { tilt Tilt /* } */ f_stop 1.4 } // behind\n  angle 30\n}\n"
        after = "camera {\n  location 0\n    tilt_lens {\n      f_stop 2\n    } // behind\n  angle 30\n}\n"
        self.assertEqual(with_block(before, 5, BLOCK, {}), after)

    def test_items_of_the_camera_are_replaced_added_and_removed(self):
        before = "camera { angle 40 aperture 0.5 location z }"
        changed = with_block(before, 1, BLOCK, {"angle": "50", "aperture": None, "focal_point": "<1, 2, 3>"})
        self.assertEqual(" ".join(changed.split()), "camera { angle 50 location z focal_point <1, 2, 3> tilt_lens { f_stop 2 } }")

    def test_what_cannot_be_done_without_a_guess_is_refused(self):
        for text, line, items in (
            ("camera { Cam }\ncamera {\n}", 9, {}),
            ("camera { } camera { }", 1, {}),
            ("camera { tilt_lens { #if (A) tilt 2 #end } }", 1, {}),
            ("camera { tilt_lens { } tilt_lens { } }", 1, {}),
            ("camera { angle Wide*2 }", 1, {"angle": "50"}),
            ("camera { location 0", 1, {}),
        ):
            with self.subTest(text), self.assertRaises(Doubt):
                with_block(text, line, BLOCK, items)

    def test_an_item_that_the_page_does_not_write_is_not_lost(self):
        for item in scene_text.NOT_WRITTEN:
            with self.assertRaisesRegex(Doubt, f"has {item}, which would be lost"):
                with_block(f"camera {{ tilt_lens {{ tilt 3 {item} off }} }}", 1, BLOCK, {})

    def test_each_item_of_the_language_is_written_or_kept(self):
        source = ROOT / "povray-src/povray/source/backend/parser/tilt_lens_words.cpp"
        items = re.findall(r'^    \{"(\w+)", ', source.read_text(), re.MULTILINE)
        self.assertEqual(sorted(items), sorted(scene_text.WRITTEN + scene_text.NOT_WRITTEN))

    def test_version(self):
        self.assertEqual(scene_text.version_of("// #version 3.5;\n#version 3.7;\n"), "3.7")
        self.assertIsNone(scene_text.version_of("sphere { 0, 1 }"))


class Messages(unittest.TestCase):
    def test_an_error_has_its_file_and_line(self):
        error = povray.error_in("x\nFile '/a/b.pov' line 7: Parse Error: Missing }, found\n  this instead\nFatal error in parser: y\n")
        self.assertEqual((error.file, error.line, error.message), ("/a/b.pov", 7, "Missing }, found this instead"))

    def test_anything_else_is_told_by_its_end(self):
        self.assertIn("three", povray.error_in("one\ntwo\nthree\n").message)

    def test_names_with_blanks_stay_whole(self):
        self.assertEqual(povray.with_quotes("+Lmy folder"), '+L"my folder"')
        self.assertEqual(povray.with_quotes("Declare=A=1 + 2"), "Declare=A=1 + 2")


class Options(unittest.TestCase):
    def test_size(self):
        for options, size in (
            ([], ((960, 540), False)),
            (["+W640", "+H480"], ((640, 480), True)),
            (["Width=320"], ((320, 180), False)),
            (["+A0.3", "+h90"], ((160, 90), False)),
        ):
            self.assertEqual(focus.size_in(options), size)

    def test_lenses_and_films_are_those_of_the_include_file(self):
        found = focus.real_lenses()
        self.assertIn({"name": "Canon TS-E 24mm f/3.5L II", "focalLength": 24, "fStop": 3.5, "tilt": 8.5, "shift": 12}, found["lenses"])
        self.assertEqual((len(found["lenses"]), len(found["films"])), (9, 10))
        self.assertIn({"name": "Full Frame", "size": [36, 24]}, found["films"])


if __name__ == "__main__":
    harness.main()

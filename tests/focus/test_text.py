# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Parts of ./focus without a page."""

import pathlib
import re
import tempfile
import unittest

from tests.focus import harness
from tools.focus import focus, render, scene_text
from tools.focus.options import Options
from tools.focus.scene_text import EditError, with_block
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
            ('camera { tilt_lens { prescription "a.dat" } }', 1, {}),
        ):
            with self.subTest(text), self.assertRaises(EditError):
                with_block(text, line, BLOCK, items)

    def test_other_items_are_kept(self):
        before = "camera {\n  tilt_lens {\n    tilt 3 denoise off // quick\n    focus_peaking\n      rgb <1, 0, 0>, 2 f_stop Stop\n  }\n}\n"
        after = "camera {\n  tilt_lens {\n    f_stop 2\n    denoise off\n    focus_peaking rgb <1, 0, 0>, 2\n  }\n}\n"
        self.assertEqual(with_block(before, 7, BLOCK, {}), after)
        for item in scene_text.KEPT:
            text = f"camera {{ tilt_lens {{ tilt 3 {item} (1 + 1) /* f_stop 4 */ scene_unit 10 }} }}"
            self.assertEqual(scene_text.kept_at(text, 1), [f"{item} (1 + 1)"])
        self.assertEqual(scene_text.kept_at("camera { tilt_lens { tilt 3 } }", 1), [])
        self.assertIsNone(scene_text.kept_at("camera { angle 40 }", 1))

    def test_each_item_of_the_language_is_written_or_kept(self):
        source = ROOT / "povray-src/povray/source/backend/parser/tilt_lens_items.cpp"
        items = re.findall(r'^    \{"(\w+)", ', source.read_text(), re.MULTILINE)
        self.assertEqual(sorted(items), sorted(scene_text.WRITTEN + scene_text.KEPT + scene_text.REFUSED))

    def test_version(self):
        self.assertEqual(scene_text.version_of("// #version 3.5;\n#version 3.7;\n"), "3.7")
        self.assertIsNone(scene_text.version_of("sphere { 0, 1 }"))


class Messages(unittest.TestCase):
    def test_an_error_has_its_file_and_line(self):
        error = render.error_in("x\nFile '/a/b.pov' line 7: Parse Error: Missing }, found\n  this instead\nFatal error in parser: y\n")
        self.assertEqual((error.file, error.line, error.message), ("/a/b.pov", 7, "Missing }, found this instead"))

    def test_an_error_in_a_file_of_a_long_name_has_its_file_and_line(self):
        said = "File 'x' line 2: Parse Warning: odd\nFile '/a long\n name/%s\n%s.pov'\n line 7: Parse\n Error: Missing }\nRender failed\n"
        error = render.error_in(said % (70 * "a", 70 * "b"))
        self.assertEqual((error.file, error.line, error.message), (f"/a long name/{70 * 'a'}{70 * 'b'}.pov", 7, "Missing }"))

    def test_other_output_is_shown_by_its_end(self):
        self.assertIn("three", render.error_in("one\ntwo\nthree\n").message)

    def test_names_with_blanks_stay_whole(self):
        self.assertEqual(render.with_quotes("+Lmy folder"), '+L"my folder"')
        self.assertEqual(render.with_quotes("Declare=A=1 + 2"), "Declare=A=1 + 2")


class Settings(unittest.TestCase):
    def test_size(self):
        for words, size in (
            ([], ((960, 540), False)),
            (["+W640", "+H480"], ((640, 480), True)),
            (["Width=320"], ((320, 180), False)),
            (["+A0.3", "+h90"], ((160, 90), False)),
        ):
            found = Options(words)
            self.assertEqual((found.size, found.size_given), size)

    def test_clock(self):
        for words, clock, clocks in (
            ([], None, (0, 1)),
            (["+K0.25"], 0.25, (0, 1)),
            (["Clock=-2", "Declare=Clock=7"], -2, (-2, 1)),
            (["+KI1", "+KF5", "+K2"], 2, (1, 5)),
            (["+KFI1", "+KFF48", "+KI10", "+KF-10"], 10, (-10, 10)),
            (["Initial_Clock=3", "final_clock=4"], None, (3, 4)),
        ):
            with self.subTest(words):
                found = Options(words)
                self.assertEqual((found.clock, found.clocks), (clock, clocks))

    def test_ini_files(self):
        with tempfile.TemporaryDirectory() as folder:
            ini = pathlib.Path(folder) / "film.ini"
            ini.write_text("; a film\nFinal_Frame = 24 ; frames\n+W320 +H200\n[slow]\nFinal_Clock=9\n[fast]\nFinal_Clock=2\n")
            found = Options([f"{ini}[Slow]", "+H100"])
            self.assertEqual((found.size, found.size_given, found.clock, found.clocks), ((320, 100), True, 0, (0, 9)))
            self.assertEqual(Options([f"{ini}"]).clocks, (0, 1))
            self.assertEqual(Options(["nowhere.ini"]).clocks, (0, 1))

    def test_lenses_and_films_are_those_of_the_include_file(self):
        found = focus.real_lenses()
        self.assertIn({"name": "Canon TS-E 24mm f/3.5L II", "focalLength": 24, "fStop": 3.5, "tilt": 8.5, "shift": 12}, found["lenses"])
        self.assertEqual((len(found["lenses"]), len(found["films"])), (10, 10))
        self.assertIn({"name": "Full Frame", "size": [36, 24]}, found["films"])


if __name__ == "__main__":
    harness.main()

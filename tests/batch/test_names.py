# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""File names and read-only folders."""

import os
import pathlib
import subprocess
import tempfile

from tests.batch import calls
from tests.batch.calls import LENS, BatchTest
from tools.povray_run import held_to_permissions

WEIRD = "a \"b' c\nd $(x) %a ;*"
RELATIVE = (
    LENS
    + """#include "own.inc"
#include "../beside/other.inc"
box { -1, 1 pigment { image_map { png "textures/map.png" } } }
#fopen Data "values.txt" read
#read (Data, Size)
sphere { <2, 0, 0>, Size pigment { rgb 1 } }
#fopen Trace "trace.txt" write
#write (Trace, "written by the scene")
"""
)


class InFolders(BatchTest):
    def lay_out(self, name):
        folder = self.folder / name / "scenes"
        for path, text in (("own.inc", "#declare Own = 1;"), ("../beside/other.inc", "#declare Other = 1;"), ("values.txt", "0.7")):
            (folder / path).parent.mkdir(parents=True, exist_ok=True)
            (folder / path).write_text(text + "\n")
        (folder / "textures").mkdir()
        subprocess.run(["oiiotool", "--pattern", "checker", "16x16", "3", "-o", "map.png"], cwd=folder / "textures", check=True)
        scene = folder / f"{name}.pov"
        scene.write_text(RELATIVE)
        return scene

    def whole_in_place(self, scene):
        copy = scene.with_name("copy.pov")
        copy.write_text(scene.read_text())
        picture = self.rendered(copy.name, "copy.png", "--unrestricted", "+FN", "+W64", "+H64", folder=scene.parent)
        copy.unlink()
        return picture

    def test_anything_in_names(self):
        scene = self.lay_out(WEIRD)
        self.batch("still", scene, "--bands", 2, "+W64", "+H64", "--output", f"out {WEIRD}.png")
        self.assert_same(self.folder / f"out {WEIRD}.png", self.whole_in_place(scene))
        self.batch("film", scene, "--frames", 2, "+W64", "+H64", "--work", f"work {WEIRD}")
        self.assertEqual(len(os.listdir(self.folder / f"{WEIRD}_film")), 2)
        self.batch("sweep", scene, "--set", "Tilt=1,2", "+W64", "+H64")
        self.assertEqual(len(os.listdir(self.folder / f"{WEIRD}_sweep")), 3)

    def test_read_only_scene_folder(self):
        scene = self.lay_out("fixed")
        out = self.folder / "out"
        out.mkdir()
        for folder, _, _ in os.walk(self.folder / "fixed"):
            os.chmod(folder, 0o555)
        before = sorted(self.folder.joinpath("fixed").rglob("*"))
        words = ("still", scene, "--bands", 2, "--output", out / "a.png", "+W64", "+H64")
        self.batch(*words, before=held_to_permissions())
        self.assertEqual(sorted(self.folder.joinpath("fixed").rglob("*")), before)
        for folder, _, _ in os.walk(self.folder / "fixed"):
            os.chmod(folder, 0o755)
        self.assert_same(out / "a.png", self.whole_in_place(scene))


class Options(BatchTest):
    def test_files_elsewhere(self):
        with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
            (pathlib.Path(name) / "other.inc").write_text("#declare Other = 1;\n")
            scene = self.scene(LENS + f'#include "{name}/other.inc"\n')
            self.assertIn("Not permitted: reading", self.batch("still", scene, "+W48", "+H40", code=1))
            self.batch("still", scene, "--unrestricted", "+W48", "+H40", "--anew")

    def test_folders_of_options(self):
        (self.folder / "in c").mkdir()
        (self.folder / "in c" / "deep.inc").write_text("#declare Deep = 1;\n")
        (self.folder / "more.ini").write_text("Width=48\nHeight=40\n[wide]\nWidth=96\n")
        scene = self.scene(LENS + '#include "deep.inc"\n')
        self.batch("still", scene, "--bands", 1, "+Lin c", "more.ini[wide]")
        self.assertEqual(calls.picture(self.folder / "scene.png")[:2], (96, 40))
        self.env["POVINC"] = "in c"
        words = ("still", scene, "--bands", 1, "--output", "b.png", "+W48", "+H40")
        self.batch(*words)
        self.assertEqual(calls.picture(self.folder / "b.png")[:2], (48, 40))
        del self.env["POVINC"]
        self.assertIn("environment variable POVINC: was", self.batch(*words, code=1))

    def test_ini_files_and_options_in_povrays_order(self):
        (self.folder / "small.ini").write_text("Width=32\nHeight=24\n")
        scene = self.scene(LENS)
        for words, size in ((("small.ini", "+W48", "+H40"), (48, 40)), (("+W48", "+H40", "small.ini"), (32, 24))):
            self.batch("still", scene, "--bands", 1, *words, "--anew")
            self.assertEqual(calls.picture(self.folder / "scene.png")[:2], size, words)

    def test_another_first_ini_file(self):
        for name in ("low", "high"):
            (self.folder / f"{name}.ini").write_text("Quality=9\n")
        words = ("still", self.scene(LENS), "--bands", 1, "+W48", "+H40")
        self.env["POVINI"] = str(self.folder / "low.ini")
        self.batch(*words)
        self.env["POVINI"] = str(self.folder / "high.ini")
        self.assertIn("POVINI", self.batch(*words, code=1))
        del self.env["POVINI"]
        self.assertIn("POVINI", self.batch(*words, code=1))

    def test_the_current_folder_comes_first_as_for_render(self):
        (self.folder / "colors.inc").write_text("#declare Ball = rgb <0, 1, 0>;\n")
        scene = self.scene('#include "colors.inc"\n' + LENS.replace("rgb <0.9, 0.4, 0.1>", "Ball"))
        self.batch("still", scene, "--bands", 1, "+W48", "+H40")
        (self.folder / "povray.ini").write_text("Width=32\nHeight=24\n")
        said = self.batch("still", scene, "--bands", 1, "+W48", "+H40", code=1)
        self.assertIn("is there now", said)
        self.batch("still", scene, "--bands", 1, "--output", "b.png")
        self.assertEqual(calls.picture(self.folder / "b.png")[:2], (32, 24))


if __name__ == "__main__":
    calls.main()

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Films and sweeps equal single calls."""

from tests.batch import calls
from tests.batch.calls import LENS, BatchTest, picture

SIZE = ("+W64", "+H48", "+WT1")


class Film(BatchTest):
    def test_frames_equal_those_of_one_animation(self):
        scene = self.scene(LENS + '#debug concat("clock ", str(clock, 0, 4), "\\n")\n')
        self.batch("film", scene, "--frames", 5, "--workers", 4, "--output", "my film", *SIZE)
        names = [f"scene{n:04d}.png" for n in range(1, 6)]
        self.assertEqual(sorted(p.name for p in (self.folder / "my film").iterdir()), names)
        self.whole(scene, self.folder / "f.png", "+FN", *SIZE, "+KFI1", "+KFF5")
        seen = set()
        for n, name in enumerate(names, 1):
            self.assert_same(self.folder / "my film" / name, self.folder / "whole" / f"f{n}.png")
            seen.add(picture(self.folder / "my film" / name))
        self.assertEqual(len(seen), 5, "the ball moves")

    def test_frames_in_bands_as_exr(self):
        scene = self.scene(LENS)
        self.batch("film", scene, "--frames", 2, "--bands", 2, "--workers", 4, "+FE", *SIZE, "+KC")
        self.whole(scene, self.folder / "f.exr", "+FE", *SIZE, "+KFI1", "+KFF2", "+KC")
        for n in (1, 2):
            self.assert_same(self.folder / "scene_film" / f"scene000{n}.exr", self.folder / "whole" / f"f{n}.exr")


class Sweep(BatchTest):
    def test_each_choice_and_the_sheet(self):
        scene = self.scene(LENS)
        said = self.batch("sweep", scene, "--set", "Tilt=-6:6:6", "--set", "Samples=4,16", "--workers", 4, *SIZE)
        self.assertIn("scene_sheet.png", said)
        folder = self.folder / "scene_sweep"
        self.assertEqual(len(list(folder.iterdir())), 7)
        for tilt, samples in ((-6, 4), (0, 16)):
            whole = self.whole(scene, self.folder / "w.png", "+FN", *SIZE, f"Declare=Tilt={tilt}", f"Declare=Samples={samples}")
            self.assert_same(folder / f"scene_Tilt={tilt}_Samples={samples}.png", whole)
        self.assertEqual(picture(folder / "scene_sheet.png")[:2], (2 * 64 + 6, 3 * (48 + 26) + 2 * 6))

    def test_sheet_of_exr(self):
        self.batch("sweep", self.scene(LENS), "--set", "Tilt=0,5", "+FE", "--workers", 2, *SIZE)
        width, height, kind, _ = picture(self.folder / "scene_sweep" / "scene_sheet.png")
        self.assertEqual((width, height), (2 * 64 + 6, 48 + 26))
        self.assertIn("uint8", kind)
        self.assertGreater(self.spread(self.folder / "scene_sweep" / "scene_sheet.png"), 0.05)


class Refused(BatchTest):
    def test_one_message_for_each_mistake(self):
        scene = self.scene(LENS)
        (self.folder / "a.exr").mkdir()
        (self.folder / "cmd.ini").write_text("Post_Scene_Command=echo\n")
        for words, code, said in (
            (("still", "none.pov"), 2, "no readable scene file"),
            (("still", scene, "+SR1"), 2, "a batch sets '+SR1' itself"),
            (("still", scene, "--output", "a.jpg"), 2, "a .png or an .exr"),
            (("still", scene, "+FE", "--output", "a.png"), 2, "not of the kind"),
            (("still", scene, "other.pov"), 2, "renders one scene"),
            (("still", scene, "cmd.ini"), 2, "Post_Scene_Command"),
            (("still", scene, "--bands", "0"), 2, "1 or more"),
            (("still", scene, "--frames", "3"), 2, "unknown option --frames"),
            (("film", scene), 2, "--frames"),
            (("sweep", scene, "--set", "Tilt"), 2, "NAME=VALUES"),
            (("sweep", scene, "--set", "A=0:1:0.00001"), 2, "has 100001 values; 100000 at most"),
            (("still", scene, "+FJ"), 2, "PNG (+FN, +FN16) or OpenEXR"),
            (("film", scene, "--frames", "2", "--output", "/"), 2, "is the root of all folders"),
            (("still", scene, "--output", "a.exr"), 2, "is a folder; a still is a file"),
            (("still", scene, "--limit", "1d"), 2, "seconds, or a number with m or h"),
            (("still", scene, "+W0"), 2, "Width=0 (+W0)"),
            (("still", self.scene('#error "my own words"', "bad.pov")), 1, "my own words"),
        ):
            told = self.batch(*words, code=code)
            self.assertIn(said, told)
            self.assertNotIn("Traceback", told)
        self.assertFalse(list(self.folder.glob("*.png")))

    def test_a_program_that_lists_no_files(self):
        self.program = "/usr/bin/povray"
        said = self.batch("still", self.scene(calls.STOCK), code=1)
        self.assertIn("not this project's povray", said)


if __name__ == "__main__":
    calls.main()

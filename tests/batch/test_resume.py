# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The same command keeps finished work and refuses changes."""

import os
import shutil
import subprocess

from tests.batch import calls
from tests.batch.calls import LENS, SETTINGS, BatchTest
from tests.waiting import PATIENCE

SIZE = ("+W48", "+H40", "+WT1")


class Again(BatchTest):
    def test_only_missing_units(self):
        scene = self.scene(LENS)
        self.batch("film", scene, "--frames", 4, *SIZE)
        work, film = self.folder / "scene_film.batch", self.folder / "scene_film"
        times = {path.name: path.stat().st_mtime_ns for path in film.iterdir()}
        first = calls.picture(film / "scene0002.png")
        self.assertIn("4 of 4 pictures", self.batch("film", scene, "--frames", 4, *SIZE))
        self.assertEqual(times, {path.name: path.stat().st_mtime_ns for path in film.iterdir()}, "nothing was made again")
        (film / "scene0002.png").unlink()
        self.batch("film", scene, "--frames", 4, *SIZE)
        self.assertEqual(calls.picture(film / "scene0002.png"), first)
        self.assertEqual({n for n, t in times.items() if (film / n).stat().st_mtime_ns != t}, {"scene0002.png"})
        self.assertIn("4 of 4 pictures", (work / "summary.txt").read_text())

    def test_left_overs_are_not_taken_for_results(self):
        scene = self.scene(LENS)
        self.batch("still", scene, "--bands", 2, *SIZE)
        whole = self.whole(scene, self.folder / "w.png", "+FN", *SIZE)
        work = self.folder / "scene.png.batch"
        for name in ("00000.0000", "00000.0001"):
            (work / "units" / name).mkdir(exist_ok=True)
        (self.folder / "scene.png").unlink()
        (work / "merged" / "00000.json").unlink()
        record = calls.json.loads((work / "done" / "00000.0000.json").read_text())
        size = record["files"][".png"]["bytes"]
        (work / "units" / "00000.0000" / "picture.png").write_bytes(b"\x89PNG".ljust(size, b"x"))
        (work / "done" / "00000.0001.json").unlink()
        (work / "units" / "00000.0001" / "picture.png").write_bytes(whole.read_bytes()[:200])
        (work / "units" / "00000.0001" / "picture.pov-state").write_bytes(b"POV-Ray Render State File\0\0\x000001".ljust(700, b"\1"))
        self.batch("still", scene, "--bands", 2, *SIZE)
        self.assert_same(self.folder / "scene.png", whole)

    def test_a_foreign_folder_is_left_alone(self):
        scene = self.scene(LENS)
        (self.folder / "mine").mkdir()
        (self.folder / "mine" / "letter.txt").write_text("dear")
        for anew in ((), ("--anew",)):
            self.assertIn("letter.txt", self.batch("still", scene, "--work", "mine", *anew, *SIZE, code=1))
        self.assertEqual(os.listdir(self.folder / "mine"), ["letter.txt"])


class Changed(BatchTest):
    def refused(self, *said, words=SIZE, **how):
        told = self.batch("still", self.folder / "scene.pov", "--bands", 1, *words, code=1, **how)
        for text in (*said, "--anew"):
            self.assertIn(text, told)

    def test_each_change_is_named(self):
        scene = self.scene('#include "parts/own.inc"\n' + LENS + 'box { -1, 1 pigment { image_map { png "map.png" } } }\n')
        own = self.scene("#declare Own = 1;\n", "parts/own.inc")
        create = ["oiiotool", "--create", "4x4", "3", "-o", "map.png"]
        subprocess.run(create, cwd=self.folder, check=True)
        self.batch("still", scene, "--bands", 1, *SIZE)
        for path in (scene, own, self.folder / "map.png"):
            kept = path.read_bytes()
            path.write_bytes(kept + b"\n")
            self.refused(f"{path.name}", "has changed")
            path.unlink()
            if path != scene:
                self.refused(path.name)
            path.write_bytes(kept)
        self.refused("options of POV-Ray", "+Q3", words=(*SIZE, "+Q3"))
        self.refused("bands", words=(*SIZE, "--bands", "3"))
        self.batch("still", scene, "--bands", 1, *SIZE)

    def test_another_program(self):
        scene = self.scene(LENS)
        self.batch("still", scene, "--bands", 1, *SIZE)
        self.stand_in("")
        shutil.copy(SETTINGS.povray, self.program)
        with open(self.program, "ab") as program:
            program.write(b"\0")
        self.refused("program povray")

    def test_file_earlier_in_the_search_path(self):
        self.scene("#declare Own = 1;\n", "deep/own.inc")
        scene = self.scene('#include "own.inc"\n' + LENS)
        words = (*SIZE, f"+L{self.folder}/deep")
        self.batch("still", scene, "--bands", 1, *words)
        self.scene("#declare Own = 1;\n", "own.inc")
        self.refused("is there now, and would be found before", words=words)

    def test_a_file_that_changes_while_the_batch_runs(self):
        self.scene('#include "own.inc"\n' + LENS)
        own = self.scene("#declare Own = 1;\n", "own.inc")
        words = ("film", "scene.pov", "--frames", 4, "--workers", 1, *SIZE, "Declare=Samples=300")
        process = self.start(*words)
        done = self.folder / "scene_film.batch" / "done"
        self.until("the first frame", lambda: done.is_dir() and list(done.iterdir()))
        own.write_text("#declare Own = 2;\n")
        self.assertEqual(process.wait(timeout=PATIENCE), 1, self.said())
        self.assertIn(f"file {str(own)!r} has changed since the batch began", self.said())
        self.assertFalse((self.folder / "scene_film" / "scene0004.png").exists())
        self.assertIn(f"file {str(own)!r} has changed", self.batch(*words, code=1))
        own.write_text("#declare Own = 1;\n")
        self.assertIn("4 of 4 pictures", self.batch(*words))

    def test_an_include_file_of_one_frame(self):
        scene = self.scene('#if (frame_number = 3) #include "third.inc" #end\n' + LENS)
        self.scene("#declare Third = 1;\n", "third.inc")
        self.batch("film", scene, "--frames", 3, *SIZE)
        self.scene("#declare Third = 2;\n", "third.inc")
        self.assertIn("has changed", self.batch("film", scene, "--frames", 3, *SIZE, code=1))
        self.batch("film", scene, "--frames", 3, *SIZE, "--anew")


if __name__ == "__main__":
    calls.main()

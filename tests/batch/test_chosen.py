# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Chosen frames of a film; JSON status."""

import json
import os
import signal
import subprocess

from tests.batch import calls
from tests.batch.calls import LENS, BatchTest, picture
from tests.waiting import PATIENCE
from tools.repository import ROOT

SIZE = ("+W48", "+H40", "+WT1")


class Chosen(BatchTest):
    def frames(self):
        film = self.folder / "scene_film"
        return {int(path.name[5:9]): path.stat().st_mtime_ns for path in film.glob("scene*.png")}

    def test_parts_of_a_film(self):
        scene = self.scene(LENS)
        words = ("film", scene, "--frames", 6, *SIZE)
        self.assertIn("3 of 3 pictures", self.batch(*words, "--only", "2-3,6"))
        first = self.frames()
        self.assertEqual(sorted(first), [2, 3, 6])
        self.batch(*words, "--only", "3,6", "--anew")
        again = self.frames()
        self.assertEqual({n for n in first if first[n] != again[n]}, {3, 6})
        self.assertIn("6 of 6 pictures", self.batch(*words))
        self.assertEqual({n: self.frames()[n] for n in again}, again, "what is done stays")
        self.whole(scene, self.folder / "f.png", "+FN", *SIZE, "+KFI1", "+KFF6")
        for n in range(1, 7):
            self.assert_same(self.folder / "scene_film" / f"scene000{n}.png", self.folder / "whole" / f"f{n}.png")

    def test_frames_outside_the_film(self):
        for text in ("0", "7", "3-2", "1-7", "a", "", "1,,2"):
            said = self.batch("film", self.scene(LENS), "--frames", 6, f"--only={text}", *SIZE, code=2)
            self.assertIn("expected frames from 1 to 6", said, text)


class Longer(BatchTest):
    FRAME = LENS.replace("2*clock", "0.2*frame_number")
    FILM = ("film", "scene.pov", *SIZE)

    def stays(self, *longer):
        pictures = [self.folder / "scene_film" / f"scene000{n}.png" for n in (1, 2)]
        times = [path.stat().st_mtime_ns for path in pictures]
        self.assertIn("4 of 4 pictures", self.batch(*self.FILM, *longer))
        return times == [path.stat().st_mtime_ns for path in pictures]

    def refused(self, *longer):
        return " ".join(self.batch(*self.FILM, *longer, code=1).split())

    def test_without_clock(self):
        scene = self.scene(self.FRAME)
        self.batch(*self.FILM, "--frames", 2)
        self.assertTrue(self.stays("--frames", 4))
        self.whole(scene, self.folder / "f.png", "+FN", *SIZE, "+KFI1", "+KFF4")
        for n in range(1, 5):
            self.assert_same(self.folder / "scene_film" / f"scene000{n}.png", self.folder / "whole" / f"f{n}.png")
        self.assertIn("4 of 4 pictures", self.batch(*self.FILM, "--frames", 4))
        self.assertIn("pictures (frames", self.refused("--frames", 3))

    def test_the_clock_goes_on(self):
        scene = self.scene(LENS)
        self.batch(*self.FILM, "--frames", 2, "+KF1")
        self.assertTrue(self.stays("--frames", 4, "+KF3"))
        self.whole(scene, self.folder / "f.png", "+FN", *SIZE, "+KFI1", "+KFF4", "+KF3")
        for n in range(1, 5):
            self.assert_same(self.folder / "scene_film" / f"scene000{n}.png", self.folder / "whole" / f"f{n}.png")

    def test_another_clock(self):
        self.scene(LENS)
        self.batch(*self.FILM, "--frames", 2)
        said = self.refused("--frames", 4)
        self.assertIn("the clock of frame 2 was 1, and is 0.3333333", said)
        self.assertIn("+KF1 for 2 frames and +KF3 for 4", said)
        self.assertIn("options of POV-Ray", self.refused("--frames", 4, "+KC"))
        (self.folder / "c.ini").write_text("Final_Clock=3\n")
        self.assertIn("options of POV-Ray", self.refused("--frames", 4, "c.ini"))

    def test_scene_depending_on_its_length(self):
        (self.folder / "length.inc").write_text("#declare Length = final_frame; // clock\n")
        self.scene(self.FRAME + '#include "length.inc"\n')
        self.batch(*self.FILM, "--frames", 2)
        said = self.refused("--frames", 4)
        self.assertIn("length.inc", said)
        self.assertIn("uses final_frame, which depends on the number of frames", said)

    def test_another_scene(self):
        self.scene(self.FRAME)
        self.batch(*self.FILM, "--frames", 2)
        self.scene(self.FRAME + " ")
        self.assertIn('scene.pov" has changed', self.refused("--frames", 4))


class Seeds(BatchTest):
    def test_another_noise_in_each_frame(self):
        still = LENS.replace("2*clock", "0").replace("f_stop 1", "f_stop 1 denoise off SEED")
        for seed, different in (("", 1), ("sample_seed frame_number", 3)):
            self.scene(still.replace("SEED", seed))
            self.batch("film", "scene.pov", "--frames", 3, "--output", f"film{different}", *SIZE)
            found = {picture(path) for path in (self.folder / f"film{different}").glob("*.png")}
            self.assertEqual(len(found), different)


class Told(BatchTest):
    def status(self, name):
        done = subprocess.run([str(ROOT / "batch"), "status", name], cwd=self.folder, stdout=subprocess.PIPE, check=True)
        return json.loads(done.stdout)

    def test_status(self):
        scene = self.scene(LENS + '#if (frame_number = 2) #error "broken" #end\n')
        self.batch("film", scene, "--frames", 3, "--only", "1-2", *SIZE, code=1)
        for name in ("scene_film", "scene_film.batch"):
            told = self.status(name)
            self.assertEqual([told[word] for word in ("kind", "complete", "done", "failed", "waiting")], ["film", False, 1, 1, 1])
            first, second, third = told["units"]
            self.assertEqual((first["picture"], first["rows"], first["state"]), ("scene0001.png", [1, 40], "done"))
            self.assertEqual(first["host"], os.uname().nodename)
            self.assertGreater(first["seconds"], 0)
            self.assertTrue(os.path.isfile(first["log"]))
            self.assertEqual((second["state"], second["reason"]), ("failed", "povray ended with exit code 1"))
            self.assertEqual(third["state"], "waiting")

    def test_status_of_a_unit_at_work(self):
        self.scene(LENS)
        large = ("+W480", "+H400", "+WT1")  # takes minutes, and is ended below
        process = self.start("still", "scene.pov", "--bands", 1, *large, "Declare=Samples=4000")
        work = self.folder / "scene.png.batch"
        self.until("the unit", lambda: list(work.glob("running/*.json")))
        unit = self.until("a percentage", lambda: next((u for u in self.status("scene.png")["units"] if u.get("percent")), None))
        self.assertEqual(unit["state"], "running")
        process.send_signal(signal.SIGINT)
        self.assertEqual(process.wait(timeout=PATIENCE), 130)

    def test_status_of_no_batch(self):
        done = subprocess.run([str(ROOT / "batch"), "status", "nothing"], cwd=self.folder, capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 2)
        self.assertIn("is not the work folder of a batch", done.stderr)

    def test_a_command_afterwards(self):
        words = ("still", self.scene(LENS), "--bands", 1, *SIZE)
        self.batch(*words, "--then", 'ls "$BATCH_OUTPUT" > listed; test -d "$BATCH_WORK"')
        self.assertIn("scene.png", (self.folder / "listed").read_text())
        self.assertIn("--then ended with exit code 3", self.batch(*words, "--then", "exit 3", code=1))
        bad = self.scene(LENS + '#error "broken"', "bad.pov")
        self.batch("still", bad, *SIZE, "--then", "touch never", code=1)
        self.assertFalse((self.folder / "never").exists())


class Texts(BatchTest):
    def test_texts_in_a_sweep(self):
        colours = '#switch (strcmp(Ball, "dark green")) #case (0) #declare C = <0, 0.3, 0>; #break #else #declare C = <1, 0, 0>; #end\n'
        scene = self.scene(colours + LENS.replace("rgb <0.9, 0.4, 0.1>", "rgb C"))
        self.batch("sweep", scene, "--set", 'Ball="red","dark green"', "--set", "Tilt=3", *SIZE)
        for name, text in (("red", "red"), ("dark green", "dark green")):
            whole = self.whole(scene, self.folder / "w.png", "+FN", *SIZE, f"Declare='Ball=\"{text}\"'", "Declare=Tilt=3")
            self.assert_same(self.folder / "scene_sweep" / f"scene_Ball={name}_Tilt=3.png", whole)
        for text in ('"a', '"a/b"', '""', '"it\'s"'):
            self.assertIn("in double quotation marks", self.batch("sweep", scene, "--set", f"Ball={text}", *SIZE, code=2), text)


if __name__ == "__main__":
    calls.main()

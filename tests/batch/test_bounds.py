# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Hanging units, crashing state files, changed pictures."""

import shlex

from tests.batch import calls
from tests.batch.calls import LENS, SETTINGS, BatchTest
from tests.waiting import PATIENCE

SIZE = ("+W48", "+H40", "+WT1")
LIMIT = 30  # seconds that a busy machine needs at most for a picture
PROBE_LIMIT = 10  # seconds for a first look, which hangs in any case


class Limits(BatchTest):
    def test_hanging_frame_is_ended_and_named(self):
        self.stand_in(f'case "$*" in *+SF2*) exec sleep 3600 ;; esac; exec {shlex.quote(SETTINGS.povray)} "$@"')
        said = self.batch("film", self.scene(LENS), "--frames", 3, "--limit", LIMIT, "--workers", 1, *SIZE, code=1)
        self.assertIn(f"'scene0002.png' rows [1, 40]: povray was ended after {LIMIT} s, as --limit says", said)
        self.assertIn("2 of 3 pictures", said)
        self.assert_nothing_runs(str(self.folder))

    def test_hanging_probe(self):
        self.stand_in(f'[ "$1" = --version ] || exec sleep 3600; exec {shlex.quote(SETTINGS.povray)} "$@"')
        said = self.batch("still", self.scene(LENS), "--limit", PROBE_LIMIT, *SIZE, code=1)
        self.assertRegex(said, "first look at the scene: [0-9]+ s so far; log: ")
        self.assertIn(f"was ended after {PROBE_LIMIT} s, as --limit says", said)
        self.assert_nothing_runs(str(self.folder))


class StateFiles(BatchTest):
    def test_state_file_that_crashes_povray_is_dropped(self):
        povray = shlex.quote(SETTINGS.povray)
        header = "POV-Ray Render State File".ljust(512, "x")
        self.stand_in(
            f"""case $PWD in */units/*)
            if [ -e picture.pov-state ]; then kill -SEGV $$; fi
            if mkdir ../first 2>/dev/null; then
                printf '{header}POVRAYMS\\0\\0\\0\\0\\0\\0\\0\\4RAWSabcd' > picture.pov-state
                kill -KILL $$
            fi ;;
            esac
            exec {povray} "$@\""""
        )
        scene = self.scene(LENS)
        self.batch("still", scene, "--bands", 1, *SIZE)
        log = (self.folder / "scene.png.batch" / "log" / "task-00000.log").read_text(errors="replace")
        self.assertIn("was ended by signal 11 on its state file, which is dropped", log)
        self.assertEqual(log.count("failed: povray"), 2, log)
        self.assert_same(self.folder / "scene.png", self.whole(scene, self.folder / "w.png", "+FN", *SIZE))


class Results(BatchTest):
    def test_each_failed_frame_with_its_own_log(self):
        scene = self.scene(LENS + '#if (frame_number > 1) #error concat("frame ", str(frame_number, 0, 0), " is broken") #end\n')
        said = self.batch("film", scene, "--frames", 3, "--workers", 1, *SIZE, code=1)
        self.assertEqual(len(self.records(self.folder / "scene_film.batch", "failed")), 2)
        second, third = said.split("failed: 'scene000")[1:3]
        self.assertIn("frame 2 is broken", second)
        self.assertNotIn("frame 3 is broken", second)
        self.assertIn("frame 3 is broken", third)

    def test_changed_picture_is_rendered_again(self):
        words = ("film", self.scene(LENS), "--frames", 2, *SIZE)
        self.batch(*words)
        picture = self.folder / "scene_film" / "scene0002.png"
        kept = picture.read_bytes()
        picture.write_bytes(kept[:-20] + b"x" * 20)
        self.batch(*words)
        self.assertEqual(calls.picture(picture)[:2], (48, 40))
        self.assertNotEqual(picture.read_bytes()[-20:], b"x" * 20)

    def test_two_batches_into_one_output(self):
        self.scene(LENS)
        words = ("film", "scene.pov", "--frames", 4, *SIZE, "Declare=Samples=600")
        process = self.start(*words)
        self.until("the lock", lambda: (self.folder / "scene_film" / ".batch.lock").exists())
        said = self.batch(*words, "--work", "other", code=1)
        self.assertIn(f"another batch writes to '{self.folder}", said.replace('"', "'"))
        self.assertIn("scene_film.batch", said)
        self.assertEqual(process.wait(timeout=PATIENCE), 0, self.said())
        self.assertFalse((self.folder / "scene_film" / ".batch.lock").exists())


if __name__ == "__main__":
    calls.main()

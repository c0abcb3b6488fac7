# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Many tiny pictures take as many POV-Rays as requested."""

import itertools
import shlex
import unittest.mock

from tests.batch import calls
from tests.batch.calls import SETTINGS, STOCK, BatchTest
from tools.batch import batch, slurm

WORKERS = 8


class Many(BatchTest):
    def test_two_hundred_pictures(self):
        scene = self.scene(STOCK + "#ifdef (N) sphere { <0, 2, 0>, N/200 pigment { rgb x } } #end\n")
        diary, work = self.folder / "diary", self.folder / "scene_sweep.batch"
        self.stand_in(
            f'echo 1 >> {shlex.quote(str(diary))}\n{shlex.quote(SETTINGS.povray)} "$@"\nstatus=$?\n'
            f"echo -1 >> {shlex.quote(str(diary))}\nexit $status"
        )
        words = ("sweep", scene, "--set", "N=1:200:1", "--workers", WORKERS, "+W16", "+H12", "-A")
        said = self.batch(*words)
        self.assertIn("200 of 200 pictures", said)
        self.assertEqual(len(list((self.folder / "scene_sweep").glob("scene_N=*.png"))), 200)
        at_once = list(itertools.accumulate(int(line) for line in diary.read_text().split()))
        self.assertGreaterEqual(len(at_once), 2 * 200)
        self.assertEqual(at_once[-1], 0, "every POV-Ray has ended by itself")
        self.assertGreater(max(at_once), 1)
        self.assertLessEqual(max(at_once), WORKERS)
        tasks = len(list((work / "log").glob("task-*.log")))
        self.assertLess(tasks, 100, "several pictures to a task")
        self.assertEqual(list((work / "units").glob("*/picture*")), [], "no parts are left")


class Tasks(calls.unittest.TestCase):
    def tasks(self, units, seconds, largest, engine=slurm):
        settings = calls.argparse.Namespace(workers=100, partition=None)
        description = {"estimate": {"picture": seconds, "start": 0.6}, "key": {"bands": [[1, 9]]}, "threads": 1}
        with unittest.mock.patch.object(slurm, "largest_array", lambda: largest):
            return batch.tasks_of(description, list(range(units)), settings, engine)

    def test_no_more_tasks_than_an_array_may_have(self):
        for units in (1, 10, 1001, 1002, 12345):
            tasks = self.tasks(units, 3600.0, 1001)
            self.assertLessEqual(len(tasks), 1001)
            self.assertEqual([unit for task in tasks for unit in task], list(range(units)))

    def test_long_units_go_alone_and_short_ones_together(self):
        self.assertEqual({len(task) for task in self.tasks(800, 60.0, 1001)}, {1})
        self.assertEqual({len(task) for task in self.tasks(3200, 0.0, 1001)}, {8})
        self.assertEqual(len(self.tasks(20, 0.0, 1001)), 20, "few units still go round")


if __name__ == "__main__":
    calls.main()

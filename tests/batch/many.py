# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Hundreds of tiny pictures: all are made, never more POV-Rays at once than asked for, several to a task;
and a cluster whose arrays may hold fewer tasks than there are pictures."""

import threading
import time
import unittest.mock

import common
from common import STOCK, BatchTest, processes

import batch
import slurm

WORKERS = 8


class Many(BatchTest):
    def watch(self, work, seen, stop):
        """Notes how many POV-Rays and workers run at once."""
        while not stop.is_set():
            found = [words for _, words in processes(str(work))]
            seen.append(
                (
                    sum("/bin/povray " in words and "setpriv" not in words for words in found),
                    sum(" task " in words and "setpriv" not in words for words in found),
                )
            )
            time.sleep(1)

    def test_two_hundred_pictures(self):
        scene = self.scene(STOCK + "#ifdef (N) sphere { <0, 2, 0>, N/200 pigment { rgb x } } #end\n")
        work, seen, stop = self.folder / "scene_sweep.batch", [], threading.Event()
        watcher = threading.Thread(target=self.watch, args=(work, seen, stop))
        watcher.start()
        try:
            words = ("sweep", scene, "--set", "N=1:200:1", "--workers", WORKERS, "+W16", "+H12", "-A")
            said = self.batch(*words, timeout=550)
        finally:
            stop.set()
            watcher.join()
        self.assertIn("200 of 200 pictures", said)
        self.assertEqual(len(list((self.folder / "scene_sweep").glob("scene_N=*.png"))), 200)
        self.assertGreater(max(povrays for povrays, _ in seen), 1)
        self.assertLessEqual(max(povrays for povrays, _ in seen), WORKERS)
        # a worker between fork and exec of its program is seen twice
        self.assertLessEqual(max(workers for _, workers in seen), WORKERS + 1)
        tasks = len(list((work / "log").glob("task-*.log")))
        self.assertLess(tasks, 100, "several pictures to a task")
        self.assertEqual(list((work / "units").glob("*/picture*")), [], "no parts are left")


class Tasks(common.unittest.TestCase):
    def tasks(self, units, seconds, largest, engine=slurm):
        settings = common.argparse.Namespace(workers=100, partition=None)
        description = {
            "estimate": {"picture": seconds, "start": 0.6},
            "key": {"bands": [[1, 9]]},
            "threads": 1,
        }
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
    common.main()

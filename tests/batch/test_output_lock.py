# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The lock beside the pictures, without POV-Ray."""

import pathlib
import tempfile
import time
import unittest
import unittest.mock

from tests.batch import calls
from tools.batch import describe, progress
from tools.batch.longer import Clock
from tools.batch.store import Work, output_lock, write_json


def none(_):
    return False


class OutputLock(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory(prefix="tilt_lens.")
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)
        self.lock = self.folder / ".a.png.lock"

    def taken_by(self, work, has_jobs=none):
        with output_lock(self.lock, work, has_jobs) as other:
            return other

    def test_call_holds_and_removes_the_lock(self):
        with output_lock(self.lock, "first", none) as other:
            self.assertIsNone(other)
            self.assertEqual(self.lock.read_text(), "first")
            self.assertEqual(self.taken_by("second"), "first")
            self.assertEqual(self.taken_by("first"), "first", "two calls of one batch")
        self.assertFalse(self.lock.exists())

    def test_it_stays_while_there_are_jobs(self):
        jobs = {"first"}
        self.assertIsNone(self.taken_by("first", jobs.__contains__))
        self.assertEqual(self.lock.read_text(), "first")
        self.assertEqual(self.taken_by("second", jobs.__contains__), "first")
        self.assertIsNone(self.taken_by("first", jobs.__contains__), "the same batch again")
        self.assertEqual(self.lock.read_text(), "first")
        jobs.clear()
        self.assertIsNone(self.taken_by("second", jobs.__contains__))
        self.assertFalse(self.lock.exists())

    def test_the_last_job_removes_its_own(self):
        description = {"key": {"kind": "still", "pictures": [{"name": "a.png"}]}, "output": str(self.folder)}
        own = Work(self.folder / "own")
        for owner, stays in ((str(own.folder), False), ("other", True)):
            self.lock.write_text(owner)
            describe.leave_output(own, description)
            self.assertEqual(self.lock.exists(), stays, owner)
        self.assertEqual(self.lock.read_text(), "other")
        self.lock.write_text(str(own.folder))
        with output_lock(self.lock, own.folder, none):
            describe.leave_output(own, description)
            self.assertTrue(self.lock.exists(), "a call that waits removes it itself")


class TimeLeft(unittest.TestCase):
    def test_of_one_long_picture(self):
        clocks = unittest.mock.patch.multiple(time, monotonic=lambda: 1000.0, time=lambda: 5000.0)
        with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name, clocks:
            work = Work(pathlib.Path(name))
            work.make()
            key = {"bands": [[1, 9]], "pictures": [{"name": "a.png", "label": "a"}]}
            line = progress.Progress(work, {"key": key}, quiet=True)
            line.begun -= 100
            log = work.log(0)
            write_json(work.record("running", "00000.0000"), {"since": time.time() - 100, "log": str(log), "begins": 0})
            log.write_text("Rendered 0 of 9 pixels (0% of the work)\r")
            self.assertNotIn("left", line.text())
            log.write_text("Rendered 1 of 9 pixels (25% of the work)\r")
            self.assertIn("0 of 1 pictures done, 1 running, 0 failed, 5 min left", line.text())


class Clocks(unittest.TestCase):
    def test_as_pov_ray_computes_them(self):
        self.assertEqual([Clock(["+W3"], 3).of(n) for n in (1, 2, 3)], [0.0, 0.5, 1.0])
        self.assertEqual([Clock(["+KI1", "Final_Clock=7"], 4).of(n) for n in (1, 2, 3, 4)], [1.0, 3.0, 5.0, 7.0])
        self.assertEqual(Clock([], 4).of(2), 0.3333333432674408)

    def test_what_cannot_be_known(self):
        for words in (["+KC"], ["Cyclic_Animation=on"], ["+KFa"], ["Final_Clock="]):
            self.assertFalse(Clock(words, 3).known, words)
        self.assertTrue(Clock(["+KI0", "+KF2"], 3).known)


if __name__ == "__main__":
    calls.main()

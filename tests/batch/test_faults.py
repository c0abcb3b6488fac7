# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""After a fault, a second call finishes the picture."""

import os
import pathlib
import resource
import shlex
import signal
import subprocess
import sys

from tests.batch import calls
from tests.batch.calls import LENS, SLOW, BatchTest, processes
from tests.waiting import PATIENCE


class Killed(BatchTest):
    def begin(self, *more):
        self.scene(LENS)
        process = self.start("still", "scene.pov", "--bands", 4, "--workers", 2, *SLOW, *more)
        self.work = self.folder / "scene.png.batch"
        working = self.until("a band to be half done", lambda: self.working_povrays(self.work))
        return process, working

    def finished(self, process, code=0):
        self.assertEqual(process.wait(timeout=PATIENCE), code, self.said() + self.evidence())

    def compare(self):
        self.assert_same(self.folder / "scene.png", self.whole(self.folder / "scene.pov", self.folder / "w.png", "+FN", *SLOW))

    def logs(self):
        return "".join(path.read_text(errors="replace") for path in (self.work / "log").glob("task-*"))

    def test_povray_then_worker_killed(self):
        process, working = self.begin()
        os.kill(working[0], signal.SIGKILL)
        self.until("the worker's word of it", lambda: "was ended by signal 9" in self.logs())
        self.until("a band to be half done", lambda: self.working_povrays(self.work))
        worker = next(pid for pid, words in processes(f"task {self.work}") if "setpriv" not in words and pid != process.pid)
        os.kill(worker, signal.SIGKILL)
        self.finished(process)
        self.assertIn("continued from", self.logs(), self.evidence())
        self.compare()

    def test_everything_stops_at_once_and_goes_on(self):
        ways = [
            ("Ctrl-C", lambda p: os.killpg(p.pid, signal.SIGINT), 130),
            ("kill -9 of the command", lambda p: p.send_signal(signal.SIGKILL), -9),
            ("SIGTERM", lambda p: p.send_signal(signal.SIGTERM), 143),
        ]
        for name, end, code in ways:
            with self.subTest(name):
                process, _ = self.begin()
                end(process)
                self.finished(process, code)
                self.assert_nothing_runs(str(self.work))
        self.assertIn("another call", self.beside())
        self.batch("still", "scene.pov", "--bands", 4, *SLOW)
        self.assertIn("continued from", self.logs(), self.evidence())
        self.compare()

    def beside(self):
        process, _ = self.begin()
        said = self.batch("still", "scene.pov", "--bands", 4, *SLOW, code=1)
        process.send_signal(signal.SIGINT)
        self.finished(process, 130)
        return said

    def test_oiiotool_ends_with_who_runs_it(self):
        tools = self.folder / "tools"
        tools.mkdir()
        (tools / "oiiotool").write_text("#!/bin/sh\nexec sleep 1000\n")
        (tools / "oiiotool").chmod(0o755)
        env = {**self.env, "PATH": f"{tools}:{self.env['PATH']}", "PYTHONPATH": str(calls.ROOT)}
        for call in ("merge.oiiotool(sys.argv[1], [])", "povray.image_info(pathlib.Path(sys.argv[1], 'a.png'))"):
            with self.subTest(call):
                program = f"import pathlib, sys; from tools.batch import merge, povray; {call}"
                with subprocess.Popen([sys.executable, "-c", program, str(self.folder)], env=env, cwd="/") as process:
                    self.until("oiiotool", lambda: [pid for pid, words in processes(str(self.folder)) if words.startswith("sleep")])
                    process.kill()
                self.until("the end of oiiotool", lambda: not processes(str(self.folder)))

    def test_parallel_killed(self):
        process, _ = self.begin()
        parallel = next(pid for pid, words in processes("perl /usr/bin/parallel") if f"{self.work}" in environ(pid))
        os.kill(parallel, signal.SIGKILL)
        self.finished(process)
        self.compare()


def environ(pid):
    try:
        return pathlib.Path(f"/proc/{pid}/environ").read_bytes().decode(errors="replace")
    except OSError:
        return ""


class Failing(BatchTest):
    def test_a_frame_with_an_error_is_named_and_the_others_are_made(self):
        scene = self.scene(LENS + '#if (frame_number = 2) #error "second frame is broken" #end\n')
        said = self.batch("film", scene, "--frames", 3, "+W48", "+H40", code=1)
        for text in (
            "'scene0002.png'",
            "second frame is broken",
            "2 of 3 pictures",
            "2 of 3 pictures done, 0 running, 1 failed",
            "NOT complete",
            "task-",
        ):
            self.assertIn(text, said)
        self.assertEqual(sorted(os.listdir(self.folder / "scene_film")), ["scene0001.png", "scene0003.png"])

    def test_tries_are_bounded(self):
        self.stand_in(f'case $PWD in */units/*) kill -9 $$ ;; esac\nexec {shlex.quote(calls.SETTINGS.povray)} "$@"')
        words = ("still", self.scene(LENS), "--bands", 1, "--retries", 2, "+W48", "+H40")
        self.assertIn("was ended by signal 9", self.batch(*words, code=1))
        log = (self.folder / "scene.png.batch" / "log" / "task-00000.log").read_text()
        self.assertEqual(log.count("failed: povray was ended"), 3)

    def test_no_room_to_write(self):
        scene = self.scene(LENS)

        def little_room():
            # 40 KB per file: the records fit, a band's state file does not
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (40000, 40000))

        self.batch("still", scene, "--bands", 2, "--retries", 1, "+FN16", "+W160", "+H120", code=1, preexec_fn=little_room)
        self.assertFalse((self.folder / "scene.png").exists())
        self.batch("still", scene, "--bands", 2, "+FN16", "+W160", "+H120")
        self.assert_same(self.folder / "scene.png", self.whole(scene, self.folder / "w.png", "+FN16", "+W160", "+H120"))


if __name__ == "__main__":
    calls.main()

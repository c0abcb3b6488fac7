# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Pictures from a private Slurm cluster equal single renders."""

import os
import signal
import subprocess
import sys
import tempfile

from tests.batch import calls
from tests.batch.calls import LENS, SETTINGS, SLOW, BatchTest, picture, processes
from tests.waiting import PATIENCE
from tools.cluster import Cluster, environment_of
from tools.repository import module_command

SMALL = ("+W48", "+H40", "+WT1", "Output_Layers=on")
SLOWER = (*SLOW[:2], "Declare=Samples=800", "Output_Layers=on")  # so that a band on each node is half done at one time


class OnSlurm(BatchTest):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory(prefix="slurm.")
        cls.addClassCleanup(folder.cleanup)
        cls.cluster = Cluster(folder.name)
        cls.enterClassContext(cls.cluster)

    def setUp(self):
        super().setUp()
        self.env = dict(self.cluster.env, HOME=str(self.folder))
        for node in self.cluster.nodes:
            if node not in self.cluster.processes:
                self.cluster.start_node(node)
        self.cluster.until("all nodes", lambda: len(self.cluster.run("sinfo", "-hN", "-t", "idle", "-o", "%N").stdout.split()) == 3)

    def kinds(self):
        return {
            "still": ("still", "scene.pov", "--bands", 2, *SMALL),
            "film": ("film", "scene.pov", "--frames", 4, *SMALL),
            "sweep": ("sweep", "scene.pov", "--set", "Tilt=2,4", *SMALL),
        }

    def test_same_pictures_as_locally(self):
        scene = self.scene(LENS)
        for kind, words in self.kinds().items():
            with self.subTest(kind):
                self.batch(*words, "--on", "slurm", "--partition", "main", "--time", "10", "--sbatch=--mem=100")
        whole = self.whole(scene, self.folder / "w.png", "+FN", *SMALL)
        self.assert_same_with_layers(self.folder / "scene.png", whole)
        self.compare_film_and_sweep()
        (self.folder / "scene_film" / "scene0003.png").unlink()
        self.batch(*self.kinds()["film"])
        self.assert_same(self.folder / "scene_film" / "scene0003.png", self.folder / "whole" / "f3.png")

    def compare_film_and_sweep(self):
        scene = self.folder / "scene.pov"
        for tilt in (2, 4):
            whole = self.whole(scene, self.folder / "w.png", "+FN", *SMALL, f"Declare=Tilt={tilt}")
            self.assert_same_with_layers(self.folder / "scene_sweep" / f"scene_Tilt={tilt}.png", whole)
        self.assertTrue((self.folder / "scene_sweep" / "scene_sheet.png").exists())
        self.whole(scene, self.folder / "f.png", "+FN", *SMALL, "+KFI1", "+KFF4")
        for n in range(1, 5):
            self.assert_same_with_layers(self.folder / "scene_film" / f"scene000{n}.png", self.folder / "whole" / f"f{n}.png")

    def assert_same_with_layers(self, path, whole):
        self.assert_same(path, whole)
        layers, wanted = (name.with_name(f"{name.stem}.layers.exr") for name in (path, whole))
        self.assertEqual(picture(layers), picture(wanted))

    def test_detached_then_watched(self):
        self.scene(LENS)
        words = ("still", "scene.pov", "--bands", 4, *SLOW)
        site = ("--partition", "main", "--time", "17", "--account", "film42", "--sbatch=--nice=5")
        said = self.batch(*words, "--on", "slurm", "--detach", "--workers", 2, *site)
        self.assertIn("Not waiting", said)
        array = calls.json.loads((self.folder / "scene.png.batch" / "jobs.json").read_text())[0]
        told = self.cluster.run("scontrol", "show", "job", array).stdout.split()
        for option in ("Partition=main", "TimeLimit=00:17:00", "Account=film42", "Nice=5"):
            self.assertIn(option, told)
        self.assertIn("ArrayTaskThrottle=2", told)
        self.assertIn("of an earlier call are at work", self.batch(*words, code=1))
        lock = self.folder / ".scene.png.lock"
        self.assertEqual(lock.read_text(), str(self.folder / "scene.png.batch"))
        said = self.batch(*words, "--work", "other", code=1)
        self.assertIn("another batch writes to", said)
        self.assertIn("scene.png.batch", said)
        self.assertIn("still at work: waiting", self.batch(*words, "--on", "slurm"))
        self.assert_same(self.folder / "scene.png", self.whole(self.folder / "scene.pov", self.folder / "w.png", "+FN", *SLOW))
        self.assertFalse(lock.exists())

    def test_the_last_job_removes_the_lock(self):
        self.scene(LENS)
        words = ("still", "scene.pov", "--bands", 2, *SMALL, "--on", "slurm")
        self.batch(*words, "--detach")
        self.until("the jobs", lambda: not self.cluster.run("squeue", "--noheader").stdout)
        self.assertTrue((self.folder / "scene.png").exists())
        self.assertFalse((self.folder / ".scene.png.lock").exists())

    def test_cancelled_jobs_are_not_submitted_again(self):
        self.scene(LENS)
        words = ("still", "scene.pov", "--bands", 4, "--on", "slurm", *SLOW, "Declare=Samples=4000")
        self.batch(*words, "--detach")
        process = self.start(*words)
        self.until("the second call", lambda: "still at work: waiting" in self.said())
        process.send_signal(signal.SIGINT)
        self.assertEqual(process.wait(timeout=PATIENCE), 130)
        jobs = calls.json.loads((self.folder / "scene.png.batch" / "jobs.json").read_text())
        self.assertIn(f"To end them: scancel {' '.join(jobs)}", self.said())
        process = self.start(*words)
        self.until("the third call", lambda: "still at work: waiting" in self.said())
        self.cluster.run("scancel", *jobs)
        self.assertEqual(process.wait(timeout=PATIENCE), 1, self.said())
        self.assertIn("were cancelled", self.said())
        self.assertEqual(self.cluster.run("squeue", "--noheader").stdout, "")

    def test_faults(self):
        self.scene(LENS)
        process = self.start("still", "scene.pov", "--bands", 5, "--on", "slurm", *SLOWER)
        work = self.folder / "scene.png.batch"
        place = {}

        def all_at_work():
            place.clear()
            place.update({node_of(pid): pid for pid in self.working_povrays(work)})
            return set(place) == set(self.cluster.nodes)

        self.until("a half done band on each node", all_at_work)
        self.assertIn(place["n3"], self.cluster.kill_node("n3"))
        os.kill(place["n1"], signal.SIGKILL)
        shells = [pid for pid, words in processes(f" task {work}") if node_of(pid) == "n2" and "setpriv" not in words]
        self.assertTrue(shells, "the task's shell, which has become the worker")
        os.kill(shells[0], signal.SIGKILL)
        for kind, words in self.kinds().items():
            if kind != "still":
                self.batch(*words, "--on", "slurm")
        self.assertEqual(process.wait(timeout=PATIENCE), 0, self.said() + self.evidence())
        log = "".join(path.read_text(errors="replace") for path in (work / "log").glob("task-*"))
        self.assertIn("continued from", log)
        self.assertIn("was ended by signal 9", log)
        whole = self.whole(self.folder / "scene.pov", self.folder / "w.png", "+FN", *SLOWER)
        self.assert_same_with_layers(self.folder / "scene.png", whole)
        self.compare_film_and_sweep()

    def test_anything_in_names(self):
        for name in ("a %a\n%j $(x) \"'", "back\\slash %a"):
            with self.subTest(name):
                (self.folder / name).mkdir()
                scene = self.scene(LENS, f"{name}/scene.pov")
                target = self.folder / name / "out.png"
                self.batch("still", scene, "--bands", 2, "--output", target, "--on", "slurm", *SMALL)
                self.assert_same(target, self.whole(scene, self.folder / "w.png", "+FN", *SMALL))
                self.assertTrue(list((self.folder / name / "out.png.batch" / "log").glob("slurm*")))


def node_of(pid):
    for entry in environment_of(pid):
        if entry.startswith(b"SLURMD_NODENAME="):
            return entry.split(b"=")[1].decode()
    return None


def main():
    """The cluster must work without root."""
    rest = calls.read_settings()
    user = ["setpriv", "--reuid=65534", "--regid=65534", "--clear-groups", "--pdeathsig=KILL"]
    program = module_command("tests.batch.test_on_slurm", "--povray", SETTINGS.povray)
    if os.getuid() != 0 or not can_run([*user, *program, "--help"], [*user, SETTINGS.povray, "--version"]):
        calls.main()
    with tempfile.TemporaryDirectory(prefix="home.") as home:
        os.chown(home, 65534, 65534)
        os.chmod(home, 0o755)  # munge requires that its socket be reachable by all
        env = dict(os.environ, HOME=home, TMPDIR=home)
        done = subprocess.run([*user, *program, *rest], cwd=home, check=False, env=env)
    sys.exit(done.returncode)


def can_run(*commands):
    return all(subprocess.run(command, cwd="/", capture_output=True, check=False).returncode == 0 for command in commands)


if __name__ == "__main__":
    main()

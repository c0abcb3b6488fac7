# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later

import argparse
import contextlib
import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import unittest

from tests.waiting import WaitingTest
from tools import povray_run
from tools.batch.povray import image_info
from tools.repository import ROOT

SETTINGS = argparse.Namespace(povray=None)

LENS = """#version 3.7;
global_settings { assumed_gamma 1 }
#ifndef (Tilt) #declare Tilt = 4; #end
#ifndef (Samples) #declare Samples = 16; #end
camera { location <0, 3, -6> look_at <0, 0, 1> angle 50 right x*image_width/image_height
  tilt_lens { tilt Tilt f_stop 1 scene_unit 20 } blur_samples Samples, Samples variance 0 }
light_source { <-4, 9, -5>, rgb 1 }
sky_sphere { pigment { gradient y color_map { [0 rgb 0.7] [1 rgb <0.1, 0.2, 0.5>] } } }
plane { y, -1 pigment { checker rgb 0.9, rgb <0.1, 0.3, 0.7> } }
sphere { <2*clock - 1, 0, 0>, 1 pigment { rgb <0.9, 0.4, 0.1> } finish { phong 0.6 } }
"""

# exact if bands are cut between POV-Ray's blocks
STOCK = """#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -6> look_at <0, 0, 1> angle 50 right x*image_width/image_height }
light_source { <-4, 9, -5>, rgb 1 }
plane { y, -1 pigment { checker rgb 0.9, rgb <0.1, 0.3, 0.7> } }
sphere { 0, 1 pigment { rgbt <0.9, 0.4, 0.1, 0.3> } }
"""

# two seconds of one core per band
SLOW = ("+W192", "+H128", "Declare=Samples=400")


def processes(text):
    found = []
    for name in filter(str.isdigit, os.listdir("/proc")):
        with contextlib.suppress(OSError):
            words = pathlib.Path(f"/proc/{name}/cmdline").read_bytes().replace(b"\0", b" ").decode(errors="replace")
            place = os.readlink(f"/proc/{name}/cwd")
            if (text in words or text in place) and words and int(name) != os.getpid():
                found.append((int(name), words))
    return found


def picture(path):
    info = image_info(pathlib.Path(path))
    return *info["size"], info["form"], info["pixels"]


class BatchTest(WaitingTest):
    """Its folder's name contains a space and a quotation mark."""

    longMessage = True

    def setUp(self):
        scratch = tempfile.TemporaryDirectory(prefix="tilt lens' ")
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)
        self.env = povray_run.user_environment()
        self.env.pop("PARALLEL", None)
        self.program = SETTINGS.povray

    def scene(self, text, name="scene.pov"):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
        return path

    def words(self, *words):
        return [str(ROOT / "batch"), *map(str, words), "--povray", str(self.program)]

    def stand_in(self, script):
        prefix = self.folder / "stand-in"
        (prefix / "bin").mkdir(parents=True)
        for folder in ("etc", "share"):
            (prefix / folder).symlink_to(pathlib.Path(SETTINGS.povray).parent.parent / folder)
        self.program = prefix / "bin" / "povray"
        self.program.write_text(f"#!/bin/bash\n{script}\n")
        self.program.chmod(0o755)

    def batch(self, *words, code=0, before=(), **how):
        done = povray_run.run([*before, *self.words(*words)], self.folder, self.env, **how)
        self.assertEqual(done.code, code, f"{done.told()}\n{self.evidence()}")
        return done.said

    def start(self, *words):
        log = open(self.folder / "said", "wb")
        self.addCleanup(log.close)
        process = subprocess.Popen(
            self.words(*words),
            cwd=self.folder,
            env=self.env,
            stdin=subprocess.DEVNULL,
            stdout=log,
            stderr=subprocess.STDOUT,
            start_new_session=True,
        )
        self.addCleanup(self.end, process)
        return process

    def end(self, process):
        if process.poll() is None:
            process.send_signal(signal.SIGKILL)
            process.wait()

    def said(self):
        return (self.folder / "said").read_text(errors="replace")

    def evidence(self):
        parts = []
        for path in sorted(self.folder.rglob("*.batch/log/*")):
            parts.append(f"== {path.name}\n{path.read_text(errors='replace')[-1500:]}")
        return "\n".join(parts[-4:])

    def working_povrays(self, work):
        """POV-Rays that have written part of a unit."""
        found = []
        for pid, words in processes("/bin/povray"):
            with contextlib.suppress(OSError):
                place = pathlib.Path(os.readlink(f"/proc/{pid}/cwd"))
                states = list(place.glob("*.pov-state"))
                if place.parent == work / "units" and "setpriv" not in words and states and states[0].stat().st_size > 30000:
                    found.append(pid)
        return found

    def rendered(self, scene, picture, *options, folder):
        command = povray_run.command(SETTINGS.povray, scene, picture, (64, 64), *options)
        povray_run.run(command, folder, self.env).succeeded()
        return folder / picture

    def whole(self, scene, target, *words):
        folder = target.parent / "whole"
        folder.mkdir(exist_ok=True)
        shutil.copy(scene, folder / "scene.pov")
        return self.rendered("scene.pov", target.name, *words, folder=folder)

    def assert_same(self, path, whole):
        self.assertEqual(picture(path), picture(whole), str(path))
        self.assertGreater(self.spread(whole), 0.05, "an empty picture shows nothing")

    @staticmethod
    def spread(path):
        done = subprocess.run(["oiiotool", str(path), "--printstats"], capture_output=True, text=True, check=True)
        return max(float(n) for n in re.search(r"Stats StdDev: ([0-9. ]+)", done.stdout).group(1).split())

    def records(self, work, state):
        return {path.stem: json.loads(path.read_text()) for path in (work / state).glob("*.json")}

    def assert_nothing_runs(self, text):
        self.until("all processes to end", lambda: not [p for p, _ in processes(text)])


def read_settings():
    arguments = argparse.ArgumentParser(add_help=False)
    arguments.add_argument("--povray", required=True)
    _, rest = arguments.parse_known_args(namespace=SETTINGS)
    SETTINGS.povray = os.path.abspath(SETTINGS.povray)
    return rest


def main():
    unittest.main(module="__main__", argv=[sys.argv[0], *read_settings()])

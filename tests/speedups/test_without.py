# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The build without speedups passes the groups `render` and `oracle`, and has the same pictures of scenes without objects at equal depth.

usage: test_without.py SOURCE DOWNLOADS TARBALL POVRAY COMPARE
"""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

from tools import povray_run

SETTINGS = {}
TARGETS = ("povray", "compare", "oracle", "oracle_test", "message_order_test", "refocus")
SCENES = (
    *("benchmarks/scenes/town.pov", "benchmarks/scenes/foliage.pov", "benchmarks/scenes/glass.pov", "benchmarks/scenes/lights.pov"),
    *("benchmarks/scenes/landscape.pov", "benchmarks/scenes/interior.pov", "benchmarks/scenes/shadows.pov"),
    *("scenes/tutorial/tilt.pov", "scenes/gallery/miniature_town.pov"),
)


def run(*command, folder=None):
    done = subprocess.run(command, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace", check=False)
    return done.returncode, done.stdout


class WithoutSpeedups(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.source = pathlib.Path(SETTINGS["source"])
        cls.build = cls.source / "build" / "without-speedups"
        downloads = f"-DTILT_LENS_DOWNLOADS={SETTINGS['downloads']}"
        configured = (
            "cmake",
            "--preset",
            "without-speedups",
            "-S",
            cls.source,
            downloads,
            f"-DPOVRAY_TARBALL={SETTINGS['tarball'].removeprefix('TARBALL=')}",
        )
        for command in configured, ("ninja", "-C", cls.build, *TARGETS):
            code, said = run(*command)
            if code != 0:
                raise RuntimeError(f"{command}: {said[-4000:]}")

    def test_groups(self):
        for group in "render", "oracle":
            with self.subTest(group):
                choice = ("-L", f"^{group}$", "-LE", "^slow$")
                listed = run("ctest", "-N", *choice, folder=self.build)[1]
                self.assertGreater(int(listed.split("Total Tests:")[1]), 20, listed[-1000:])
                code, said = run("ctest", *choice, "--output-on-failure", f"-j{os.cpu_count()}", folder=self.build)
                self.assertEqual(code, 0, said[-8000:])

    def test_pictures(self):
        for scene in SCENES:
            with self.subTest(scene):
                self.assertTrue(self.pixels(SETTINGS["povray"], scene) == self.pixels(self.build / "bin" / "povray", scene))

    def pixels(self, povray, scene):
        with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
            picture = pathlib.Path(name, "picture.png")
            povray_run.run(povray_run.command(povray, self.source / scene, picture, (96, 54)), name).succeeded()
            return povray_run.pixels(SETTINGS["compare"], picture)


if __name__ == "__main__":
    SETTINGS.update(zip(("source", "downloads", "tarball", "povray", "compare"), sys.argv[1:6]))
    unittest.main(argv=sys.argv[:1])

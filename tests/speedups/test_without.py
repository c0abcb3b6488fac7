# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The build without speedups passes the groups `render` and `oracle`, and has the same pictures, but for shadows that stock's
meshes lose.

usage: test_without.py SOURCE DOWNLOADS TARBALL POVRAY COMPARE
"""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

from tests.render import rendering
from tools import povray_run

SETTINGS = {}
TARGETS = ("povray", "compare", "oracle", "oracle_test", "message_order_test", "refocus")
SAME = (
    *("benchmarks/scenes/town.pov", "benchmarks/scenes/glass.pov", "benchmarks/scenes/lights.pov", "benchmarks/scenes/landscape.pov"),
    *("benchmarks/scenes/interior.pov", "benchmarks/scenes/shadows.pov", "scenes/tutorial/tilt.pov"),
)
# meshes that touch themselves; RMSE seen 0.0002 and 0.0007: of 1,440,000 rays of the foliage, 14 lose their shadow
LOST_SHADOWS = ("benchmarks/scenes/foliage.pov", "scenes/gallery/miniature_town.pov")
MOST_RMSE = 0.002


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

    def test_same_pictures(self):
        for scene in SAME:
            with self.subTest(scene):
                self.assertEqual(self.difference(scene), (0.0, 0.0))

    def test_lost_shadows(self):
        for scene in LOST_SHADOWS:
            with self.subTest(scene):
                self.assertLess(self.difference(scene)[0], MOST_RMSE)

    def difference(self, scene):
        """RMSE and greatest difference of the builds' pictures."""
        return rendering.difference(*(self.picture(program, scene) for program in (SETTINGS["povray"], self.build / "bin" / "povray")))

    def picture(self, povray, scene):
        path = self.source / scene
        libraries = (path.parent, povray_run.INCLUDE)
        with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
            picture = pathlib.Path(name, "picture.png")
            # radiosity gives the same picture with one thread alone
            command = povray_run.command(povray, path, picture, (96, 54), "+FN16", "+WT1", library=libraries)
            povray_run.run(command, name).succeeded()
            return rendering.read_picture(picture, "")


if __name__ == "__main__":
    SETTINGS.update(zip(("source", "downloads", "tarball", "povray", "compare"), sys.argv[1:6]))
    rendering.SETTINGS.compare = SETTINGS["compare"]
    unittest.main(argv=sys.argv[:1])

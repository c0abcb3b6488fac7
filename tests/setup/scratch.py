# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later

import os
import pathlib
import subprocess
import tempfile
import unittest

from tools.povray_run import PATIENCE, user_environment

REPOSITORY = pathlib.Path(os.environ["REPOSITORY"])
BUILD = pathlib.Path(os.environ["BUILD"])
CMAKE = os.environ["CMAKE"]
POVRAY = BUILD / "bin" / "povray"

SCENE = """#include "colors.inc"
camera { location <0, 0, -5> look_at 0 }
light_source { <-5, 5, -5> White }
sphere { 0, 1 pigment { Red } }
text { ttf "timrom.ttf" "x" 0.1, 0 pigment { Blue } }
"""


class SetupTest(unittest.TestCase):
    """Its folder's name contains a space."""

    def setUp(self):
        scratch = tempfile.TemporaryDirectory(prefix="tilt lens ")
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)

    def run_command(self, *command, cwd=None, env=None):
        return subprocess.run(
            [str(word) for word in command],
            cwd=cwd or self.folder,
            timeout=PATIENCE,
            env=user_environment(**(env or {})),
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
            errors="replace",
            check=False,
        )

    def assert_succeeds(self, process):
        self.assertEqual(process.returncode, 0, f"{process.args}\n{process.stdout}\n{process.stderr}")

    def assert_fails_saying(self, process, *texts):
        said = " ".join((process.stdout + process.stderr).split())
        self.assertNotEqual(process.returncode, 0, f"{process.args}\n{said}")
        for text in texts:
            self.assertIn(text, said)

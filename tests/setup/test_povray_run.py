# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Users' settings do not reach a render; a hanging run ends."""

import os
import re
import unittest
import unittest.mock

from tests.setup.scratch import POVRAY, REPOSITORY, SetupTest
from tools import povray_run

COMMAND_LINE = re.compile(r"[\"']\+I\w|[\"']\+I\{|POVINI|#include\\s|POVRAYMS")
# the module, users' settings, and tests of both
MAY = (
    "tools/povray_run.py",
    "tools/batch/",
    "tests/batch/test_names.py",
    "tests/batch/test_units.py",
    "tests/batch/test_bounds.py",
    "tests/render/test_unreadable.py",
    "tests/setup/",
)
SCENE = 'camera { location -3*z look_at 0 } sphere { 0, 1 pigment { rgb 1 } }\n#debug concat("SIZE ", str(image_width, 0, 0), "\\n")\n'


class Runs(SetupTest):
    def render(self, name="scene.pov", *options, env=None, folder=None):
        (self.folder / name).write_text(f"#version 3.7;\n{SCENE}")
        command = povray_run.command(POVRAY, name, "picture.png", (8, 6), "All_Console=on", *options)
        return povray_run.run(command, folder or self.folder, env)

    def test_user_settings_change_nothing(self):
        for name in ("user.ini", "povray.ini"):
            (self.folder / name).write_text("Width=16\nOutput_File_Type=J\n+W16\nInput_File_Name=none.pov\nFinal_Frame=3\n")
        with unittest.mock.patch.dict(os.environ, {"POVINI": str(self.folder / "user.ini"), "DISPLAY": ":77"}):
            done = self.render().succeeded()
        self.assertIn("SIZE 8", done.said)
        self.assertEqual([path.name for path in self.folder.glob("picture*")], ["picture.png"])

    def test_the_last_option_counts(self):
        self.assertIn("SIZE 12", self.render("scene.pov", "+W12").succeeded().said)

    def test_names_are_quoted(self):
        for name in ("a b.pov", "it's.pov", "a;b.pov", 'a"b.pov'):
            with self.subTest(name):
                self.render(name).succeeded()

    def test_failure_says_why(self):
        done = self.render("scene.pov", "Declare=Nothing")
        with self.assertRaises(povray_run.Failed) as caught:
            done.succeeded()
        for words in ("+W8", "exit code 1", "Declare takes NAME=NUMBER"):
            self.assertIn(words, str(caught.exception))

    def test_a_run_that_hangs_ends(self):
        done = povray_run.run(["sh", "-c", "echo waiting; exec sleep 10000"], limit=0.5)
        self.assertIsNone(done.code)
        self.assertIn("no end after", done.told())

    def test_an_interrupted_caller_leaves_nothing_running(self):
        with unittest.mock.patch("os.wait4", side_effect=KeyboardInterrupt), unittest.mock.patch("subprocess.Popen.kill") as kill:
            with self.assertRaises(KeyboardInterrupt):
                povray_run.run(["true"])
        kill.assert_called_once()

    def test_a_signal_is_told(self):
        done = povray_run.run(["sh", "-c", "kill -SEGV $$"])
        self.assertEqual(done.code, -11)
        self.assertIn("signal 11", done.told())


class Sources(SetupTest):
    def test_include_files(self):
        """Its own folder's first, each once, also in circles."""
        other = self.folder / "other"
        other.mkdir()
        for path, text in (
            (self.folder / "scene.pov", '#include "a.inc"\n  #include  "colors.inc"\n'),
            (self.folder / "a.inc", '#include "b.inc"\n#include "c.inc"\n'),
            (other / "a.inc", "wrong"),
            (other / "b.inc", '#include "a.inc"\n#include "c.inc"'),
            (other / "c.inc", ""),
        ):
            path.write_text(text)
        found = [str(path.relative_to(self.folder)) for path in povray_run.sources(self.folder / "scene.pov", [other])]
        self.assertEqual(found, ["scene.pov", "a.inc", "other/b.inc", "other/c.inc"])


class OneModule(unittest.TestCase):
    def test_no_other_file_says_it_again(self):
        found = []
        for package in ("tools", "benchmarks", "experiments", "tests"):
            for path in sorted((REPOSITORY / package).rglob("*.py")):
                name = str(path.relative_to(REPOSITORY))
                if not name.startswith(MAY):
                    found += [f"{name}: {line.strip()}" for line in path.read_text().splitlines() if COMMAND_LINE.search(line)]
        self.assertEqual(found, [])


if __name__ == "__main__":
    unittest.main()

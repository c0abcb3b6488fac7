# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""As pyproject.toml says: test_format PART, one of PARTS."""

import re
import shutil
import sys
import tomllib
import unittest

from tests.setup.scratch import REPOSITORY, SetupTest

PARTS = 3
SETTINGS = REPOSITORY / "pyproject.toml"
UGLY = "def f( a,b ):\n    return {'a':a ,\n 'b' : b}\n"


def python_files():
    packages = [path.parent for path in REPOSITORY.glob("*/__init__.py")]
    return sorted([*REPOSITORY.glob("*.py"), *(path for package in packages for path in package.rglob("*.py"))])


class Format(SetupTest):
    part = 0

    def setUp(self):
        super().setUp()
        wanted = tomllib.loads(SETTINGS.read_text())["tool"]["black"]["required-version"]
        if not shutil.which("black"):
            self.skipTest("black is not installed")
        found = re.search(r"\d+", self.run_command("black", "--version").stdout)[0]
        if found != wanted:
            self.skipTest(f"black {found} is installed, not {wanted}")

    def black(self, *words):
        """Black's cache is empty."""
        return self.run_command("black", "--config", SETTINGS, *words, env={"BLACK_CACHE_DIR": str(self.folder)})

    def test_files(self):
        files = python_files()[self.part :: PARTS]
        self.assertGreater(len(files), 50)
        checked = self.black("--check", *files)
        self.assertEqual(checked.returncode, 0, f'{checked.stderr}\nIn the repository\'s folder, "black ." formats them.')

    def test_ugly_file_is_found(self):
        (self.folder / "ugly.py").write_text(UGLY)
        self.assert_fails_saying(self.black("--check", self.folder / "ugly.py"), "would reformat")


if __name__ == "__main__":
    Format.part = int(sys.argv.pop(1))
    unittest.main()

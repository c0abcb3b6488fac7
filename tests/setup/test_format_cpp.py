# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
import re
import shutil
import unittest

from tests.setup.scratch import REPOSITORY, SetupTest

SETTINGS = REPOSITORY / ".clang-format"
FOLDERS = ("povray-src", "benchmarks", "experiments", "tests", "tools")
UGLY = "int F( int a ){ return a ; }\n"


class FormatCpp(SetupTest):
    def setUp(self):
        super().setUp()
        self.wanted = re.search(r"clang-format (\d+)", SETTINGS.read_text())[1]
        self.formatter = shutil.which(f"clang-format-{self.wanted}") or shutil.which("clang-format")
        if not self.formatter:
            self.skipTest(f"clang-format {self.wanted} is not installed")
        found = re.search(r"version (\d+)", self.run_command(self.formatter, "--version").stdout)[1]
        if found != self.wanted:
            self.skipTest(f"clang-format {found} is installed, not {self.wanted}")

    def check(self, *files):
        return self.run_command(self.formatter, f"--style=file:{SETTINGS}", "--dry-run", "-Werror", *files)

    def test_files(self):
        files = sorted(path for folder in FOLDERS for path in (REPOSITORY / folder).rglob("*.*") if path.suffix in (".h", ".cpp"))
        self.assertGreater(len(files), 200)
        checked = self.check(*files)
        unformatted = "\n".join(sorted(set(re.findall(r"^(\S+?):\d+:\d+: error", checked.stderr, re.MULTILINE))))
        self.assertEqual(checked.returncode, 0, f"{unformatted}\n{SETTINGS} says how to format them.")

    def test_ugly_file_is_found(self):
        (self.folder / "ugly.cpp").write_text(UGLY)
        self.assert_fails_saying(self.check(self.folder / "ugly.cpp"), "code should be clang-formatted")


if __name__ == "__main__":
    unittest.main()

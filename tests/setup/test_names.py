# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Tests are found by the names of their files, test_*.py and *_test.cpp, and CTest runs all of them."""

import json
import re
import unittest

from tests.setup.scratch import BUILD, REPOSITORY, SetupTest

PYTHON = re.compile(r"^    (?:async )?def test_", re.MULTILINE)
CPP = re.compile(r"^(?:TYPED_)?TEST(?:_[FP])?\(", re.MULTILINE)
TESTS = REPOSITORY / "tests"


def misnamed(paths, pattern, has_tests):
    """The files whose name says otherwise than their contents."""
    return [str(path) for path in sorted(paths) if bool(re.search(pattern, path.name)) != bool(has_tests.search(path.read_text()))]


class Names(SetupTest):
    def python_files(self):
        return list(TESTS.rglob("*.py"))

    def test_python(self):
        self.assertGreater(len(self.python_files()), 80)
        self.assertEqual(misnamed(self.python_files(), r"^test_\w+\.py$", PYTHON), [])

    def test_cpp(self):
        files = list(TESTS.rglob("*.cpp"))
        self.assertGreater(len(files), 40)
        self.assertEqual(misnamed(files, r"_test\.cpp$", CPP), [])

    def test_a_wrong_name_is_found(self):
        for name, text in (("good.py", "    def test_x(self):\n"), ("test_x.py", "def run():\n")):
            (self.folder / name).write_text(text)
        (self.folder / "test_y.py").write_text("    async def test_y(self):\n")
        found = misnamed(self.folder.glob("*.py"), r"^test_\w+\.py$", PYTHON)
        self.assertEqual(found, [str(self.folder / "good.py"), str(self.folder / "test_x.py")])

    def test_ctest_runs_each_module(self):
        told = self.run_command("ctest", "--show-only=json-v1", cwd=BUILD)
        self.assert_succeeds(told)
        called = {word for test in json.loads(told.stdout)["tests"] for word in test.get("command", ())}
        modules = {
            ".".join(path.relative_to(REPOSITORY).with_suffix("").parts) for path in self.python_files() if path.name.startswith("test_")
        }
        self.assertEqual(sorted(modules - called), [])


if __name__ == "__main__":
    unittest.main()

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Python programs run by module name in any folder."""

import re
import sys
import unittest

from tests.setup.scratch import REPOSITORY, SetupTest

PACKAGES = ("benchmarks", "experiments", "tests", "tools")


def modules():
    files = [path for package in PACKAGES for path in sorted((REPOSITORY / package).rglob("*.py"))]
    return {".".join(path.relative_to(REPOSITORY).with_suffix("").parts): path for path in files}


class Modules(SetupTest):
    def setUp(self):
        super().setUp()
        for name in (*PACKAGES, "json", "store"):
            (self.folder / f"{name}.py").write_text("raise ImportError('a module of the current folder')\n")

    def launch(self, *words):
        return self.run_command(sys.executable, "-B", REPOSITORY / "run_module.py", *words)

    def test_the_folder_of_the_caller_does_not_matter(self):
        done = self.launch("tools.batch.batch", "--help")
        self.assert_succeeds(done)
        self.assertIn("usage: batch", done.stdout)

    def test_without_a_module_it_says_how_it_is_used(self):
        self.assert_fails_saying(self.launch(), "./run_module.py tests.stress.run")

    def test_arguments_and_exit_code_are_handed_on(self):
        done = self.launch("tests.patch.check_patches", "headers", self.folder / "no such folder")
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("no such folder", done.stdout + done.stderr)

    def test_each_module_finds_its_imports(self):
        names = [name for name in modules() if not name.startswith("tests.setup.")]
        self.assertGreater(len(names), 90)
        text = "import importlib, sys\nsys.path[0] = sys.argv.pop(1)\nfor name in sys.argv[1:]: importlib.import_module(name)"
        self.assert_succeeds(self.run_command(sys.executable, "-B", "-c", text, REPOSITORY, *names))

    def test_no_module_changes_the_path_or_imports_a_bare_name(self):
        bare = {name.rsplit(".", 1)[-1] for name in modules()} - set(sys.stdlib_module_names)
        imports = re.compile(rf"^\s*(?:import|from) (?:{'|'.join(sorted(bare))})\b(?!\.)", re.MULTILINE)
        for name, path in modules().items():
            text = path.read_text()
            with self.subTest(name):
                self.assertNotIn("sys." + "path.", text)
                self.assertEqual([found for found in imports.findall(text) if found.split()[1] not in PACKAGES], [])

    def test_packages_do_not_depend_on_each_other_in_circles(self):
        allowed = {"tools": (), "benchmarks": ("tools",), "experiments": ("tools",), "tests": PACKAGES}
        for name, path in modules().items():
            package = name.split(".")[0]
            used = set(re.findall(rf"^\s*(?:from|import) ({'|'.join(PACKAGES)})\b", path.read_text(), re.MULTILINE))
            self.assertEqual(used - {package, *allowed[package]}, set(), name)


if __name__ == "__main__":
    unittest.main()

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""CTest runs all test_*.py and *_test.cpp."""

import ast
import json
import re
import unittest

from tests.setup.scratch import BUILD, REPOSITORY, SetupTest

PYTHON = re.compile(r"^    (?:async )?def test_", re.MULTILINE)
CPP = re.compile(r"^(?:TYPED_)?TEST(?:_[FP])?\(", re.MULTILINE)
TESTS = REPOSITORY / "tests"


def misnamed(paths, pattern, has_tests):
    return [str(path) for path in sorted(paths) if bool(re.search(pattern, path.name)) != bool(has_tests.search(path.read_text()))]


def left_out_classes(path, calls):
    classes = [
        node.name
        for node in ast.parse(path.read_text()).body
        if isinstance(node, ast.ClassDef) and any(getattr(part, "name", "").startswith("test_") for part in node.body)
    ]
    named = {word.split(".")[0] for words in calls for word in words}
    return [name for name in classes if name not in named] if all(calls) and named.intersection(classes) else []


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

    def called(self):
        told = self.run_command("ctest", "--show-only=json-v1", cwd=BUILD)
        self.assert_succeeds(told)
        calls = {}
        for test in json.loads(told.stdout)["tests"]:
            words = test.get("command", [])
            for place, word in enumerate(words):
                if word.startswith("tests."):
                    calls.setdefault(word, []).append(words[place + 1 :])
        return calls

    def test_ctest_runs_each_module(self):
        modules = {
            ".".join(path.relative_to(REPOSITORY).with_suffix("").parts) for path in self.python_files() if path.name.startswith("test_")
        }
        self.assertEqual(sorted(modules - set(self.called())), [])

    def test_ctest_runs_each_class(self):
        left_out = []
        for module, calls in self.called().items():
            left_out += [f"{module}.{name}" for name in left_out_classes(REPOSITORY.joinpath(*module.split(".")).with_suffix(".py"), calls)]
        self.assertEqual(left_out, [])

    def test_a_class_that_is_left_out_is_found(self):
        module = self.folder / "test_z.py"
        module.write_text("class A:\n    def test_a(self): pass\nclass B(A):\n    async def test_b(self): pass\nclass Base:\n    pass\n")
        for calls, expected in (([["A"]], ["B"]), ([["A"], ["B.test_b"]], []), ([["B"], []], []), ([["0"], ["1"]], [])):
            self.assertEqual(left_out_classes(module, calls), expected, calls)


if __name__ == "__main__":
    unittest.main()

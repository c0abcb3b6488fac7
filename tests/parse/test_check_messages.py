# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The runner of parse cases detects faults."""

import pathlib
import tempfile
import unittest

from tests.parse import cases_file, check_messages


def case_of(text):
    return cases_file.parse_case("case", text.split("\n"))


class Cases(unittest.TestCase):
    def test_mark_and_head(self):
        case = case_of("camera {\n @view // <<\n}\n--- error: a | b")
        self.assertEqual(case.place, (cases_file.SCENE, 3))  # one line of head
        self.assertEqual(case.parts("error"), [["a", "b"]])

    def test_version_of_its_own(self):
        self.assertEqual(case_of("#version 3.1;\nx // <<\n--- error: a").place, (cases_file.SCENE, 2))

    def test_mark_in_an_included_file(self):
        case = case_of('#include "a.inc"\n--- file a.inc\n\nx // <<\n--- error: a')
        self.assertEqual(case.place, ("a.inc", 2))

    def test_refused(self):
        for text in [
            "x",
            "x\n--- error: a",
            "x // <<\n--- ok",
            "// <<\n// <<\n--- error: a",
            "x\n--- eror: a",
            "x // <<\n--- error: a\n--- error: b",
            "x\n--- ok\nstray",
        ]:
            with self.subTest(text), self.assertRaises(cases_file.BadCase):
                case_of(text)


class Messages(unittest.TestCase):
    def test_broken_lines(self):
        text = "==== [Parsing...]\nFile 'a b.inc' line 12: Parse Error: one two\n three\nFatal error in parser: no\n"
        self.assertEqual(check_messages.messages_of(text), [("error", "a b.inc", 12, "one two three")])

    def test_place_before_the_message(self):
        text = "File: scene.pov  Line: 3\nFile Context (2 lines):\na\nb\nRender Warning: one\n two\nmore\nWarning: three\n"
        self.assertEqual(check_messages.messages_of(text), [("warning", "scene.pov", 3, "one two"), ("warning", None, 0, "three")])

    def test_parts_in_order(self):
        self.assertTrue(check_messages.has_parts("a b c", ["a", "c"]))
        self.assertFalse(check_messages.has_parts("a b c", ["c", "a"]))


class Verdicts(unittest.TestCase):
    """A stand-in for the program with the test's messages and files."""

    def verdict(self, message, code, picture, text):
        with tempfile.TemporaryDirectory() as folder:
            program = pathlib.Path(folder) / "program"
            make = f"touch {check_messages.PICTURE}\n" if picture else ""
            program.write_text(f"#!/bin/sh\n{make}cat <<'END'\n{message}\nEND\nexit {code}\n")
            program.chmod(0o755)
            return check_messages.check(str(program), case_of(text), [])[0]

    def test_error(self):
        text = "x // <<\n--- error: one | two"
        good = "File 'scene.pov' line 2: Parse Error: one\n two"
        self.assertEqual(self.verdict(good, 1, False, text), [])
        for message, code, picture in [
            (good, 0, False),
            (good, 1, True),
            (good.replace("2", "3"), 1, False),
            (good.replace("two", "three"), 1, False),
            (good + "\n" + good, 1, False),
            (good.replace("scene", "other"), 1, False),
            ("", 1, False),
            ("File 'scene.pov' line 2: Parse Warning: one two", 1, False),
        ]:
            with self.subTest(message=message, code=code, picture=picture):
                self.assertNotEqual(self.verdict(message, code, picture, text), [])

    def test_no_error(self):
        text = "x\n--- says: one | two"
        self.assertEqual(self.verdict("one\n  two", 0, True, text), [])
        for message, code, picture in [
            ("one two", 1, True),
            ("one two", 0, False),
            ("two one", 0, True),
            ("one two\nFile 'scene.pov' line 1: Parse Warning: w", 0, True),
        ]:
            with self.subTest(message=message, code=code, picture=picture):
                self.assertNotEqual(self.verdict(message, code, picture, text), [])


if __name__ == "__main__":
    unittest.main()

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""CMake's manual shows nothing newer than the oldest accepted CMake."""

import json
import re
import subprocess
import unittest

from tests.setup.scratch import CMAKE, REPOSITORY, SetupTest

# the least CMake for each version of CMakePresets.json
PRESETS = {1: (3, 19), 2: (3, 20), 3: (3, 21), 4: (3, 23), 5: (3, 24), 6: (3, 25), 7: (3, 27), 8: (3, 28), 9: (3, 30), 10: (3, 31)}


def read(name):
    return (REPOSITORY / name).read_text(encoding="utf-8")


def version(text):
    return tuple(int(number) for number in text.split(".")[:2])


def minimum(name):
    return version(re.search(r"^cmake_minimum_required\(VERSION ([0-9.]+)\)", read(name), re.MULTILINE)[1])


def sections(help_option):
    text = subprocess.run([CMAKE, help_option], capture_output=True, text=True, check=True).stdout
    parts = re.split(r"^(\w+)\n-{2,}$", text, flags=re.MULTILINE)
    return dict(zip(parts[1::2], parts[2::2]))


def added(section):
    """Versions by words of a SECTION; "": its subject."""
    found = {}
    for place in re.finditer(r"^ *\.\. versionadded:: ([0-9.]+)", section, re.MULTILINE):
        above = section[: place.start()].strip().rpartition("\n\n")[2]
        words = re.findall(r"\b[A-Z][A-Z_]+\b", above) if above else [""]
        for word in words[:1]:
            found[word] = min(found.get(word, (99,)), version(place[1]))
    return found


def calls(text):
    text = re.sub(r"#.*", "", text)
    for call in re.finditer(r"\b([a-z_]+)\(((?:\"(?:\\.|[^\"\\])*\"|[^()\"])*)", text):
        yield call[1], re.findall(r"\b[A-Z][A-Z_]+\b", re.sub(r"\"(?:\\.|[^\"\\])*\"", "", call[2]))


class LeastCMake(SetupTest):
    def setUp(self):
        super().setUp()
        self.least = minimum("CMakeLists.txt")

    def newer_than(self, least):
        commands = {name: added(text) for name, text in sections("--help-commands").items()}
        variables = {name: added(text) for name, text in sections("--help-variables").items()}
        newer = set()
        files = [
            path
            for folder in ("cmake", "tests", "tools")
            for path in (REPOSITORY / folder).rglob("*")
            if path.suffix == ".cmake" or path.name == "CMakeLists.txt"
        ]
        self.assertGreater(len(files), 20)
        for path in [REPOSITORY / "CMakeLists.txt", *files]:
            text = path.read_text(encoding="utf-8")
            for command, words in calls(text):
                newer |= {f"{command} {word}".strip() for word in ("", *words) if commands.get(command, {}).get(word, (0,)) > least}
            newer |= {name for name in re.findall(r"\b[A-Z]\w+", text) if variables.get(name, {}).get("", (0,)) > least}
        return newer

    def test_all_files_state_the_same(self):
        self.assertEqual(minimum("cmake/bundle/make.cmake"), self.least)
        presets = json.loads(read("CMakePresets.json"))
        required = presets["cmakeMinimumRequired"]
        self.assertEqual((required["major"], required["minor"]), self.least)
        self.assertLessEqual(PRESETS[presets["version"]], self.least)
        self.assertIn("\n| CMake | {}.{} or later |".format(*self.least), read("docs/building.md"))

    def test_nothing_newer_is_used(self):
        self.assertEqual(self.newer_than(self.least), set())

    def test_finds_what_is_newer(self):
        older = self.newer_than((3, 16))
        self.assertLessEqual(
            {"file COPY_FILE", "string JSON", "execute_process COMMAND_ERROR_IS_FATAL", "CMAKE_CURRENT_FUNCTION_LIST_DIR"}, older
        )


if __name__ == "__main__":
    unittest.main()

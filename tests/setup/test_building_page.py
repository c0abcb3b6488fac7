# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""docs/building.md names all that the build needs."""

import re
import unittest

from tests.setup.scratch import REPOSITORY, SetupTest

# arm64's compiler has another package; ccache is optional
NOT_FOR_ARM64 = {"g++", "ccache"}


def section(title):
    page = (REPOSITORY / "docs" / "building.md").read_text(encoding="utf-8")
    return page.partition(f"\n## {title}\n")[2].partition("\n## ")[0]


def braces(word):
    inner = re.fullmatch(r"(.*)\{(.*)\}(.*)", word)
    return [inner[1] + part + inner[3] for part in inner[2].split(",")] if inner else [word]


class BuildingPage(SetupTest):
    def test_table_names_each_required_library(self):
        required = re.findall(
            r"^tilt_lens_require\((\w+)_(?:FOUND|LIBRARY) ", (REPOSITORY / "cmake" / "Dependencies.cmake").read_text(), re.M
        )
        self.assertGreater(len(required), 8)
        table = section("What the build needs").lower()
        missing = [name for name in required if not all(word in table for word in name.lower().split("_"))]
        self.assertEqual(missing, [])

    def test_arm64_has_the_packages_of_render(self):
        command = re.search(r"apt-get install ((?:.*\\\n)*.*)", section("arm64"))[1].replace("\\\n", " ")
        named = {name for word in command.split() for name in braces(word)}
        lines = (REPOSITORY / "cmake" / "debian-packages").read_text(encoding="utf-8")
        wanted = [names.split("|")[0] for names in re.findall(r"^render +(\S+)$", lines, re.M)]
        self.assertGreater(len(wanted), 15)
        missing = [name for name in wanted if not {name, name + ":arm64"} & named and name not in NOT_FOR_ARM64]
        self.assertEqual(missing, [])
        # the compiler finds no libraries of another processor
        self.assertEqual([name for name in named if name.startswith(("lib", "zlib")) and not name.endswith(":arm64")], [])


if __name__ == "__main__":
    unittest.main()

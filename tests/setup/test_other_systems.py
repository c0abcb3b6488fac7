# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The set-up on systems without Debian's packages."""

import os
import re
import shutil
import unittest

from tests.setup.commands import STAND_IN, CommandTest


class OtherSystems(CommandTest):
    EVERYWHERE = (
        "awk",
        "bash",
        "basename",
        "cat",
        "chmod",
        "cut",
        "dirname",
        "env",
        "find",
        "flock",
        "grep",
        "head",
        "id",
        "mkdir",
        "mktemp",
        "mv",
        "nproc",
        "paste",
        "readlink",
        "rm",
        "sed",
        "sort",
        "stat",
        "tail",
        "tput",
        "uname",
    )
    BUILD = ("gzip", "patch", "tar", "xz")

    def setUp(self):
        super().setUp()
        self.have(self.EVERYWHERE)
        self.source = self.folder / "the source"
        self.source.mkdir()

    def have(self, commands):
        for name in commands:
            (self.tools / name).symlink_to(shutil.which(name))

    def have_build_tools(self):
        self.have(self.BUILD)
        self.tool("c++", "exit 1")
        self.tool("ninja", "exit 0")
        self.tool(
            "cmake",
            f"""[ "$1" != --version ] || {{ echo cmake version 4.3.0; exit; }}
            printf "%s\\n" "$@" > "{self.folder}/cmake.log"
            touch "{self.copy}/build/build.ninja" """,
        )

    def environment(self):
        return {"PATH": str(self.tools), "DISPLAY": ""}

    def configured_with(self):
        return (self.folder / "cmake.log").read_text(encoding="utf-8").splitlines()

    def assert_offers_all(self, process, cause):
        self.assert_fails_saying(
            process, cause, f"povray-tilt-lens-VERSION-linux-{os.uname().machine}.tar.xz", "docs/building.md", "./render --source FOLDER"
        )
        self.assertEqual(len(re.findall("^(?:render|check): ", process.stderr, re.MULTILINE)), 1)

    def test_nothing_to_build_with(self):
        process = self.command(self.copy / "render")
        self.assert_offers_all(process, "lacks what the build needs: cmake, ninja, c++, patch, tar, gzip, xz.")
        self.assert_offers_all(self.command(self.copy / "check"), "lacks what the build needs: cmake")

    def test_one_tool_is_missing(self):
        self.have_build_tools()
        (self.tools / "patch").unlink()
        self.assert_offers_all(self.command(self.copy / "render", "--source", self.source), "lacks what the build needs: patch.")

    def test_tools_without_a_source(self):
        self.have_build_tools()
        self.assert_offers_all(self.command(self.copy / "render"), "has no apt-get and dpkg")
        self.assertFalse((self.folder / "cmake.log").exists())

    def test_folder_with_the_source(self):
        self.have_build_tools()
        self.command(self.copy / "render", "--source", "the source", cwd=self.folder)
        self.assertEqual(self.configured_with(), ["--preset", "release", f"-DPOVRAY_TARBALL={self.source}"])

    def test_source_downloaded_before(self):
        self.have_build_tools()
        (self.copy / "build" / "downloads").mkdir(parents=True)
        (self.copy / "build" / "downloads" / "povray_1.orig.tar.gz").touch()
        self.command(self.copy / "render")
        self.assertEqual(self.configured_with(), ["--preset", "release"])

    def test_what_is_built_needs_no_tools(self):
        program = self.built("povray") / "bin" / "povray"
        program.parent.mkdir()
        program.write_text(STAND_IN, encoding="utf-8")
        program.chmod(0o755)
        self.have(["ninja"])
        self.assert_succeeds(self.command(self.copy / "render"))

    def test_the_same_folder_again_and_another(self):
        self.have_build_tools()
        build = self.built("povray")
        cache = build / "CMakeCache.txt"
        cache.write_text(cache.read_text(encoding="utf-8") + f"POVRAY_TARBALL:PATH={self.source}\n", encoding="utf-8")
        self.command(self.copy / "render", "--source", self.source)
        self.assertFalse((self.folder / "cmake.log").exists())
        other = self.folder / "other"
        other.mkdir()
        self.command(self.copy / "render", "--source", other)
        self.assertEqual(self.configured_with(), ["--preset", "release", f"-DPOVRAY_TARBALL={other}"])

    def test_wrong_use_of_the_option(self):
        for words, said in (
            (("--source",), "--source needs a folder"),
            (("--source", ""), "--source needs a folder"),
            (("--source", "nowhere"), "there is no folder nowhere"),
            (("+W8", "--source", "x"), "--source FOLDER stands before the scene"),
        ):
            process = self.command(self.copy / "render", *words)
            self.assert_fails_saying(process, said)
            self.assertEqual(len(process.stderr.splitlines()), 1, process.stderr)


if __name__ == "__main__":
    unittest.main()

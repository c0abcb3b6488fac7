# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Calls refused by on_fresh_debian. Making a system needs root."""

import os
import unittest

from tests.setup.scratch import REPOSITORY, SetupTest

SCRIPT = REPOSITORY / "tests" / "setup" / "on_fresh_debian"


class OnFreshDebian(SetupTest):
    def setUp(self):
        super().setUp()
        # no system is made even by root
        for name, text in (("id", "echo ${FAKE_USER:-0}"), ("debootstrap", "echo E: no such suite; exit 1"), ("git", "exit 1")):
            tool = self.folder / name
            tool.write_text(f"#!/bin/bash\n{text}\n", encoding="utf-8")
            tool.chmod(0o755)

    def call(self, *arguments, **env):
        return self.run_command(SCRIPT, *arguments, env={"PATH": f"{self.folder}:{os.environ['PATH']}", **env})

    def test_help(self):
        process = self.call("--help")
        self.assert_succeeds(process)
        self.assertIn("usage: on_fresh_debian", process.stdout)

    def test_without_a_suite(self):
        process = self.call()
        self.assertEqual(process.returncode, 2)
        self.assertIn("usage: on_fresh_debian", process.stderr)

    def test_unknown_words(self):
        self.assert_fails_saying(self.call("--fast", "trixie"), "there is no option --fast")
        self.assert_fails_saying(self.call("trixie", "dance"), "there is no step dance; there are render, check, package, bundle and user")
        self.assert_fails_saying(self.call("--work"), "--work needs a folder")

    def test_only_root(self):
        self.assert_fails_saying(self.call("trixie", FAKE_USER="1000"), "only root can make a system")

    def test_suite_missing_on_the_mirror(self):
        work = self.folder / "work"
        self.assert_fails_saying(self.call("--work", work, "nowhere", "render"), "debootstrap failed", "no such suite")
        self.assertFalse((work / "minimal-nowhere").exists())


if __name__ == "__main__":
    unittest.main()

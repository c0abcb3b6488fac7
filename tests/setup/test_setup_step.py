# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The step that installs packages and configures; the fast build."""

import unittest

from tests.setup.commands import CommandTest
from tests.setup.scratch import CMAKE


class FastBuild(CommandTest):
    def setUp(self):
        super().setUp()
        self.fast = self.built("povray") / "fast"
        self.have_all_packages()
        for folder in ("tutorial", "paper", "include"):
            (self.copy / "scenes" / folder).mkdir()
        for name in ("tutorial/tilt.pov", "paper/box_a.pov"):
            (self.copy / "scenes" / name).write_text("", encoding="utf-8")
        (self.fast / "bin").mkdir(parents=True)
        self.log = self.folder / "steps.log"
        for step in ("cmake", "ninja"):
            self.tool(step, f'echo "{step} $*" >> "{self.log}"')
        program = self.fast / "bin" / "povray"
        program.write_text(f'#!/bin/bash\necho "povray $1" >> "{self.log}"\nexit "${{POVRAY_EXIT:-0}}"\n', encoding="utf-8")
        program.chmod(0o755)

    def steps(self):
        lines = self.log.read_text(encoding="utf-8").splitlines()
        return [line.split(" -j")[0] for line in lines if " -n " not in line]

    def test_profile_training_use(self):
        (self.fast / "old.gcda").write_text("an old profile", encoding="utf-8")
        process = self.command(self.copy / "cmake" / "build-fast")
        self.assert_succeeds(process)
        self.assertEqual(
            self.steps(),
            [
                f"ninja -C {self.copy}/build",
                "cmake --preset fast -DTILT_LENS_PROFILE=make",
                f"ninja -C {self.fast}",
                f'povray +I"{self.gallery}"',
                f'povray +I"{self.copy}/scenes/tutorial/tilt.pov"',
                f'povray +I"{self.copy}/scenes/paper/box_a.pov"',
                "cmake --preset fast -DTILT_LENS_PROFILE=use",
                f"ninja -C {self.fast}",
            ],
        )
        self.assertFalse((self.fast / "old.gcda").exists())
        self.assertEqual(process.stderr.splitlines()[-1], f"The fast program: {self.fast}/bin/povray")

    def test_failed_training(self):
        process = self.command(self.copy / "cmake" / "build-fast", POVRAY_EXIT="1", TMPDIR=str(self.folder))
        self.assert_fails_saying(process, "miniature_town.pov could not be rendered")
        self.assertNotIn("cmake --preset fast -DTILT_LENS_PROFILE=use", self.steps())
        self.assertEqual(list(self.folder.glob("tmp.*")), [])

    def test_no_arguments(self):
        self.assert_fails_saying(self.command(self.copy / "cmake" / "build-fast", "-h"), "no arguments", "bin/povray")


class SetupStep(CommandTest):
    def setUp(self):
        super().setUp()
        (self.copy / "cmake" / "debian-packages").write_text(
            "render  bash\nrender  tilt-lens-missing\ncheck  tilt-lens-check-only\n", encoding="utf-8"
        )
        self.tool("apt-get", f'echo "$@" >> "{self.folder}/apt.log"; [ "$1" != --yes ] || exit 0; exit "${{APT_EXIT:-0}}"')

    def test_neither_root_nor_sudo(self):
        self.tool("id", "echo 1000")
        process = self.command(self.copy / "render")
        self.assert_fails_saying(process, "packages are missing", "apt-get install --no-install-recommends tilt-lens-missing")
        self.assertFalse((self.folder / "apt.log").exists())

    def test_render_does_not_install_packages_of_check(self):
        self.tool("id", "echo 0")
        self.command(self.copy / "render", APT_EXIT="100")
        log = (self.folder / "apt.log").read_text(encoding="utf-8")
        self.assertIn("install tilt-lens-missing\n", log)
        self.assertNotIn("tilt-lens-check-only", log)

    def test_installation_waits_for_another_apt(self):
        self.tool("id", "echo 0")
        self.command(self.copy / "render", APT_EXIT="100")
        self.assertRegex((self.folder / "apt.log").read_text(encoding="utf-8"), r"-o DPkg::Lock::Timeout=\d+ .*install tilt-lens-missing")

    def test_sudo_installs(self):
        self.tool("id", "echo 1000")
        self.tool("sudo", '[ "$1" = -n ] && exit 0; exec "$@"')
        self.command(self.copy / "check", APT_EXIT="100")
        log = (self.folder / "apt.log").read_text(encoding="utf-8")
        self.assertRegex(log, "install .*tilt-lens-missing.* tilt-lens-check-only")

    def test_no_network(self):
        self.tool("id", "echo 0")
        process = self.command(self.copy / "render", APT_EXIT="100")
        self.assert_fails_saying(process, "packages could not be installed", "is there a network?")

    def installed_of(self, packages, known=""):
        """Packages installed for PACKAGES if apt knows the names KNOWN."""
        (self.copy / "cmake" / "debian-packages").write_text(packages, encoding="utf-8")
        self.tool("id", "echo 0")
        self.tool("apt-cache", f'case " {known} " in *" $2 "*) echo "  Candidate: 1" ;; *) echo "  Candidate: (none)" ;; esac')
        self.command(self.copy / "render", APT_EXIT="100")
        log = (self.folder / "apt.log").read_text(encoding="utf-8")
        return log.rpartition("install ")[2].split()

    def test_alternative_names_of_a_package(self):
        packages = "render  tilt-a|tilt-b|tilt-c\nrender  bash|tilt-d\nrender  tilt-e|bash\nrender  tilt-f\n"
        self.assertEqual(self.installed_of(packages, known="tilt-b tilt-c"), ["tilt-b", "tilt-f"])
        self.assertEqual(self.installed_of(packages, known="tilt-c tilt-a"), ["tilt-a", "tilt-f"])
        self.assertEqual(self.installed_of(packages), ["tilt-a", "tilt-f"])  # apt then reports the fault

    def test_libraries_for_another_processor_are_none_for_this_one(self):
        self.tool(
            "dpkg-query", 'echo installed tilt-a other; echo installed tilt-b all; echo "installed tilt-c $(dpkg --print-architecture)"'
        )
        self.assertEqual(self.installed_of("render  tilt-a\nrender  tilt-b\nrender  tilt-c\n"), ["tilt-a"])

    def test_old_cmake(self):
        self.have_all_packages()
        self.tool("cmake", "echo cmake version 3.21.9")
        process = self.command(self.copy / "render")
        self.assert_fails_saying(process, "lacks what the build needs: CMake 3.22 or later (found is 3.21.9)", "bundle")
        self.assertFalse((self.copy / "build" / "build.ninja").exists())

    def test_oldest_cmake(self):
        self.have_all_packages()
        self.tool(
            "cmake",
            f"""[ "$1" != --version ] || {{ echo cmake version 3.22.1; exit; }}
            echo "$@" > "{self.folder}/cmake.log"; exit 1""",
        )
        self.assert_fails_saying(self.command(self.copy / "render"), "the configuration failed")
        self.assertIn("--preset release", (self.folder / "cmake.log").read_text(encoding="utf-8"))

    def test_moved_repository_is_built_anew(self):
        self.have_all_packages()
        self.tool("cmake", f'echo "$@" >> "{self.folder}/cmake.log"')
        self.tool("ninja", "exit 0")
        build = self.copy / "build"
        (build / "downloads").mkdir(parents=True)
        (build / "CMakeCache.txt").write_text("CMAKE_HOME_DIRECTORY:INTERNAL=/elsewhere\n", encoding="utf-8")
        (build / "build.ninja").write_text("", encoding="utf-8")
        process = self.command(self.copy / "render")
        self.assertIn("The repository has moved", process.stderr)
        self.assertTrue((build / "downloads").is_dir())
        self.assertFalse((build / "build.ninja").exists())
        self.assertIn("--preset release", (self.folder / "cmake.log").read_text(encoding="utf-8"))


if __name__ == "__main__":
    unittest.main()

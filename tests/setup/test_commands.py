# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The commands up to the build, with a stand-in."""

import fcntl
import os
import re
import select
import shutil
import subprocess
import unittest

from tests.setup.scratch import CMAKE, REPOSITORY, SetupTest
from tests.waiting import PATIENCE

STAND_IN = r"""#!/bin/bash
for argument in "$@"; do printf 'argument [%q]\n' "$argument" >&2; done
printf '%s\0' "=a picture.png" >> "$TILT_LENS_FILE_LIST"
echo 'a picture on standard output'
exit "${POVRAY_EXIT:-0}"
"""


class CommandTest(SetupTest):
    def setUp(self):
        super().setUp()
        self.copy = self.folder / "my clone"
        self.copy.mkdir()
        shutil.copytree(REPOSITORY / "cmake", self.copy / "cmake")
        for name in ("render", "check", "CMakeLists.txt"):
            shutil.copy(REPOSITORY / name, self.copy / name)
        self.gallery = self.copy / "scenes" / "gallery" / "miniature_town.pov"
        self.gallery.parent.mkdir(parents=True)
        self.gallery.write_text("", encoding="utf-8")
        self.tools = self.folder / "tools"
        self.tools.mkdir()
        self.tool("sudo", "exit 1")

    def tool(self, name, text):
        path = self.tools / name
        path.write_text(f"#!/bin/bash\n{text}\n", encoding="utf-8")
        path.chmod(0o755)

    def have_all_packages(self):
        (self.copy / "cmake" / "debian-packages").write_text("render  bash\n", encoding="utf-8")

    def built(self, target):
        build = self.copy / "build"
        build.mkdir()
        (build / "CMakeCache.txt").write_text(
            f"CMAKE_HOME_DIRECTORY:INTERNAL={self.copy}\nCMAKE_CACHEFILE_DIR:INTERNAL={build}\n" "TILT_LENS_TESTS:BOOL=ON\n",
            encoding="utf-8",
        )
        (build / "build.ninja").write_text(f"build {target}: phony\n", encoding="utf-8")
        return build

    def environment(self):
        return {"PATH": f"{self.tools}:{os.environ['PATH']}", "DISPLAY": "", "CI": ""}

    def command(self, name, *arguments, cwd=None, **env):
        return self.run_command(name, *arguments, cwd=cwd, env={**self.environment(), **env})


class BuiltProgram(CommandTest):
    def setUp(self):
        super().setUp()
        program = self.built("povray") / "bin" / "povray"
        program.parent.mkdir()
        program.write_text(STAND_IN, encoding="utf-8")
        program.chmod(0o755)
        self.scene = self.folder / "my scene.pov"
        self.scene.write_text("", encoding="utf-8")

    def render(self, *arguments, **kwargs):
        return self.command(self.copy / "render", *arguments, **kwargs)


class RenderCommand(BuiltProgram):
    @staticmethod
    def arguments(process):
        quoted = re.findall(r"^argument \[(.*)\]$", process.stderr, re.MULTILINE)
        words = subprocess.run(["bash", "-c", f"printf '%s\\0' {' '.join(quoted)}"], capture_output=True, text=True, check=True)
        return words.stdout.split("\0")[:-1]

    def test_without_arguments_the_town_in_its_size(self):
        process = self.render()
        self.assert_succeeds(process)
        arguments = self.arguments(process)
        self.assertIn(f'+I"{self.gallery}"', arguments)
        self.assertIn("+W1280", arguments)
        self.assertIn("+H720", arguments)
        self.assertIn("-D", arguments)

    def test_source_files_that_came_or_went_are_not_listed(self):
        (self.copy / "CMakeLists.txt").write_text(
            "cmake_minimum_required(VERSION 3.22)\nproject(parts LANGUAGES NONE)\n"
            'file(GLOB parts CONFIGURE_DEPENDS "${CMAKE_SOURCE_DIR}/*.part")\nmessage(STATUS "Parts: ${parts}")\nadd_custom_target(povray)\n',
            encoding="utf-8",
        )
        (self.copy / "old.part").touch()
        self.assert_succeeds(self.run_command(CMAKE, "-G", "Ninja", "-S", self.copy, "-B", self.copy / "build"))
        (self.copy / "old.part").rename(self.copy / "new.part")
        process = self.render()
        self.assert_succeeds(process)
        self.assertRegex(process.stderr, r"(?m)^-- Parts: .*new\.part$")
        self.assertNotRegex(process.stderr, r"GLOB|following files|(?m:^  [+-])")

    def test_options_alone_are_for_the_town_and_come_last(self):
        arguments = self.arguments(self.render("+W320"))
        self.assertIn(f'+I"{self.gallery}"', arguments)
        self.assertLess(arguments.index("+W1280"), arguments.index("+W320"))

    def test_scene_with_its_folder_and_the_include_folder(self):
        process = self.render("my scene.pov", "+W64")
        self.assert_succeeds(process)
        arguments = self.arguments(process)
        self.assertIn(f'+I"{self.scene}"', arguments)
        self.assertIn(f'+L"{self.folder}/"', arguments)
        self.assertIn(f'+L"{self.copy}/scenes/include"', arguments)
        self.assertIn(f'+O"{self.folder}/"', arguments)
        self.assertNotIn("+W1280", arguments)

    def test_scene_named_by_an_option(self):
        for option in (f"+I{self.scene}", f"Input_File_Name={self.scene}", "my.ini", "my.ini[low]"):
            arguments = self.arguments(self.render(option, "+W64"))
            self.assertFalse(any(str(self.gallery) in argument for argument in arguments), option)
            self.assertNotIn("+W1280", arguments)

    def test_spaces_and_quotes_survive(self):
        arguments = self.arguments(
            self.render(
                self.scene, '+O"my own.png"', "+Oother one.png", "Declare=a=1", "Output_File_Name=third one.png", "+K 0.5", "$(x) `y` *"
            )
        )
        for expected in ('+O"my own.png"', '+O"other one.png"', "Declare=a=1", 'Output_File_Name="third one.png"', "+K 0.5", "$(x) `y` *"):
            self.assertIn(expected, arguments)

    def test_scene_behind_options_brings_its_folder(self):
        other = self.folder / "sub" / "s.pov"
        other.parent.mkdir()
        other.write_text("", encoding="utf-8")
        for word in ("sub/s.pov", "+Isub/s.pov", 'Input_File_Name="sub/s.pov"'):
            process = self.render("+W64", word)
            self.assert_succeeds(process)
            folders = [argument for argument in self.arguments(process) if argument.endswith('sub/"') and argument.startswith("+L")]
            self.assertEqual(len(folders), 1, f"{word}: {process.stderr}")
            self.assertNotIn("+W1280", process.stderr)
        self.assert_fails_saying(self.render("+W64", "sub/none.pov"), "no readable scene file sub/none.pov")

    def test_any_name_reaches_povray(self):
        name = "a \nb;#\u00e4'.pov"
        (self.folder / name).write_text("", encoding="utf-8")
        process = self.render(name)
        self.assert_succeeds(process)
        self.assertIn(f'+I"{self.folder}/{name}"', self.arguments(process))

    def test_impossible_names(self):
        (self.folder / "a\"b'.pov").write_text("", encoding="utf-8")
        for word, said in (("", "the name of the scene is empty"), ("a\"b'.pov", "holds both \" and '")):
            process = self.render(word)
            self.assert_fails_saying(process, said)
            self.assertEqual(len(process.stderr.splitlines()), 1)

    def test_no_such_scene(self):
        process = self.render("none.pov")
        self.assert_fails_saying(process, "no readable scene file none.pov")
        self.assertEqual(len(process.stderr.splitlines()), 1)

    def test_exit_code_is_povrays(self):
        process = self.render(self.scene, POVRAY_EXIT="3")
        self.assertEqual(process.returncode, 3)
        self.assertNotIn("Picture:", process.stderr)

    def test_reports_the_pictures_place(self):
        process = self.render(self.scene)
        self.assertEqual(process.stderr.splitlines()[-1], f"Picture: {self.folder}/a picture.png")

    def test_pictures_with_the_users_own_list(self):
        users = self.folder / "list"
        users.write_bytes(b"=old.png\0")
        process = self.render(self.scene, TILT_LENS_FILE_LIST=str(users))
        self.assertEqual(process.stderr.splitlines()[-1], f"Picture: {self.folder}/a picture.png")
        self.assertEqual(users.read_bytes(), b"=old.png\0=a picture.png\0")

    def test_standard_output_is_povrays_own(self):
        self.assertEqual(self.render(self.scene).stdout, "a picture on standard output\n")

    def test_preview_only_with_a_display(self):
        self.assertNotIn("-D", self.arguments(self.render(self.scene, DISPLAY=":0")))

    def test_through_a_link_from_elsewhere(self):
        link = self.tools / "tilt-render"
        link.symlink_to(self.copy / "render")
        elsewhere = self.folder / "else where"
        elsewhere.mkdir()
        process = self.command(link, self.scene, cwd=elsewhere)
        self.assert_succeeds(process)
        self.assertIn(f'+O"{elsewhere}/"', self.arguments(process))

    def test_nothing_to_do_needs_no_configuration_and_no_network(self):
        self.have_all_packages()
        for name in ("cmake", "apt-get", "sudo"):
            self.tool(name, f'echo "{name} was called" >&2; exit 1')
        process = self.render(self.scene)
        self.assert_succeeds(process)
        self.assertNotIn("was called", process.stderr)


class CheckCommand(CommandTest):
    CLOSING = "97% tests passed, 1 tests failed out of 33"

    def setUp(self):
        super().setUp()
        self.built("all")
        self.have_all_packages()
        self.tool(
            "ctest",
            f"""echo "arguments: $*"
            until [ -e "{self.folder}/go" ]; do sleep 0.02; done
            echo; echo "{self.CLOSING}"; echo "Total Test time (real) =   3.70 sec"; printf "  2 - unit.two (Failed)"
            exit 8""",
        )

    def test_lines_keep_ctests_order_except_the_closing_one(self):
        with subprocess.Popen(
            [self.copy / "check", "--all", "-L", "unit"],
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            text=True,
            stdin=subprocess.DEVNULL,
            env={**os.environ, **self.environment()},
        ) as check:
            ready, _, _ = select.select([check.stdout], [], [], PATIENCE)
            first = check.stdout.readline() if ready else "nothing before CTest's end"
            (self.folder / "go").touch()  # the stand-in for CTest waits for this file
            rest = check.stdout.read().splitlines()
        self.assertRegex(first, r"^arguments: --output-on-failure -j \d+ -L unit$")
        self.assertEqual(rest, ["", "Total Test time (real) =   3.70 sec", "  2 - unit.two (Failed)", self.CLOSING])
        self.assertEqual(check.returncode, 8)

    SLOW = [f"group.slow{n}" for n in range(23)]

    def chosen(self, *arguments, **env):
        lines = [f"  Test #{n}: {name}" for n, name in enumerate(self.SLOW, 100)]
        listed = "\n".join(["Test project /build", *lines])
        self.tool("ctest", f'[ "$1" = -N ] && {{ echo "{listed}"; exit; }}; shift 3; printf "option %s\\n" "$@"')
        process = self.command(self.copy / "check", *arguments, **env)
        self.assert_succeeds(process)
        return re.findall("^option (.+)$", process.stdout, re.MULTILINE)

    def test_slow_tests_run_only_on_request(self):
        self.assertEqual(self.chosen(), ["-LE", "^slow$"])
        self.assertEqual(self.chosen("-N", "-E", "x"), ["-LE", "^slow$", "-N", "-E", "x"])
        self.assertEqual(self.chosen("--all"), [])
        self.assertEqual(self.chosen("--all", "-N"), ["-N"])
        for words in (["-L", "unit"], ["-R", "tilt"], ["-N", "-I", "1,2"]):
            self.assertEqual(self.chosen(*words), words)

    def test_slow_tests_take_turns_in_continuous_integration(self):
        ran = []
        for turn in range(10):
            self.tool("git", f'[ "$3 $4" = "rev-parse HEAD" ] && echo {turn:07x}{"c" * 33}')
            option, left_out = self.chosen(CI="true")
            self.assertEqual(option, "-E")
            self.assertNotIn("/build", left_out)
            ran += [name for name in self.SLOW if not re.search(left_out, name)]
            self.assertTrue(all(not re.search(left_out, name) for name in ("unit.quick", "group_slow1", "group.slow1.more")))
        self.assertEqual(sorted(ran), sorted(self.SLOW), "each in one turn of ten")
        self.tool("git", "exit 128")
        self.assertEqual(self.chosen(CI="true"), ["-LE", "^slow$"])

    def test_help_builds_nothing(self):
        self.tool("ninja", "echo built; exit 1")
        process = self.command(self.copy / "check", "--help")
        self.assert_succeeds(process)
        self.assertTrue(process.stdout.startswith("usage: ./check"))


class SetupsAtOnce(BuiltProgram):
    WAITING = "Waiting for another set-up"

    def setUp(self):
        super().setUp()
        self.have_all_packages()
        self.build = self.copy / "build"
        lock = open(self.build / "setup.lock", "w", encoding="utf-8")
        self.addCleanup(lock.close)
        self.lock = lock

    def with_work(self):
        """Each build of the program adds a line to `builds`."""
        (self.build / "build.ninja").write_text(
            "rule make\n  command = echo built >> builds && touch done\nbuild done: make source\nbuild povray: phony done\n",
            encoding="utf-8",
        )
        (self.build / "source").touch()

    def start(self):
        process = subprocess.Popen(
            [self.copy / "render", self.scene],
            cwd=self.folder,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
            text=True,
            env={**os.environ, **self.environment()},
        )
        self.addCleanup(process.stderr.close)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        return process

    def first_line(self, process):
        ready, _, _ = select.select([process.stderr], [], [], PATIENCE)
        return process.stderr.readline() if ready else "nothing"

    def test_who_finds_nothing_to_do_waits_for_no_other_such(self):
        fcntl.flock(self.lock, fcntl.LOCK_SH)
        self.assertRegex(self.first_line(self.start()), r"^argument ")

    def test_waits_for_a_build(self):
        fcntl.flock(self.lock, fcntl.LOCK_EX)
        process = self.start()
        self.assertIn(self.WAITING, self.first_line(process))
        fcntl.flock(self.lock, fcntl.LOCK_UN)
        self.assertNotIn(self.WAITING, process.communicate(timeout=PATIENCE)[1])
        self.assertEqual(process.returncode, 0)

    def test_builds_only_when_no_other_checks(self):
        self.with_work()
        fcntl.flock(self.lock, fcntl.LOCK_SH)
        process = self.start()
        self.assertIn(self.WAITING, self.first_line(process))
        self.assertFalse((self.build / "builds").exists())
        fcntl.flock(self.lock, fcntl.LOCK_UN)
        process.communicate(timeout=PATIENCE)
        self.assertEqual((self.build / "builds").read_text(encoding="utf-8"), "built\n")

    def test_of_several_with_work_one_builds(self):
        self.with_work()
        processes = [self.start() for _ in range(4)]
        for process in processes:
            process.communicate(timeout=PATIENCE)
            self.assertEqual(process.returncode, 0)
        self.assertEqual((self.build / "builds").read_text(encoding="utf-8"), "built\n")

    def with_cmake_file(self, time):
        (self.build / "build.ninja").write_text(
            "rule configure\n  command = echo configured >> builds && touch build.ninja\n  generator = 1\n"
            "build build.ninja: configure listfile\nbuild povray: phony\n",
            encoding="utf-8",
        )
        (self.build / "listfile").touch()
        os.utime(self.build / "listfile", (time, time))
        os.utime(self.build / "build.ninja", (1000, 1000))

    def test_changed_cmake_file_is_work(self):
        self.with_cmake_file(1001)
        self.assert_succeeds(self.render(self.scene))
        self.assertEqual((self.build / "builds").read_text(encoding="utf-8"), "configured\n")

    def test_unchanged_cmake_file_is_none(self):
        self.with_cmake_file(999)
        fcntl.flock(self.lock, fcntl.LOCK_SH)
        self.assertRegex(self.first_line(self.start()), r"^argument ")


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

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The commands up to the build, with a stand-in."""

import fcntl
import os
import re
import select
import subprocess
import unittest

from tests.setup.commands import BuiltProgram, CommandTest
from tests.setup.scratch import CMAKE
from tests.waiting import PATIENCE


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


if __name__ == "__main__":
    unittest.main()

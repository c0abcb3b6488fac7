# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""File names and signals of ./render."""

import os
import pathlib
import re
import shlex
import shutil
import signal
import subprocess
import time
import unittest

from tests.setup.scratch import BUILD, REPOSITORY, SetupTest
from tests.waiting import PATIENCE

SCENE = """#version 3.7;
global_settings { assumed_gamma 1 charset utf8 }
#include "gr\u00fcn.inc"
#declare Name = "gr\u00fcn.inc";
#include Name
#include concat("\u00c4 \u4e00", ".inc")
#fopen Values "\u4e00.txt" write
#write (Values, "1")
#fclose Values
camera { location -5*z }
sphere { 0, 1 pigment { rgb Green } }
"""
SLOW = """#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -5*z look_at 0 tilt_lens { tilt 4 f_stop 0.5 } blur_samples 100, 100 variance 0 }
plane { y, -1 pigment { checker } }
"""
FOLDER = "mit \u00e4 \U0001f600 \u4e00"


class RenderTest(SetupTest):
    def setUp(self):
        super().setUp()
        self.copy = self.folder / "clone"
        (self.copy / "scenes").mkdir(parents=True)
        shutil.copytree(REPOSITORY / "cmake", self.copy / "cmake")
        shutil.copy(REPOSITORY / "render", self.copy / "render")
        (self.copy / "scenes" / "include").symlink_to(REPOSITORY / "scenes" / "include")
        (self.copy / "cmake" / "debian-packages").write_text("render  bash\n", encoding="utf-8")
        build = self.copy / "build"
        build.mkdir()
        (build / "CMakeCache.txt").write_text(
            f"CMAKE_HOME_DIRECTORY:INTERNAL={self.copy}\nCMAKE_CACHEFILE_DIR:INTERNAL={build}\n", encoding="utf-8"
        )
        (build / "build.ninja").write_text("build povray: phony\n", encoding="utf-8")
        (build / "bin").mkdir()
        (build / "bin" / "povray").symlink_to(BUILD / "bin" / "povray")
        self.place = self.folder / FOLDER
        self.place.mkdir()


class FileNames(RenderTest):
    def scene(self, name="szene \u00f6.pov"):
        for include in ("gr\u00fcn.inc", "\u00c4 \u4e00.inc"):
            (self.place / include).write_text("#declare Green = <0, 1, 0>;\n", encoding="utf-8")
        (self.place / name).write_text(SCENE, encoding="utf-8")
        return name

    def render(self, *words, cwd=None):
        process = self.run_command(self.copy / "render", *words, "+W8", "+H6", cwd=cwd or self.place, env={"DISPLAY": ""})
        self.assert_succeeds(process)
        self.assertNotIn("Possible", process.stderr)
        return process.stderr.splitlines()[-1]

    def test_folder_and_scene(self):
        self.assertEqual(self.render(self.scene()), f"Picture: {self.place}/szene \u00f6.png")
        self.assertTrue((self.place / "szene \u00f6.png").is_file())
        self.assertEqual((self.place / "\u4e00.txt").read_text(encoding="utf-8"), "1")

    def test_folder_of_the_output(self):
        scene = self.place / self.scene()
        for option in (f'+O"{FOLDER}/"', f"+O{FOLDER}/", f"Output_File_Name={FOLDER}/"):
            self.render(scene, option, cwd=self.folder)
            (self.place / "szene \u00f6.png").unlink()
            self.assertEqual(sorted(os.listdir(self.folder)), sorted(["clone", FOLDER, "\u4e00.txt"]), option)

    def test_files_elsewhere(self):
        (self.folder / "other.inc").write_text("#declare Other = 1;\n")
        scene = self.scene()
        with open(self.place / scene, "a", encoding="utf-8") as stream:
            stream.write('#include "../other.inc"\n')
        refused = self.run_command(self.copy / "render", scene, "+W8", "+H6", cwd=self.place, env={"DISPLAY": ""})
        self.assertEqual(refused.returncode, 1, refused.stderr)
        self.assertIn("Not permitted: reading '../other.inc'", refused.stderr)
        for words in (("--unrestricted", scene), (scene, "--unrestricted"), (scene, f"+L{self.folder}")):
            self.assertEqual(self.render(*words), f"Picture: {self.place}/szene \u00f6.png")

    def test_names_in_an_ini_file(self):
        self.scene()
        (self.place / "\u00fc.ini").write_text('Output_File_Name="\u00e4.png"\n', encoding="utf-8")
        self.assertEqual(self.render("szene \u00f6.pov", "\u00fc.ini"), f"Picture: {self.place}/\u00e4.png")

    def test_bytes_outside_utf_8(self):
        scene = os.fsdecode(b"latin\xe4.pov")
        self.scene(scene)
        self.render(scene)
        self.assertTrue((self.place / os.fsdecode(b"latin\xe4.png")).is_file())

    def test_first_character(self):
        self.scene("\u00f6st.pov")
        self.povray("+I\u00f6st.pov", "+O\u00f6.png")
        self.assertTrue((self.place / "\u00f6.png").is_file())
        (self.place / "\u00fc.ini").write_text("\u00f6st.pov\n+O\U0001f600.png\n", encoding="utf-8")
        self.povray("\u00fc.ini")
        self.assertTrue((self.place / "\U0001f600.png").is_file())

    def povray(self, *words):
        self.assert_succeeds(self.run_command(BUILD / "bin" / "povray", *words, "+W8", "+H6", "-D", cwd=self.place))

    def long_path(self, letter, length):
        path, last = os.fsencode(self.folder), 60
        letter = letter.encode()
        while len(path) + 1 + last < length:
            part = letter * (min(200, length - len(path) - 2 - last) // len(letter))
            path += b"/" + (part or b"d" * (length - len(path) - 2 - last))
        os.makedirs(path, exist_ok=True)
        return os.fsdecode(path + b"/" + b"n" * (length - len(path) - 5) + b".pov")

    def test_names_of_any_length(self):
        for letter in ("a", "\u00e4", "\U0001f600"):
            for length in (200, 203, 204, 255, 256, 400, 511, 512, 1023, 1024, 2047, 2048, 4095):
                with self.subTest(letter=letter, length=length):
                    scene = self.long_path(letter, length)
                    self.assertEqual(len(os.fsencode(scene)), length)
                    shutil.copy(self.place / self.scene(), scene)
                    self.povray(f'+I"{scene}"', "+Oout.png")
                    (self.place / "out.png").unlink()
                    os.unlink(scene)

    def test_long_names_of_other_files(self):
        scene = pathlib.Path(self.long_path("\u00e4", 3000))
        shutil.copy(self.place / self.scene(), scene)
        for include in ("gr\u00fcn.inc", "\u00c4 \u4e00.inc"):
            (self.place / include).rename(scene.parent / include)
        settings = scene.with_name("s.ini")
        settings.write_text(f'Input_File_Name="{scene}"\nOutput_File_Name="{scene.with_suffix(".png")}"\n', encoding="utf-8")
        written = scene.with_name("written.ini")
        self.povray(f'"{settings}"', f'+L"{scene.parent}"', f'+GI"{written}"')
        self.assertTrue(scene.with_suffix(".png").is_file())
        self.assertIn(f'Input_File_Name="{scene}"', written.read_text(encoding="utf-8"))
        missing = self.long_path("a", 3000)
        said = self.run_command(BUILD / "bin" / "povray", f'+I"{missing}"', "-D", "+Oout.png", cwd=self.place)
        self.assertEqual(said.returncode, 1, said.stderr)
        self.assertIn(f"Cannot find file '{missing}'", said.stderr.replace("\n", ""))

    def test_long_names_in_messages(self):
        for length in (1000, 1024, 2048, 4000):
            name = "/".join(["a" * 99] * 40)[: length - 2] + "/b"
            written = "concat(" + ", ".join(f'"{name[i:i + 80]}"' for i in range(0, len(name), 80)) + ")"
            for line in (
                f"#include {written}",
                f"#fopen F {written} read",
                f"#fopen F {written} write",
                f"camera {{ location -4*z look_at 0 tilt_lens {{ prescription {written} }} }}",
                f"plane {{ y, 0 pigment {{ image_map {{ png {written} }} }} }}",
            ):
                with self.subTest(length=length, line=line[:16]):
                    (self.place / "long.pov").write_text(f"#version 3.7; global_settings {{ assumed_gamma 1 }}\n{line}\n")
                    said = self.run_command(BUILD / "bin" / "povray", "+Ilong.pov", "-D", "+Oout.png", cwd=self.place)
                    self.assertEqual(said.returncode, 1, said.stderr)
                    self.assertIn(name, re.sub(r"\s", "", said.stderr))

    def test_deep_folder(self):
        scene = pathlib.Path(self.long_path("ordner", 600))
        shutil.copy(self.place / self.scene(), scene)
        for include in ("gr\u00fcn.inc", "\u00c4 \u4e00.inc"):
            shutil.copy(self.place / include, scene.parent)
        self.assertEqual(self.render(scene.name, cwd=scene.parent), f"Picture: {scene.with_suffix('.png')}")

    def test_line_break(self):
        self.assertEqual(self.render(self.scene("a\nb.pov")), f"Picture: $'{self.place}/a\\nb.png'")


class Signals(RenderTest):
    def stopped(self, send):
        (self.place / "s.pov").write_text(SLOW, encoding="utf-8")
        state = self.place / "s.pov-state"
        state.unlink(missing_ok=True)
        with subprocess.Popen(
            [self.copy / "render", "s.pov", "+W640", "+H480", "Declare=A=1"],
            cwd=self.place,
            text=True,
            stdin=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
            start_new_session=True,
            env={**os.environ, "DISPLAY": ""},
        ) as process:
            deadline = time.monotonic() + PATIENCE
            while not (state.exists() and state.stat().st_size > 2000):
                if process.poll() is not None or time.monotonic() > deadline:
                    process.terminate()
                    self.fail(f"nothing was rendered: {process.stderr.read()[-500:]}")
                time.sleep(0.05)
            send(process.pid)
            said = process.stderr.read()
        self.assertEqual(self.left(), [], "povray runs on")
        return process.returncode, [line for line in said.splitlines() if line.strip()]

    def left(self):
        found = []
        for name in filter(str.isdigit, os.listdir("/proc")):
            try:
                if os.readlink(f"/proc/{name}/cwd") == str(self.place):
                    found.append(name)
            except OSError:
                pass
        return found

    def check(self, send, code):
        returned, said = self.stopped(send)
        self.assertEqual(returned, code, said[-4:])
        self.assertIn("Render cancelled by user", said)
        self.assertEqual(
            shlex.split(said[-1].partition("to go on: ")[2]), [f"{self.copy}/render", "s.pov", "+W640", "+H480", "Declare=A=1", "+C"]
        )

    def test_ctrl_c_reaches_all_at_once(self):
        self.check(lambda number: os.killpg(number, signal.SIGINT), -signal.SIGINT)

    def test_signals_to_the_wrapper_alone_are_handed_on(self):
        for number in (signal.SIGTERM, signal.SIGHUP):
            with self.subTest(number):
                self.check(lambda wrapper, number=number: os.kill(wrapper, number), -number)

    def test_povray_killed(self):
        def kill(wrapper):
            children = subprocess.run(["pgrep", "-P", str(wrapper)], capture_output=True, text=True, check=True).stdout.split()
            os.kill(int(children[0]), signal.SIGKILL)

        code, said = self.stopped(kill)
        self.assertEqual(code, 137)
        self.assertIn("povray was ended by signal 9.", said)
        self.assertTrue(said[-1].endswith(" +C"), said[-1])


if __name__ == "__main__":
    unittest.main()

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The program finds its files: built, installed, moved."""

import hashlib
import json
import re
import shutil
import unittest

from tests.setup.scratch import BUILD, CMAKE, POVRAY, REPOSITORY, SCENE, SetupTest


class ProgramTest(SetupTest):
    def setUp(self):
        super().setUp()
        self.home = self.folder / "home"
        self.home.mkdir()
        (self.folder / "scene.pov").write_text(SCENE, encoding="utf-8")

    def povray(self, program, *options, **environment):
        return self.run_command(program, *options, env={"HOME": str(self.home), **environment})

    def assert_renders(self, program):
        picture = self.folder / "scene.png"
        picture.unlink(missing_ok=True)
        process = self.povray(program, "+Iscene.pov", "+W16", "+H12", "-D")
        self.assert_succeeds(process)
        self.assertNotIn("cannot open an INI file", process.stderr)
        self.assertNotIn("cannot open the system configuration file", process.stderr)
        self.assertNotIn("I/O restrictions are disabled", process.stderr)
        self.assertTrue(picture.read_bytes().startswith(b"\x89PNG"))


class Program(ProgramTest):
    def test_renders_from_another_folder(self):
        self.assert_renders(POVRAY)

    def test_renders_through_a_link(self):
        link = self.folder / "povray-link"
        link.symlink_to(POVRAY)
        self.assert_renders(link)

    def test_include_files_are_found_beside_another_ini(self):
        (self.folder / "povray.ini").write_text("Width=8\n", encoding="utf-8")
        self.assert_renders(POVRAY)

    def test_version_line(self):
        said = self.povray(POVRAY, "--version").stderr
        self.assertIn("unofficial", said)
        self.assertIn("povray-tilt-lens", said)
        self.assertIn("patch series", said)
        self.assertNotIn(str(REPOSITORY), said)

    def test_state_files_name_its_sources(self):
        sources = sorted((path for ending in ("cpp", "h") for path in (REPOSITORY / "povray-src").rglob(f"*.{ending}")), key=str)
        hashes = "".join(hashlib.sha256(path.read_bytes()).hexdigest() + "\n" for path in sources)
        self.assertIn(b", sources " + hashlib.sha256(hashes.encode()).hexdigest().encode(), POVRAY.read_bytes())

    def test_all_picture_formats_and_the_preview_are_in(self):
        said = self.povray(POVRAY, "--version").stderr
        for word in ("png", "jpeg", "tiff", "openexr", "SDL"):
            self.assertIn(word, said)
        self.assertRegex(said, r"Unsupported image formats: -\n")


class Preview(ProgramTest):
    """The first window loads SDL and some thirty libraries."""

    def render(self, display, **environment):
        process = self.povray(POVRAY, "+Iscene.pov", "+W16", "+H12", display, "-P", SDL_VIDEODRIVER="dummy", **environment)
        self.assert_succeeds(process)
        self.assertTrue((self.folder / "scene.png").read_bytes().startswith(b"\x89PNG"))
        return process.stderr

    def test_is_loaded_for_a_window_only(self):
        self.assertIn("libSDL", self.render("+D", LD_DEBUG="files"))
        self.assertNotIn("libSDL", self.render("-D", LD_DEBUG="files"))

    def test_without_the_library_the_picture_is_rendered(self):
        (self.folder / "libSDL-1.2.so.0").write_text("no library", encoding="utf-8")
        folder = {"LD_LIBRARY_PATH": str(self.folder)}
        self.assertRegex(self.render("+D", **folder), r"Couldn't initialize SDL: .*libSDL-1\.2\.so\.0.*\n")
        self.assertNotIn("SDL", self.render("-D", **folder))

    def test_a_window_opens(self):
        self.assertNotIn("SDL", self.render("+D"))


class Hardening(SetupTest):
    def said(self, *words):
        return self.run_command("readelf", *words, POVRAY).stdout

    def test_checks_are_compiled_in(self):
        symbols = self.said("--dyn-syms", "--wide")
        self.assertRegex(symbols, r"__stack_chk_fail")
        self.assertRegex(symbols, r"__(memcpy|strcpy|snprintf|vsnprintf)_chk")
        self.assertIn("BIND_NOW", self.said("--dynamic"))
        self.assertIn("GNU_RELRO", self.said("--program-headers", "--wide"))


class Arithmetic(SetupTest):
    """Without fused multiplication and addition, all processors give the same pixels."""

    COMPUTING = re.compile(r" -o CMakeFiles/(?:tilt_lens|povray|povray_core|povray_own|povray_vfe)\.dir/")

    def test_no_file_is_compiled_with_fused_multiply_add(self):
        commands = [entry["command"] for entry in json.loads((BUILD / "compile_commands.json").read_text(encoding="utf-8"))]
        commands = [command for command in commands if self.COMPUTING.search(command)]
        self.assertGreater(len(commands), 100)
        self.assertEqual([command for command in commands if "-ffp-contract=off" not in command], [])


class Install(ProgramTest):
    def install(self, prefix, env=None):
        process = self.run_command(CMAKE, "--install", BUILD, "--prefix", prefix, env=env)
        self.assert_succeeds(process)

    def test_prefix_then_moved(self):
        prefix = self.folder / "prefix"
        self.install(prefix)
        for name in (
            "bin/povray",
            "share/povray-3.7/include/colors.inc",
            "share/povray-3.7/ini/quickres.ini",
            "etc/povray/3.7/povray.conf",
            "etc/povray/3.7/povray.ini",
            "share/man/man1/povray.1",
        ):
            self.assertTrue((prefix / name).is_file(), name)
        ini = (prefix / "etc/povray/3.7/povray.ini").read_text(encoding="utf-8")
        self.assertIn(f'Library_Path="{prefix}/share/povray-3.7/include"', ini)
        for name in ("etc/povray/3.7/povray.conf", "etc/povray/3.7/povray.ini"):
            self.assertNotIn(str(REPOSITORY), (prefix / name).read_text(encoding="utf-8"))
        self.assert_renders(prefix / "bin" / "povray")
        moved = self.folder / "moved"
        shutil.move(prefix, moved)
        self.assert_renders(moved / "bin" / "povray")

    def test_destdir(self):
        self.install("/opt/tilt", env={"DESTDIR": str(self.folder / "stage")})
        ini = self.folder / "stage/opt/tilt/etc/povray/3.7/povray.ini"
        self.assertIn('"/opt/tilt/share/povray-3.7/include"', ini.read_text(encoding="utf-8"))
        self.assertTrue((self.folder / "stage/opt/tilt/bin/povray").is_file())


if __name__ == "__main__":
    unittest.main()

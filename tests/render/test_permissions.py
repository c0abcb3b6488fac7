# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Forbidden files are refused and unchanged."""

import os
import pathlib
import shutil
import tempfile

from tests.render import rendering, scenes
from tools import povray_run
from tools.repository import ROOT

LENS = ROOT / "scenes" / "include" / "lenses" / "tronnier_gauss_50.dat"

WAYS_TO_READ = (
    '#include "{outside}/file.inc"',
    '#include "../outside/file.inc"',
    '#include "../outside/file"',
    '#include "./sub/.././../outside/file.inc"',
    '#include "/{outside}/file.inc"',
    '#include "{outside}//file.inc"',
    '#include "to_outside/file.inc"',
    '#include "sub/to_outside/file.inc"',
    '#include "link.inc"',
    '#include "/proc/self/cwd/../outside/file.inc"',
    '#include "/proc/self/root{outside}/file.inc"',
    '#include "/proc/thread-self/cwd/to_outside/file.inc"',
    '#include concat("..", "/outside/file.inc")',
    '#include "{outside}/../own folder/../outside/file.inc"',
    '#include ".hidden.inc"',
    '#include ".hidden/file.inc"',
    '#include "../own folder and more/file.inc"',  # begins as the name of the permitted folder
    '#include "../OWN FOLDER/file.inc"',
    '#fopen F "../outside/file.inc" read',
    '#declare A = file_exists("../outside/file.inc");',
    'plane {{ z, 9 pigment {{ image_map {{ png "../outside/file.png" }} }} }}',
    'plane {{ z, 9 pigment {{ rgb 1 }} normal {{ bump_map {{ png "../outside/file.png" }} }} }}',
    'height_field {{ png "../outside/file.png" }}',
    'plane {{ z, 9 pigment {{ density_file df3 "../outside/file.df3" }} }}',
    'text {{ ttf "../outside/file.ttf" "a", 1, 0 }}',
    'camera {{ location -9*z look_at 0 tilt_lens {{ prescription "../outside/lens.dat" }} }}',
    'global_settings {{ photons {{ count 100 load_file "../outside/file.inc" }} }}',
)
WAYS_TO_WRITE = (
    '#fopen F "{outside}/new.txt" write',
    '#fopen F "../outside/new.txt" write',
    '#fopen F "../outside/file.inc" write',
    '#fopen F "../outside/file.inc" append',
    '#fopen F "../new.txt" write',
    '#fopen F "sub/new.txt" write',
    '#fopen F "to_outside/new.txt" write',
    '#fopen F "link.inc" append',
    '#fopen F "link_to_new.txt" write',
    '#fopen F "hard_link.inc" append',
    '#fopen F "//{outside}/new.txt" write',
    '#fopen F "/proc/self/cwd/../outside/new.txt" write',
    '#fopen F "/proc/self/root{outside}/new.txt" write',
    '#fopen F concat("../out", "side/new.txt") write',
    '#fopen F ".profile" write',
    '#fopen F "povray.ini" write',
    '#fopen F "New.INI" write',
    '#fopen F "program" append',
    '#fopen F "{prefix}/bin/povray" append',
    '#fopen F "{prefix}/share/povray-3.7/include/colors.inc" append',
    '#fopen F "{prefix}/etc/povray/3.7/povray.conf" append',
    'global_settings {{ photons {{ count 100 save_file "../outside/new.txt" }} }}',
)


def prefix():
    return pathlib.Path(os.path.realpath(rendering.SETTINGS.povray)).parents[1]


def told(text):
    return " ".join(text.split("Support libraries used by POV-Ray", 1)[-1].split())


class Permissions(rendering.RenderTest):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory(prefix="tilt_lens.")
        self.addCleanup(scratch.cleanup)
        self.top = pathlib.Path(os.path.realpath(scratch.name))
        self.own, self.outside = self.top / "own folder", self.top / "outside"
        for folder in (self.own / "sub", self.own / ".hidden", self.outside, self.top / "own folder and more", self.top / "OWN FOLDER"):
            folder.mkdir(parents=True)
            self.fill(folder)
        self.fill(self.own)
        (self.own / ".hidden.inc").write_text("// not to be read\n")
        (self.own / "to_outside").symlink_to(self.outside)
        (self.own / "sub" / "to_outside").symlink_to("../../outside")
        (self.own / "link.inc").symlink_to(self.outside / "file.inc")
        (self.own / "link_to_new.txt").symlink_to(self.outside / "new.txt")
        (self.own / "hard_link.inc").hardlink_to(self.outside / "file.inc")
        (self.own / "program").write_text("#!/bin/sh\n")
        (self.own / "program").chmod(0o755)

    @staticmethod
    def fill(folder):
        for source, name in (("povlogo.ttf", "file.ttf"), ("plasma2.png", "file.png"), ("spiral.df3", "file.df3")):
            shutil.copy(prefix() / "share" / "povray-3.7" / "include" / source, folder / name)
        (folder / "file.inc").write_text("#declare Found = 1;\n")
        shutil.copy(LENS, folder / "lens.dat")

    def words(self, line):
        return line.format(outside=self.outside, own=self.own, prefix=prefix())

    def attempt(self, line, *options):
        code, said = rendering.Job(scenes.TILTED + self.words(line) + "\n", options, width=8, height=6).attempt(self.own)
        return code, told(said)

    def files(self):
        return {
            path: path.read_bytes()
            for path in self.top.rglob("*")
            if path.is_file() and path.name not in ("scene.pov",) and not path.name.startswith("picture.")
        }

    def refused(self, line, deed):
        before = self.files()
        code, said = self.attempt(line)
        self.assertEqual(code, 1, said)
        number = len((rendering.HEAD + scenes.TILTED).splitlines()) + 1
        self.assertIn(f"File 'scene.pov' line {number}: Parse Error: Not permitted: {deed} '", said)
        self.assertIn("--unrestricted", said)
        self.assertEqual(said.count("Not permitted"), 1, said)
        self.assertEqual(self.files(), before)
        return said

    def test_ways_to_read(self):
        for line in WAYS_TO_READ:
            with self.subTest(line):
                self.refused(line, "reading")

    def test_ways_to_write(self):
        for line in WAYS_TO_WRITE:
            with self.subTest(line):
                self.refused(line, "writing")

    def call(self, folder, line, *options, home=None):
        (self.own / "scene.pov").write_text(rendering.HEAD + scenes.TILTED + self.words(line) + "\n")
        command = povray_run.command(rendering.SETTINGS.povray, self.own / "scene.pov", "", (8, 6), *options)
        done = povray_run.run(command, folder, povray_run.user_environment(HOME=str(home or self.top)))
        return done.code, told(done.said)

    def test_permitted(self):
        more = f"+L{self.outside}"
        for line, *options in (
            ('#include "file.inc"',),
            ('#include "sub/file.inc"',),
            ('#include "{outside}/../own folder/sub/file.inc"',),
            ('#include "/proc/self/cwd/file.inc"',),
            ('#include "../outside/file.inc"', more),
            ('#include "link.inc"', more),
            ('#fopen F "../outside/file.inc" read', more),
            ('#include "colors.inc"',),
            ('#include "tilt_lens.inc"',),
            ('text {{ ttf "/usr/share/fonts/truetype/povray/crystal.ttf" "a", 1, 0 }}',),
            ('text {{ ttf "timrom.ttf" "a", 1, 0 }}',),
            ('text {{ internal 1 "a", 1, 0 }}',),
            ('plane {{ z, 9 pigment {{ image_map {{ png "plasma2.png" }} }} }}',),
            ('plane {{ z, 9 pigment {{ density_file df3 "sub/file.df3" }} }}',),
            ('camera {{ location -9*z look_at 0 tilt_lens {{ prescription "sub/lens.dat" }} }}',),
            ('camera {{ location -9*z look_at 0 tilt_lens {{ prescription "lenses/zeiss_master_prime_100.json" }} }}',),
            (
                '#fopen F "new.txt" write #write (F, 1, ",") #fclose F #fopen F "new.txt" append #write (F, 2, ",") #fclose F '
                '#fopen F "{own}/new.txt" read #read (F, A, B) #if (A + B != 3) #error "lost" #end',
            ),
            ('#fopen F "stdout" write',),
        ):
            with self.subTest(line):
                code, said = self.call(self.own, line, "+Opicture.png", *options)
                self.assertEqual(code, 0, said)

    def test_a_folder_that_does_not_exist(self):
        code, said = self.attempt('#fopen F "nowhere/../../outside/new.txt" write')
        self.assertEqual(code, 1, said)
        self.assertIn("Parse Error: Cannot open 'nowhere/../../outside/new.txt", said)
        self.assertIn("for writing: No such file or directory.", said)

    def test_other_current_folder(self):
        """Names begin in the current folder; nothing is written below it."""
        (self.outside / "sub").mkdir()
        self.fill(self.outside / "sub")
        (self.outside / "sub" / "new.inc").touch()
        for line, permitted in (
            ('#include "file.inc"', True),
            ('#include "sub/new.inc"', True),
            ('#fopen F "new.txt" write', True),
            ('#fopen F "sub/new.txt" write', False),
            ('#fopen F "{own}/new.txt" write', False),
        ):
            with self.subTest(line):
                code, said = self.call(self.outside, line, "+Opicture.png")
                self.assertEqual(code, 0 if permitted else 1, said)
                self.assertEqual("Not permitted" in said, not permitted, said)

    def test_folder_of_the_picture(self):
        for options, permitted in (
            (("+O../outside/",), True),
            (("+O../outside/picture.png",), True),
            (("+Opicture.png",), False),
            (("+O../outside/picture", "+KFF2"), True),
            (("-F",), False),
        ):
            with self.subTest(options):
                code, said = self.call(self.own, '#fopen F "../outside/new.txt" write', *options)
                self.assertEqual(code, 0 if permitted else 1, said)

    def test_never_in_the_program(self):
        for folder in (ROOT, prefix(), prefix() / "share" / "povray-3.7" / "include"):
            with self.subTest(folder):
                code, said = self.call(self.own, f'#fopen F "{folder}/new.txt" write', f"+O{folder}/", "+FN", "-F")
                self.assertEqual(code, 1, said)
                self.assertFalse((folder / "new.txt").exists())
                self.assertIn("writing '", said)
        code, said = self.call(ROOT, '#fopen F "new.txt" write', f'+O"{self.own}/"')
        self.assertEqual(code, 1, said)
        self.assertIn(f"no scene writes into the program's own folder '{ROOT}'", said)
        self.assertFalse((ROOT / "new.txt").exists())

    def test_lifted(self):
        for line in ('#fopen F "../outside/new.txt" write', '#include "{outside}/file.inc"'):
            code, said = self.call(self.own, line, "+Opicture.png")
            self.assertEqual(code, 1, said)
            code, said = self.call(self.own, line, "--unrestricted", "+Opicture.png")
            self.assertEqual(code, 0, said)
        (self.own / "povray.ini").write_text("unrestricted=on\n")  # INI files come with scenes, and permit nothing
        self.assertEqual(self.call(self.own, "", "+Opicture.png")[0], 1)

    def test_stricter_by_the_user(self):
        settings = self.top / "home" / ".povray" / "3.7" / "povray.conf"
        settings.parent.mkdir(parents=True)
        for text, line, permitted in (
            ("[File I/O Security]\nnone\n", '#include "../outside/file.inc"', False),
            ("[File I/O Security]\nrestricted\n[Permitted Paths]\nread = {outside}\n", '#include "../outside/file.inc"', True),
            ("[File I/O Security]\nrestricted\n[Permitted Paths]\nread = {outside}\n", '#fopen F "../outside/a" write', False),
            ("[File I/O Security]\nrestricted\n[Permitted Paths]\nread+write = {outside}\n", '#fopen F "../outside/a" write', True),
        ):
            with self.subTest(text, line=line):
                settings.write_text(text.format(outside=self.outside))
                code, said = self.call(self.own, line, "+Opicture.png", home=self.top / "home")
                self.assertEqual(code, 0 if permitted else 1, said)


if __name__ == "__main__":
    rendering.main()

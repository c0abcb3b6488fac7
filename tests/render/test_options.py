# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Options that leave nothing to render are refused."""

import os
import pathlib
import tempfile
import unittest.mock

from tests.render import rendering, scenes

STOCK = "camera { location -4*z look_at 0 } sphere { 0, 1 pigment { rgb 1 } finish { emission 0.5 } }\n"


def run(scene, *options):
    with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
        code, said = rendering.Job(scene, options).attempt(pathlib.Path(name))
        return code, said, sorted(path.name for path in pathlib.Path(name).iterdir())


class Refused(rendering.RenderTest):
    def check(self, options, message):
        for scene in (scenes.TILTED, STOCK):
            with self.subTest(options=options, stock=scene is STOCK):
                code, said, files = run(scene, *options)
                self.assertEqual(code, 1, said)
                self.assertEqual(said.count(message), 1, said)
                self.assertEqual(files, ["scene.pov"], said)

    def test_end_before_start(self):
        self.check(("+SC50", "+EC20"), "Start_Column=50 and End_Column=20 mean columns 50 to 20 of 64.")
        self.check(("+SR40", "+ER10"), "Start_Row=40 and End_Row=10 mean rows 40 to 10 of 48.")
        self.check(("+SC0.9", "+EC0.1"), "Start_Column=0.9 and End_Column=0.1 mean columns 58 to 6 of 64.")

    def test_beyond_the_picture(self):
        self.check(("+EC65",), "Start_Column=1 and End_Column=65 mean columns 1 to 65 of 64.")
        self.check(("+SR-3",), "Start_Row=-3 and End_Row=48 mean rows -3 to 48 of 48.")
        self.check(("+ER0.001",), "Start_Row=1 and End_Row=0.001 mean rows 1 to 0 of 48.")

    def test_no_size(self):
        self.check(("+W-5",), "Width=-5 (+W-5). A whole number of at least 1 is allowed")
        self.check(("+H0",), "Height=0 (+H0). A whole number of at least 1 is allowed")

    def test_no_threads(self):
        self.check(("+WT0",), "Work_Threads=0 (+WT0). A whole number of at least 1 is allowed")

    def test_no_blocks(self):
        self.check(("+BS3",), "Render_Block_Size=3 (+BS3). A whole number of at least 4 is allowed")

    def test_gamma(self):
        self.check(("File_Gamma=0.0001",), "File_Gamma=0.0001. A number of at least 0.001, or sRGB, is allowed")
        self.check(("Display_Gamma=0.0001",), "Display_Gamma=0.0001. A number of at least 0.001, or sRGB, is allowed")

    def test_last_frame_before_the_first(self):
        self.check(("+KFI5", "+KFF2"), "Initial_Frame=5 (+KFI) and Final_Frame=2 (+KFF): the last frame lies before the first.")

    def test_words(self):
        for word, said in (
            ("Width=abc", "'Width=abc': Width takes a whole number."),
            ("Antialias_Threshold=x", "'Antialias_Threshold=x': Antialias_Threshold takes a number."),
            ("File_Gamma=0", "'File_Gamma=0': File_Gamma takes a number above 0, or sRGB."),
            ("Output_File_Type=Q", "'Output_File_Type=Q': Output_File_Type takes one of the letters B (BMP)"),
            ("Dither_Method=Q", "'Dither_Method=Q': Dither_Method takes one of B2, B3"),
            ("Foo=1", "'Foo=1': there is no option 'Foo'. povray(1) lists all options."),
            ("Widht=1", "'Widht=1': there is no option 'Widht', but Width."),
            ("+A-1", "'+A-1': there is no such option. With its first letter there are +AG with a number above 0"),
            ("+Wabc", "'+Wabc': +W takes a whole number."),
            ("+W", "'+W': +W takes a whole number, directly behind it."),
            ("+W10.7", "'+W10.7': +W takes a whole number."),
            ("+H1e2", "'+H1e2': +H takes a whole number."),
            ("Width=0x10", "'Width=0x10': Width takes a whole number."),
            ("Clock=1,5", "'Clock=1,5': Clock takes a number."),
            ("+K1,5", "'+K1,5': +K takes a number."),
            ("Clock=nan", "'Clock=nan': Clock takes a number."),
            ("Antialias=maybe", "'Antialias=maybe': Antialias takes on or off."),
            ("Declare=A", "'Declare=A': Declare takes NAME=NUMBER, or 'NAME=\"TEXT\"' with both marks."),
            ("Declare=A=", "'Declare=A=': Declare takes NAME=NUMBER"),
            ("Declare==3", "'Declare==3': Declare takes NAME=NUMBER"),
            ("Declare=3=4", "'Declare=3=4': Declare takes NAME=NUMBER"),
            ("Declare=A=x", "'Declare=A=x': Declare takes NAME=NUMBER"),
            ("+FQ", "'+FQ': +F takes one of the letters B (BMP)"),
            ("+\u00e4", "'+\u00e4': there is no such option. povray(1) lists all options."),
            ("nofile.ini", "'nofile.ini' cannot be read as an INI file (No such file or directory)."),
            ("scene", "'scene' cannot be read as an INI file (No such file or directory)."),
        ):
            self.check((word,), said)

    def test_lines_of_ini_files(self):
        for text, said in (
            ("Width=abc", "line 2: 'Width=abc': Width takes a whole number."),
            ('Declare=A="x y"', "line 2: 'Declare=A=\"x y\"': Declare takes NAME=NUMBER"),
            ("  Foo = 1 ; nothing", "line 2: 'Foo = 1 ; nothing': there is no option 'Foo'."),
            ("+A-1", "line 2: '+A-1': there is no such option."),
        ):
            with self.subTest(text), tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
                (pathlib.Path(name) / "own.ini").write_text(f"; first line\n{text}\n")
                code, told = rendering.Job(STOCK, ("own.ini",)).attempt(pathlib.Path(name))
                self.assertEqual(code, 1, told)
                self.assertEqual(told.count(f"File 'own.ini' {said}"), 1, told)


class Allowed(rendering.RenderTest):
    def test_limits(self):
        for options in (("+SC64", "+EC64"), ("+SC0.99", "+EC1"), ("+SR48", "+ER48"), ("+SC0", "+EC0.02"), ("+WT1",)):
            with self.subTest(options=options):
                code, said, _ = run(STOCK, *options)
                self.assertEqual(code, 0, said)

    def test_values(self):
        scene = STOCK + '#if (A != -1500 | strcmp(B, "x y") != 0) #error "otherwise declared" #end'
        code, said, _ = run(
            scene,
            "+A0.3",
            "+J0.5",
            "-J",
            "+SC0.25",
            "Clock=-1.5e3",
            "+K.5",
            "Antialias=On",
            "Jitter=0",
            "Width=+64",
            "Declare=A=-1.5e3",
            "Declare='B=\"x y\"'",
            "File_Gamma=sRGB",
            "+MB",
            "+R3",
        )
        self.assertEqual(code, 0, said)
        with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
            (pathlib.Path(name) / "own.ini").write_text(
                "Width = 64  ; pixels\nHeight=48\t\r\nAntialias=Yes # or no\nDeclare=A=-1500\nDeclare='B=\"x y\"'\n"
            )
            code, said = rendering.Job(scene, ("own.ini",)).attempt(pathlib.Path(name))
            self.assertEqual(code, 0, said)


class Quiet(rendering.RenderTest):
    def test_no_settings_of_the_user(self):
        with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name, unittest.mock.patch.dict(os.environ, {"HOME": name}):
            for home in (name, f"{name}/nothing"):
                with unittest.mock.patch.dict(os.environ, {"HOME": home}):
                    code, said, _ = run(STOCK)
                    self.assertEqual(code, 0, said)
                    self.assertNotIn("cannot open the user configuration file", said)

    def test_pause_without_terminal_and_display(self):
        with unittest.mock.patch.dict(os.environ):
            for name in ("DISPLAY", "WAYLAND_DISPLAY"):
                os.environ.pop(name, None)
            for options in (("+P", "+D"), ("+P", "+D", "+KFF2")):
                code, said, _ = run(STOCK, *options)
                self.assertEqual(code, 0, said)


if __name__ == "__main__":
    rendering.main()

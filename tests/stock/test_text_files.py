# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Text of #include, macros, loops and #read equals the unpatched program's."""

import argparse
import pathlib
import tempfile
import unittest

from tests.render import rendering

PROGRAMS = argparse.Namespace(stock="/usr/bin/povray", fork="povray")
TOLD = '#macro Told(S) #debug concat("TOLD ", S, "\\n") #end\n'


def told(program, scene, files):
    rendering.SETTINGS.povray = program
    with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
        folder = pathlib.Path(name)
        for path, text in files.items():
            (folder / path).write_bytes(text.encode())
        _, said = rendering.Job(scene, ("-F", "+WT1", "All_Console=On"), width=4, height=3).attempt(folder)
        return [line for line in said.splitlines() if "TOLD" in line or "Error:" in line]


class TextFiles(unittest.TestCase):
    def check(self, scene, expected, **files):
        files = {f"{name}.inc": text for name, text in files.items()}
        stock, fork = (told(program, TOLD + scene, files) for program in (PROGRAMS.stock, PROGRAMS.fork))
        self.assertEqual(fork, stock, scene)
        self.assertEqual(fork, [f"TOLD {line}" for line in expected], scene)

    def test_macro_of_another_file(self):
        self.check(
            '#include "a.inc"\n#for (I, 1, 5) A(I) #end Told("end")\n',
            ["1", "2", "3", "4", "5", "end"],
            a="// one\n#macro A(I)\n  Told(str(I, 0, 0))\n#end\n",
        )

    def test_last_of_its_file(self):
        for end in ("\n", "\r\n", "\r"):
            with self.subTest(end=end):
                self.check(
                    f'#include "a.inc"{end}#for (I, 1, 4) A(I) #end{end}',
                    ["1", "2", "3", "4"],
                    a=f"#macro A(I){end} Told(str(I, 0, 0)){end}#end",
                )

    def test_first_of_its_file(self):
        self.check('#include "a.inc"\nA()\nA()\n', ["a", "a"], a='#macro A() Told("a") #end')

    def test_macros_of_two_files_call_each_other(self):
        self.check(
            '#include "a.inc"\n#include "b.inc"\nA(5)\nB(2)\n',
            ["a5", "b4", "a3", "b2", "a1", "b2", "a1"],
            a='#macro A(N) Told(concat("a", str(N, 0, 0))) #if (N > 1) B(N - 1) #end\n#end\n',
            b='#macro B(N)\n Told(concat("b", str(N, 0, 0)))\n#if (N > 1) A(N - 1) #end #end\n',
        )

    def test_a_file_within_itself_by_another(self):
        depth = 80
        self.check(
            f'#include "a.inc"\n#include "b.inc"\n#for (I, 1, 3) Told(str(A({depth}), 0, 0)) #end\n',
            [str(depth)] * 3,
            a="#macro A(N) #if (N > 0) (1 + B(N - 1)) #else 0 #end #end\n",
            b="#macro B(N) #if (N > 0) (1 + A(N - 1)) #else 0 #end #end\n",
        )

    def test_more_files_than_are_kept(self):
        files = {f"f{i}": f'#macro F{i}() Told("{i}") #end\n' for i in range(40)}
        once = "".join(f"F{i}()\n" for i in range(40))
        self.check("".join(f'#include "f{i}.inc"\n' for i in range(40)) + once + once, [str(i) for i in range(40)] * 2, **files)

    def test_error_in_a_macro_names_its_line(self):
        """Also the second time, with the file open."""
        scene, files = '#include "a.inc"\nA(1)\nA(0)\n', {"a.inc": '\n\n#macro A(N)\n #if (N = 0)\n  #error "none"\n #end\n#end\n'}
        stock, fork = (told(program, scene, files) for program in (PROGRAMS.stock, PROGRAMS.fork))
        self.assertEqual(len(fork), 1)
        self.assertIn("'a.inc' line 5", fork[0])
        self.assertEqual([line.replace("Parse Error", "Error") for line in fork], [line.replace("Parse Error", "Error") for line in stock])

    def test_file_that_the_scene_writes_anew(self):
        self.check(
            '#macro Twice() Made() Made() #end\n#for (I, 1, 3)\n #fopen F "made.txt" write\n'
            ' #write (F, "#macro Made() Told(\\"", str(I, 0, 0), "\\") #end\\n")\n'
            ' #fclose F\n #include "made.txt"\n Twice()\n#end\n',
            ["1", "1", "2", "2", "3", "3"],
        )

    def test_file_that_the_scene_lengthens(self):
        self.check(
            '#fopen F "made.txt" write\n#write (F, "#macro One() Told(\\"one\\") #end\\n")\n#fclose F\n#include "made.txt"\n'
            'One()\n#fopen F "made.txt" append\nOne()\n#write (F, "#macro Two() Told(\\"two\\") #end\\n")\n#fclose F\n'
            '#include "made.txt"\nOne()\nTwo()\nTwo()\n',
            ["one", "one", "one", "two", "two"],
        )

    def test_loop_from_the_first_character(self):
        self.check('#declare I = 0;\n#include "a.inc"\n', ["0", "1"], a="#while (I < 2)\nTold(str(I, 0, 0))\n#declare I = I + 1;\n#end\n")

    def test_long_loop(self):
        """The loop is longer than the unpatched program's buffer."""
        filler = "// nothing but a comment, to make the loop long\n" * 40
        self.check(f"#declare I = 0;\n#while (I < 3)\n{filler}Told(str(I, 0, 0))\n{filler}#declare I = I + 1;\n#end\n", ["0", "1", "2"])

    def test_more_than_a_megabyte(self):
        filler = "// nothing but a comment, to make the file long\n" * 23000
        self.assertGreater(len(filler), 1 << 20)
        self.check(
            '#include "a.inc"\nA() B()\n#for (I, 1, 2) A() B() #end\n',
            ["a", "b"] * 3,
            a=f'#macro A() Told("a") #end\n{filler}#macro B() Told("b") #end\n',
        )

    def test_data(self):
        for end in ("\n", "\r\n", "\r"):
            with self.subTest(end=end):
                numbers = end.join("1, 2.5, -3e2," for _ in range(200)) + end + '"text"'
                self.check(
                    '#fopen F "a.inc" read\n#declare Sum = 0;\n#for (I, 1, 600) #read (F, X) #declare Sum = Sum + X; #end\n'
                    '#read (F, S)\nTold(str(Sum, 0, 3)) Told(S)\n#ifdef (F) #read (F, T) #end\nTold("end")\n',
                    ["-59300.000", "text", "end"],
                    a=numbers,
                )

    def test_empty_file(self):
        self.check('#include "a.inc"\n#include "a.inc"\nTold("end")\n', ["end"], a="")


def main():
    parser = argparse.ArgumentParser(add_help=False)
    parser.add_argument("--stock", required=True)
    parser.add_argument("--fork", required=True)
    _, rest = parser.parse_known_args(namespace=PROGRAMS)
    unittest.main(argv=["text_files", *rest])


if __name__ == "__main__":
    main()

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Manual, manual page and editors have the parser's items."""

import argparse
import functools
import json
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import unittest

from tests.parse import items
from tools import povray_run
from tools.povray_run import PATIENCE
from tools.repository import ROOT

EDITORS = ROOT / "editors"
SETTINGS = argparse.Namespace(povray="povray", parser=None)
BATCH_KINDS = re.compile(r"(\w+(?:\|\w+)+)")


UNITS = {"MM": "millimetres", "DEG": "degrees", "UNITS": "scene units", "PIXELS": "pixels"}
FOCUS_AIDS = ("focus_peaking", "focus_map", "show_planes")  # in a table of their own


@functools.cache
def table():
    return items.items(SETTINGS.parser)


def words():
    return sorted(item.word for item in table())


def manual():
    return (ROOT / "docs" / "manual.md").read_text()


def ranged():
    return [(item, number.range()) for item in table() for number in item.numbers[:1] if number.range()]


def grammar():
    return json.loads((EDITORS / "vscode" / "syntaxes" / "tilt-lens.injection.json").read_text())


def snippets():
    table = json.loads((EDITORS / "vscode" / "snippets" / "tilt-lens.json").read_text())
    return {name: re.sub(r"\$\{\d+:([^}]*)\}", r"\1", "\n".join(entry["body"])) for name, entry in table.items()}


class SameItems(unittest.TestCase):
    def check(self, place, found):
        self.assertEqual(sorted(found), words(), f"{place} does not have the items of the parser")

    def test_there_are_items(self):
        self.assertGreaterEqual(len(words()), 12)

    def test_manual_syntax(self):
        syntax = re.search(r"\nTILT_LENS_ITEM:\n(.*?)```", manual(), re.DOTALL)[1]
        self.check("the syntax summary of docs/manual.md", set(re.findall(r"(?:^|\|)\s*([a-z_]{4,})\b", syntax, re.MULTILINE)))
        for item in table():
            self.assertIn(f"{item.word} {item.values}".strip(), [" ".join(part.split()) for part in re.split(r" \|\s|\n", syntax)])

    def test_manual_table(self):
        rows = [[cell.strip() for cell in line.split("|")[1:-1]] for line in manual().split("\n") if re.match(r"\| \[`\w+`\]\(#", line)]
        self.check("the table of docs/manual.md", [word for row in rows for word in re.findall(r"`(\w+)`", row[0])] + list(FOCUS_AIDS))
        row_of = {word: row for row in rows for word in re.findall(r"`(\w+)`", row[0])}
        for item in table():
            if item.numbers and item.word not in FOCUS_AIDS:
                _, unit, _, limits = row_of[item.word]
                for placeholder in re.findall(r"[A-Z]{2,}", item.values):
                    self.assertIn(UNITS.get(placeholder, ""), unit, item)
                self.assertEqual(item.numbers[0].whole, unit.startswith("whole number"), item)
                self.assertIn(item.numbers[0].range() or "", limits, item)
                self.assertEqual(item.values == "on/off", limits.startswith("`on` or `off`"), item)

    def test_manual_sections(self):
        sections = {
            word: text
            for heading, text in re.findall(r"\n### ([a-z_, ]+)\n(.*?)(?=\n##)", manual(), re.DOTALL)
            for word in heading.split(", ")
        }
        self.assertEqual([word for word in words() if word not in sections], [])
        for item, limits in ranged():
            self.assertIn(limits, sections[item.word].replace("Larger", "larger"), item.word)

    def test_readme(self):
        rows = (ROOT / "README.md").read_text().split("## The items of `tilt_lens`", 1)[1].split("\n## ", 1)[0]
        cells = "\n".join(line.split("|")[1] for line in rows.split("\n") if line.startswith("| `"))
        self.assertEqual(sorted(re.findall(r"`([^`]+)`", cells)), sorted(f"{item.word} {item.values}".strip() for item in table()))

    def test_manual_page(self):
        page = (ROOT / "docs" / "man" / "povray-tilt-lens.7").read_text().replace("\\-", "-")
        entries = {
            re.match(r'\.BI? "?([a-z_]+)', entry)[1]: " ".join(entry.split())
            for entry in page.split(".SH ITEMS")[1].split(".SH QUALITY")[0].split("\n.TP\n")[1:]
        }
        self.check("docs/man/povray-tilt-lens.7", entries)
        for item, limits in ranged():
            self.assertIn(limits, entries[item.word].replace("Larger", "larger"), item.word)

    def test_vim(self):
        text = (EDITORS / "vim" / "after" / "syntax" / "pov.vim").read_text()
        lines = re.search(r"^syn keyword povTiltLensItem .*\n((?: +\\ .*\n)+)", text, re.MULTILINE)[1]
        self.check("the Vim file", lines.replace("\\", " ").split())

    def test_vscode(self):
        self.check("the grammar", re.search(r"\(([\w|]+)\)", grammar()["repository"]["item"]["match"])[1].split("|"))

    def test_every_item_has_a_snippet(self):
        text = "\n".join(snippets().values())
        self.assertEqual([item for item in words() if not re.search(rf"\b{item}\b", text)], [])


class Code(unittest.TestCase):
    def test_files(self):
        package = json.loads((EDITORS / "vscode" / "package.json").read_text())
        for entry in package["contributes"]["grammars"] + package["contributes"]["snippets"]:
            self.assertTrue((EDITORS / "vscode" / entry["path"]).is_file(), entry["path"])
        self.assertEqual(package["contributes"]["grammars"][0]["scopeName"], grammar()["scopeName"])

    def test_patterns(self):
        rules = grammar()["repository"]
        self.assertRegex("camera { tilt_lens { tilt 3 } }", rules["block"]["begin"])
        self.assertNotRegex("my_tilt_lens { }", rules["block"]["begin"])
        self.assertRegex("focus_tilt 3", rules["item"]["match"])
        self.assertNotRegex("tilted 3", rules["item"]["match"])
        self.assertRegex("Tilt_Lens_Miniature(A, B, 1)", rules["macro"]["match"])

    def test_a_snippet_for_an_item_is_no_block(self):
        table = json.loads((EDITORS / "vscode" / "snippets" / "tilt-lens.json").read_text())
        for entry in table.values():
            if entry["prefix"] in words():
                self.assertTrue(entry["body"][0].startswith(entry["prefix"]), entry)
                self.assertNotIn("tilt_lens", "".join(entry["body"]))

    def test_snippets_render(self):
        for name, text in snippets().items():
            if name.startswith("Item "):
                text = f"tilt_lens {{ scene_unit 1000  f_stop 4  {text} }}"
            if "camera" not in text:
                text = f"camera {{ right x*image_width/image_height location <0, 2, -6> look_at <0, 1, 0> {text} }}"
            scene = (
                "#version 3.7;\nglobal_settings { assumed_gamma 1 }\n#declare Ball = sphere { 0, 1 }\n"
                f"{text}\nsphere {{ <0, 1, 0>, 1 }}\n"
            )
            with tempfile.TemporaryDirectory(prefix="tilt_lens.") as folder:
                (pathlib.Path(folder) / "scene.pov").write_text(scene)
                command = povray_run.command(SETTINGS.povray, "scene.pov", None, (8, 6), library=[povray_run.INCLUDE])
                said = povray_run.run(command, folder).succeeded().said
            self.assertNotIn("Warning:", said, f"{name}\n{scene}")


class Completion(unittest.TestCase):
    def offered(self, line, folder=ROOT):
        words = line if isinstance(line, list) else line.split(" ")
        script = (
            f". '{EDITORS / 'bash' / 'povray-tilt-lens.bash'}'\n"
            f"COMP_WORDS=({' '.join(shlex.quote(word) for word in words)}) COMP_CWORD={len(words) - 1}\n"
            f"function=$(complete -p {words[0]} | sed 's/.*-F \\([^ ]*\\).*/\\1/')\n"
            "$function; printf '%s\\n' \"${COMPREPLY[@]}\""
        )
        done = subprocess.run(["bash", "-c", script], cwd=folder, capture_output=True, text=True, timeout=PATIENCE, check=False)
        self.assertEqual((done.returncode, done.stderr), (0, ""), line)
        return done.stdout.splitlines()

    def test_scenes(self):
        self.assertEqual(self.offered("./render scenes/tutorial/ti"), ["scenes/tutorial/tilt.pov"])
        tutorial = sorted(f"scenes/tutorial/{path.name}" for path in (ROOT / "scenes" / "tutorial").glob("*.pov"))
        self.assertEqual([name for name in self.offered("./render ") if name.startswith("scenes/tutorial/")], tutorial)

    def test_own_files(self):
        with tempfile.TemporaryDirectory(prefix="tilt_lens.") as folder:
            for name in ("mine.pov", "mine.txt", "mine.ini"):
                (pathlib.Path(folder) / name).write_text("")
            (pathlib.Path(folder) / "more").mkdir()
            self.assertEqual(self.offered("./render m", folder), ["mine.ini", "mine.pov", "more/"])
            self.assertTrue(any(name.endswith("/scenes/tutorial/tilt.pov") for name in self.offered("./render /", folder)))

    def test_blanks_are_escaped(self):
        with tempfile.TemporaryDirectory(prefix="tilt_lens.") as folder:
            (pathlib.Path(folder) / "my $scene.pov").write_text("")
            (pathlib.Path(folder) / "my folder").mkdir()
            self.assertEqual(self.offered("./render my", folder), ["my\\ \\$scene.pov", "my\\ folder/"])
            self.assertEqual(self.offered(["./render", "my\\ f"], folder), ["my\\ folder/"])
            self.assertEqual(self.offered(["./batch", "still", '"my f'], folder), ["my folder/"])

    def test_status_of_a_batch(self):
        with tempfile.TemporaryDirectory(prefix="tilt_lens.") as folder:
            for name in ("still.png", "still.pov"):
                (pathlib.Path(folder) / name).write_text("")
            (pathlib.Path(folder) / "still.png.batch").mkdir()
            self.assertEqual(self.offered("./batch status ", folder), ["still.png", "still.png.batch/"])
            self.assertEqual(self.offered("./batch status --", folder), ["--help"])

    def test_options(self):
        self.assertIn("+W", self.offered("./render a.pov +"))
        self.assertEqual(self.offered("./render a.pov Decl"), ["Declare="])
        self.assertEqual(self.offered("./render a.pov Out"), ["Output_Layers=on"])
        self.assertEqual(self.offered("./render a.pov +FE"), ["+FE", "+FE32"])
        self.assertEqual(self.offered("./render a.pov +N"), ["+N"])

    def test_labels(self):
        self.assertEqual(self.offered("./check -L doc"), ["docs"])
        self.assertEqual(self.offered("./check --rerun"), ["--rerun-failed"])

    def test_batch(self):
        self.assertIn("still", self.offered("./batch "))
        self.assertEqual(self.offered("./batch still --ban"), ["--bands"])
        self.assertEqual(self.offered("./batch still scenes/tutorial/ti"), ["scenes/tutorial/tilt.pov"])
        if not (ROOT / "batch").is_file():
            return
        text = subprocess.run([ROOT / "batch", "--help"], capture_output=True, text=True, timeout=PATIENCE, check=True).stdout
        kinds = sorted(BATCH_KINDS.search(text)[1].split("|"))
        self.assertEqual(sorted(self.offered("./batch ")), sorted(["--help", *kinds]))
        for kind in kinds:
            text = subprocess.run([ROOT / "batch", kind, "--help"], capture_output=True, text=True, timeout=PATIENCE, check=True).stdout
            for option in self.offered(f"./batch {kind} --"):
                every = option in text or any(option in (self.help_of(other)) for other in kinds)
                self.assertTrue(every, f"./batch {kind} has no {option}")

    def help_of(self, kind):
        return subprocess.run([ROOT / "batch", kind, "--help"], capture_output=True, text=True, timeout=PATIENCE, check=True).stdout


@unittest.skipUnless(shutil.which("vim"), "Vim is not installed")
class Vim(unittest.TestCase):
    # I: item, B: the block's word, M: macro, E: error, .: none
    SCENE = """#declare tilt = 3;
         .
camera { tilt_lens { tilt tilt focal_plane { y, tilt } swing 2 } angle tilt }
         B           I         I                .      I               .
Tilt_Lens_Real(1)
M
sphere { tilt, 1 texture { tilt } } } #declare swing = 1;
         .                 .        E          .
"""
    COLOURS = {"I": "povTiltLensItem", "B": "povTiltLens", "M": "povTiltLensMacro", "E": "PovBraceError"}

    def test_colours(self):
        with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
            folder = pathlib.Path(name)
            lines = self.SCENE.splitlines()
            (folder / "scene.pov").write_text("\n".join(lines[::2]))
            wanted = {
                (row, column): mark for row, marks in enumerate(lines[1::2], 1) for column, mark in enumerate(marks, 1) if mark != " "
            }
            places = list(wanted)
            ask = " ".join(f"call add(g:n, synIDattr(synID({row}, {column}, 1), 'name')) |" for row, column in places)
            script = (
                f"set runtimepath^={EDITORS / 'vim'} runtimepath+={EDITORS / 'vim' / 'after'}\nsyntax on\nedit scene.pov\n"
                f"let g:n = []\n{ask} call writefile(g:n, 'names')\nquit!\n"
            )
            (folder / "ask.vim").write_text(script)
            subprocess.run(
                ["vim", "-u", "NONE", "-N", "-es", "-S", "ask.vim"],
                cwd=folder,
                env={**os.environ, "HOME": name},
                stdin=subprocess.DEVNULL,
                capture_output=True,
                timeout=PATIENCE,
                check=False,
            )
            if not (folder / "names").exists():
                self.skipTest("this Vim cannot run scripts")
            found = (folder / "names").read_text().split("\n")[:-1]
        if not any(found):
            self.skipTest("Vim's own syntax files are not installed")
        for place, name in zip(places, found):
            if wanted[place] == ".":
                self.assertNotIn(name, self.COLOURS.values(), place)
            else:
                self.assertEqual(name, self.COLOURS[wanted[place]], place)


def main():
    parser = argparse.ArgumentParser(add_help=False)
    parser.add_argument("--povray", type=os.path.abspath, required=True)
    parser.add_argument("--parser", required=True, help="the program parse_blocks")
    _, rest = parser.parse_known_args(namespace=SETTINGS)
    unittest.main(argv=[sys.argv[0], *rest])


if __name__ == "__main__":
    main()

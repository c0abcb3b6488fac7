# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Installed documentation has no broken links."""

import argparse
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

from tools import povray_run
from tools.povray_run import PATIENCE
from tools.docs import pages
from tools.repository import ROOT

SETTINGS = argparse.Namespace(cmake="cmake", build="build")
# paths that an installed program lacks
NOT_INSTALLED = re.compile(r"(\.\./)?(cmake|tests|experiments|benchmarks|povray-src|patches|tools|reference-images|batch|check|render)\b")


def formatted(page):
    done = subprocess.run(
        ["groff", "-ww", "-man", "-Tutf8", "-P-cbou", str(page)], capture_output=True, text=True, timeout=PATIENCE, check=True
    )
    return done.stdout, done.stderr


class Installed(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory(prefix="tilt_lens.")
        cls.prefix = pathlib.Path(cls.folder.name) / "with a blank"
        subprocess.run(
            [SETTINGS.cmake, "--install", SETTINGS.build, "--prefix", str(cls.prefix)],
            stdout=subprocess.DEVNULL,
            timeout=PATIENCE,
            check=True,
        )
        cls.doc = cls.prefix / "share" / "doc" / "povray-tilt-lens"

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_pages_are_all_there(self):
        for page in [ROOT / "README.md", *(ROOT / "docs").glob("*.md"), ROOT / "editors" / "README.md"]:
            self.assertEqual((self.doc / page.relative_to(ROOT)).read_text(), page.read_text())

    def test_links(self):
        checked = 0
        for page in [self.doc / "README.md", *(self.doc / "docs").glob("*.md"), self.doc / "editors" / "README.md"]:
            for target in pages.links_of(page.read_text()):
                file = target.partition("#")[0]
                if re.match(r"[a-z]+:", target) or not file or NOT_INSTALLED.match(file):
                    continue
                checked += 1
                self.assertTrue((page.parent / file).exists(), f"{page.relative_to(self.doc)} links to {target}")
        self.assertGreater(checked, 40)

    def test_no_scripts_among_them(self):
        self.assertFalse((self.doc / "docs" / "figures").exists())
        self.assertTrue((self.doc / "docs" / "pictures" / "optics" / "wedge.svg").is_file())

    def test_scenes_may_be_moved_along(self):
        moved = self.prefix.parent / "moved"
        self.prefix.rename(moved)
        try:
            self.assertTrue((moved / "share/doc/povray-tilt-lens/scenes/tutorial/tilt.pov").is_file())
            self.assertTrue((moved / "share/doc/povray-tilt-lens/scenes/include/tilt_lens.inc").is_file())
        finally:
            moved.rename(self.prefix)

    def test_manual_pages(self):
        for name in ("man1/povray.1", "man7/povray-tilt-lens.7"):
            page = self.prefix / "share" / "man" / name
            text, complaints = formatted(page)
            self.assertEqual(complaints, "", name)
            self.assertGreater(len(text), 2000, name)

    def test_povray_page_has_the_camera(self):
        text, _ = formatted(self.prefix / "share" / "man" / "man1" / "povray.1")
        section = text.split("TILT-SHIFT CAMERA", 1)[1].split("RESOURCES", 1)[0]
        for word in ("tilt_lens", "not the official", "povray-tilt-lens(7)"):
            self.assertIn(word, re.sub(r"\s+", " ", section))
        example = re.search(r"camera \{.*?\n *\}", section, re.DOTALL)[0]
        self.assertEqual(self.parses(example), 0, example)

    def test_own_page_examples(self):
        text, _ = formatted(self.prefix / "share" / "man" / "man7" / "povray-tilt-lens.7")
        found = re.findall(r"camera \{.*?\n *\}\n", text.split("EXAMPLES", 1)[1], re.DOTALL)
        self.assertEqual(len(found), 2)
        for example in found:
            self.assertEqual(self.parses(example), 0, example)

    def test_examples_are_the_manuals(self):
        text, _ = formatted(ROOT / "docs" / "man" / "povray-tilt-lens.7")
        table, facade = re.findall(r"camera \{.*?\n *\}\n", text.split("EXAMPLES", 1)[1], re.DOTALL)
        manual = (ROOT / "docs" / "manual.md").read_text()
        for line in filter(None, (line.strip() for line in table.splitlines())):
            self.assertIn(line, manual)
        answer = manual.split("### Take a facade", 1)[1].split("\n### ", 1)[0]
        for part in (r"location <[^>]*>", r"angle \d+", r"shift <[^>]*>"):
            self.assertIn(re.search(part, facade)[0], answer)

    def test_denoise_is_described_as_in_the_manual(self):
        text = " ".join(formatted(ROOT / "docs" / "man" / "povray-tilt-lens.7")[0].split())
        manual = (ROOT / "docs" / "manual.md").read_text().split("### denoise", 1)[1].split("\n## ", 1)[0]
        for words in (
            "noise is removed from the picture by filters",
            "A number works too, 0 is off.",
            "the mean of its own rays alone",
            "variance 0",
        ):
            self.assertIn(words, text)
            self.assertIn(words.lower().rstrip("."), manual.replace("`", "").lower())

    def parses(self, camera):
        with tempfile.TemporaryDirectory(prefix="tilt_lens.") as folder:
            (pathlib.Path(folder) / "scene.pov").write_text(f"#version 3.7;\n{camera}\nsphere {{ 0, 1 }}\n")
            command = povray_run.command(self.prefix / "bin" / "povray", "scene.pov", None, (8, 6))
            return povray_run.run(command, folder, povray_run.user_environment()).code


def main():
    parser = argparse.ArgumentParser(add_help=False)
    parser.add_argument("--cmake", required=True)
    parser.add_argument("--build", required=True)
    _, rest = parser.parse_known_args(namespace=SETTINGS)
    unittest.main(argv=[sys.argv[0], *rest])


if __name__ == "__main__":
    main()

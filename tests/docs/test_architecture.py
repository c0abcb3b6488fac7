# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The #include lines and folders obey docs/architecture.md."""

import collections
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

from tools.repository import ROOT

LIBRARY = ROOT / "povray-src" / "tilt_lens"
SPEEDUPS = ROOT / "povray-src" / "speedups"
PAGE = ROOT / "docs" / "architecture.md"


def read_table(page):
    """{folder: folders and headers that its files may include}."""
    rows = re.findall(r"^\| `(\w+)/` \|.*\| (.*?) ?\|$", page, re.MULTILINE)
    return {folder: {folder, *re.findall(r"`([\w.]+)/?`", allowed)} for folder, allowed in rows}


def faults(library, table):
    found = [f"{folder.name}/: no row of the table" for folder in library.iterdir() if folder.is_dir() and folder.name not in table]
    found += [f"{folder}/: a row of the table, but no folder" for folder in table if not (library / folder).is_dir()]
    for path in sorted(library.rglob("*.*")):
        folder = path.parent.name if path.parent != library else None
        for header in re.findall(r'^\s*#\s*include\s*"([^"]+)"', path.read_text(encoding="utf-8"), re.MULTILINE):
            root, *rest = header.split("/")
            if root != "tilt_lens" or not rest:
                found.append(f"{path.relative_to(library)} includes {header}, which is no header of the library")
            elif rest[0] not in table.get(folder, ()):
                found.append(f"{path.relative_to(library)} includes {header}, which its row does not allow")
    return found


class Includes(unittest.TestCase):
    def test_obey_the_table(self):
        self.assertEqual(faults(LIBRARY, read_table(PAGE.read_text(encoding="utf-8"))), [])

    def test_the_optics_do_not_depend_on_the_sampler(self):
        table = read_table(PAGE.read_text(encoding="utf-8"))
        for folder in ("math", "camera", "glass", "lens_camera"):
            self.assertFalse({"sampling", "reconstruction", "settings.h"} & table[folder], folder)

    def test_thin_lens_and_glass_do_not_include_each_other(self):
        table = read_table(PAGE.read_text(encoding="utf-8"))
        self.assertNotIn("glass", table["camera"])
        self.assertNotIn("camera", table["glass"])


def included(path):
    return re.findall(r'^\s*#\s*include\s*"([^"]+)"', path.read_text(encoding="utf-8"), re.MULTILINE)


class Speedups(unittest.TestCase):
    def test_the_library_includes_itself_and_vector_registers(self):
        headers = {header for path in SPEEDUPS.glob("*.*") for header in included(path)}
        self.assertIn("speedups/box_ray.h", headers)
        self.assertEqual({header for header in headers if not header.startswith("speedups/")}, {"tilt_lens/math/simd.h"})

    def test_camera_and_glue_do_not_include_them(self):
        names = {path.name for path in SPEEDUPS.rglob("*.h")}
        self.assertGreater(len(names), 5)
        paths = [path for folder in ("tilt_lens", "povray") for path in (ROOT / "povray-src" / folder).rglob("*.*")]
        users = [path.name for path in paths for header in included(path) if header.split("/")[-1] in names]
        self.assertEqual(users, [])


class Checker(unittest.TestCase):
    TABLE = (
        "| folder | answers | may include |\n| --- | --- | --- |\n| `low/` | a | |\n"
        "| `high/` | b | `low/`, `settings.h` |\n| `aside/` | c | `low/` |\n"
    )

    def found(self, path, text):
        with tempfile.TemporaryDirectory() as folder:
            library = pathlib.Path(folder)
            for name in ("low", "high", "aside"):
                (library / name).mkdir()
            (library / path).parent.mkdir(exist_ok=True)
            (library / path).write_text(text + "\n")
            return faults(library, read_table(self.TABLE))

    def test_allowed(self):
        for path, header in (("low/a.h", "low/b.h"), ("high/a.h", "low/b.h"), ("high/a.cpp", "settings.h")):
            self.assertEqual(self.found(path, f'#include "tilt_lens/{header}"\n#include <cmath>'), [])

    def test_upward(self):
        self.assertIn("low/a.h includes tilt_lens/high/b.h", self.found("low/a.h", '#include "tilt_lens/high/b.h"')[0])

    def test_sideways(self):
        self.assertIn("high/a.h includes tilt_lens/aside/b.h", self.found("high/a.h", '  # include "tilt_lens/aside/b.h"')[0])

    def test_file_beside_the_folders(self):
        self.assertIn("settings.h includes", self.found("settings.h", '#include "tilt_lens/low/b.h"')[0])

    def test_header_of_pov_ray(self):
        self.assertIn("no header of the library", self.found("low/a.cpp", '#include "backend/frame.h"')[0])

    def test_folder_without_a_row(self):
        self.assertIn("new/: no row", self.found("new/a.h", "")[0])

    def test_row_without_a_folder(self):
        table = read_table(self.TABLE + "| `gone/` | d | |\n")
        with tempfile.TemporaryDirectory() as folder:
            self.assertIn("gone/: a row of the table, but no folder", faults(pathlib.Path(folder), table))


def folders_of(folder):
    if (ROOT / ".git").exists() and shutil.which("git"):
        listed = subprocess.run(
            ["git", "ls-tree", "-d", "--name-only", "HEAD", f"{folder}/"], cwd=ROOT, capture_output=True, text=True, check=False
        )
        if listed.returncode == 0:  # git refuses a repository of another user
            return sorted(listed.stdout.split())
    return sorted(str(path.relative_to(ROOT)) for path in (ROOT / folder).iterdir() if path.is_dir() and path.name != "__pycache__")


class Maps(unittest.TestCase):
    def check(self, page, heading, folders):
        text = (ROOT / page).read_text(encoding="utf-8").split(heading, 1)[1].split("\n## ", 1)[0]
        missing = [folder for folder in folders if f"`{folder}/`" not in text]
        self.assertEqual(missing, [], f"{page}, {heading}")

    def library(self):
        return sorted(path.name for path in LIBRARY.iterdir() if path.is_dir())

    def test_readme(self):
        shown = [folder for folder in folders_of(".") if folder[0] != "." and folder not in ("build", "povray-src", "tools")]
        self.check("README.md", "## Where things are", shown + folders_of("tools") + folders_of("povray-src") + self.library())

    def test_patching(self):
        self.check("docs/patching.md", "# Patching POV-Ray", folders_of("povray-src") + folders_of("patches") + self.library())

    def test_patching_tells_of_each_speedup_and_each_fix(self):
        text = (ROOT / "docs" / "patching.md").read_text(encoding="utf-8")
        for folder, heading, told in (
            ("speedups", "### What the speedups are worth", r"^\| `([a-z0-9-]+)` \|"),
            ("fixes", "## Defects of upstream", r"^\*\*([a-z0-9-]+): "),
        ):
            patches = [path.stem for path in (ROOT / "patches" / folder).glob("*.patch")]
            section = re.split(r"^##+ ", text.split(heading + "\n", 1)[1], maxsplit=1, flags=re.MULTILINE)[0]
            self.assertEqual(sorted(re.findall(told, section, re.MULTILINE)), sorted(patches), heading)


def same_names(paths):
    return sorted(name for name, count in collections.Counter(path.name for path in paths).items() if count > 1)


class Sources(unittest.TestCase):
    def test_names_are_unique(self):
        sources = [
            path
            for folder in ("povray-src", "benchmarks", "experiments", "tests", "tools")
            for path in (ROOT / folder).rglob("*.*")
            if path.suffix in (".h", ".cpp")
        ]
        self.assertGreater(len(sources), 200)
        self.assertEqual(same_names(sources), [])

    def test_a_name_given_twice_is_found(self):
        self.assertEqual(same_names(map(pathlib.Path, ("a/lens.h", "b/lens.h", "b/lens.cpp"))), ["lens.h"])

    def test_one_short_class_follows_rays(self):
        glue = {path: path.read_text(encoding="utf-8") for path in (ROOT / "povray-src" / "povray").rglob("*.h")}
        bridges = [path for path, text in glue.items() if "tilt_lens::RayTracer" in text]
        self.assertEqual([path.name for path in bridges], ["tilt_lens_tracer.h"])
        lines = sum(len(path.read_text(encoding="utf-8").splitlines()) for path in (bridges[0], bridges[0].with_suffix(".cpp")))
        self.assertLessEqual(lines, 300)


if __name__ == "__main__":
    unittest.main()

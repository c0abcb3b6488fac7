# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The bundle's libraries and licences, and renders from any folder."""

import os
import pathlib
import re
import shutil
import subprocess
import unittest

from tests.setup.scratch import BUILD, CMAKE, REPOSITORY, SCENE, SetupTest
from tests.waiting import PATIENCE

GLIBC = re.compile(r"(linux-vdso|ld-linux[\w-]*|libc|libm|libdl|librt|libpthread)\.so\.\d")


class Bundle(SetupTest):
    @classmethod
    def setUpClass(cls):
        cls.scratch = SetupTest()
        cls.scratch.setUp()
        cls.addClassCleanup(cls.scratch.doCleanups)
        cache = dict(re.findall(r"^(\w+):[A-Z]+=(.*)$", (BUILD / "CMakeCache.txt").read_text(encoding="utf-8"), re.MULTILINE))
        work = cls.scratch.folder / "made here"
        cls.made = cls.scratch.run_command(
            CMAKE,
            "-DNAME=bundle",
            f"-DBUILD={BUILD}",
            "-DVERSION=1",
            f"-DWORK={work}",
            f"-DOBJDUMP={cache['CMAKE_OBJDUMP']}",
            f"-DJEMALLOC={cache['JEMALLOC_LIBRARY']}",
            "-P",
            REPOSITORY / "cmake" / "bundle" / "make.cmake",
        )
        # a move reveals fixed paths
        cls.bundle = cls.scratch.folder / "moved to" / "bundle"
        if (work / "bundle").is_dir():
            cls.bundle.parent.mkdir()
            shutil.move(work / "bundle", cls.bundle)

    def setUp(self):
        super().setUp()
        self.assert_succeeds(self.made)
        self.here = self.folder / "a place"
        self.here.mkdir()

    def bare(self, *command):
        return subprocess.run(
            [str(word) for word in command],
            cwd=self.here,
            timeout=PATIENCE,
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
            errors="replace",
            check=False,
            env={"PATH": "/usr/bin:/bin", "HOME": str(self.folder)},
        )

    def test_every_library_but_glibc_is_in_the_bundle(self):
        process = self.bare("ldd", self.bundle / "bin" / "povray")
        self.assert_succeeds(process)
        loaded = dict(re.findall(r"^\s*(\S+)(?: => (.*?))? \(0x[0-9a-f]+\)$", process.stdout, re.MULTILINE))
        self.assertEqual(len(loaded), len(process.stdout.splitlines()), process.stdout)
        lib = self.bundle / "lib"
        own = {name for name, path in loaded.items() if path and pathlib.Path(path).resolve().parent == lib}
        self.assertEqual([name for name in set(loaded) - own if not GLIBC.fullmatch(pathlib.PurePath(name).name)], [])
        self.assertEqual({file.name for file in lib.iterdir()}, own)
        for word in ("libpng", "libjpeg", "libtiff", "libOpenEXR", "libboost_thread", "libstdc++", "libgcc_s"):
            self.assertTrue(any(name.startswith(word) for name in own), word)

    def test_renders_from_a_read_only_place(self):
        for folder, _, _ in os.walk(self.bundle):
            os.chmod(folder, 0o555)
        self.addCleanup(subprocess.run, ["chmod", "-R", "u+w", str(self.bundle)], check=False)
        (self.here / "my scene.pov").write_text(SCENE, encoding="utf-8")
        for command in ([self.bundle / "render"], [self.bundle / "bin" / "povray", "-D"]):
            picture = self.here / "my scene.png"
            picture.unlink(missing_ok=True)
            process = self.bare(*command, "my scene.pov" if "render" in str(command[0].name) else '+I"my scene.pov"', "+W16", "+H12")
            self.assert_succeeds(process)
            self.assertNotRegex(process.stderr, "cannot open an INI|system configuration file|restrictions are disabled|SDL")
            self.assertTrue(picture.read_bytes().startswith(b"\x89PNG"))

    def test_the_town_and_the_tutorial_are_in_it(self):
        process = self.bare(self.bundle / "render", "+W16", "+H9", "+Q0")
        self.assert_succeeds(process)
        self.assertEqual(process.stderr.splitlines()[-1], f"Picture: {self.here}/miniature_town.png")
        self.assert_succeeds(self.bare(self.bundle / "render", self.bundle / "scenes" / "tutorial" / "tilt.pov", "+W16", "+H12"))
        self.assertEqual(sorted(path.name for path in self.here.iterdir()), ["miniature_town.png", "tilt.png"])

    def test_it_is_not_built_again(self):
        self.assert_fails_saying(self.bare(self.bundle / "render", "--source", "."), "this bundle is built")

    def test_licences_of_all_contents(self):
        names = {file.name for file in (self.bundle / "licences").iterdir()}
        self.assertLessEqual({"povray", "libjemalloc-dev", "zlib1g", "GPL-2"}, names)
        for file in (self.bundle / "lib").iterdir():
            found = subprocess.run(["dpkg-query", "--search", f"*/{file.name}"], capture_output=True, text=True, check=True).stdout
            packages = {line.split(":")[0] for line in found.splitlines()}
            self.assertTrue(packages & names, file.name)
        self.assertIn("GNU AFFERO GENERAL PUBLIC LICENSE", (self.bundle / "LICENSE").read_text(encoding="utf-8"))
        source = (self.bundle / "SOURCE").read_text(encoding="utf-8")
        self.assertRegex(source, r"SHA-256 [0-9a-f]{64}\n")
        self.assertRegex(source, r"\n   jemalloc \S+ \(libjemalloc-dev\)\n")

    def test_names_the_required_glibc(self):
        said = re.search(r"glibc (\d+)\.(\d+) or later", (self.bundle / "READ-ME-FIRST").read_text(encoding="utf-8"))
        here = os.confstr("CS_GNU_LIBC_VERSION").split()[1].split(".")
        self.assertLessEqual((2, 17), tuple(map(int, said.groups())))
        self.assertLessEqual(tuple(map(int, said.groups())), tuple(map(int, here)))

    def test_no_file_names_the_build_folder(self):
        for path in self.bundle.rglob("*"):
            if path.is_file():
                self.assertNotIn(str(BUILD).encode(), path.read_bytes(), path)

    def test_links_stay_inside(self):
        links = [path for path in self.bundle.rglob("*") if path.is_symlink()]
        self.assertGreater(len(links), 2)
        for link in links:
            self.assertTrue(link.resolve(strict=True).is_relative_to(self.bundle), link)


if __name__ == "__main__":
    unittest.main()

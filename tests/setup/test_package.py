# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The package for Debian."""

import gzip
import pathlib
import re
import shutil
import subprocess
import tarfile
import unittest

from tests.setup.scratch import BUILD, CMAKE, REPOSITORY, SCENE, SetupTest

CPACK = pathlib.Path(CMAKE).with_name("cpack")
MAINTAINER = {"DEBFULLNAME": "A tester", "DEBEMAIL": "tester@example.org"}
OWN = re.compile(
    r"""/(etc|usr/(lib|share|share/doc))/povray-tilt-lens/.*
    | /usr/bin/povray-tilt-lens
    | /usr/share/man/man[17]/povray-tilt-lens\.[17]\.gz
    | /usr/share/bash-completion/completions/povray-tilt-lens
    | /usr/share/vim/vimfiles/after/syntax/pov\.vim""",
    re.VERBOSE,
)


def pack(test, env):
    return test.run_command(CPACK, "--config", BUILD / "CPackConfig.cmake", "-B", test.folder, env=env)


class Package(SetupTest):
    @classmethod
    def setUpClass(cls):
        cls.scratch = SetupTest()
        cls.scratch.setUp()
        cls.made = pack(cls.scratch, MAINTAINER)
        cls.package = next(cls.scratch.folder.glob("*.deb"), None)
        cls.root = cls.scratch.folder / "root"
        if cls.package:
            subprocess.run(["dpkg-deb", "--extract", str(cls.package), str(cls.root)], check=True)

    @classmethod
    def tearDownClass(cls):
        cls.scratch.doCleanups()

    def setUp(self):
        super().setUp()
        self.assert_succeeds(self.made)

    def field(self, name):
        return subprocess.run(["dpkg-deb", "--field", str(self.package), name], capture_output=True, text=True, check=True).stdout.strip()

    def files(self):
        return sorted("/" + str(path.relative_to(self.root)) for path in self.root.rglob("*") if path.is_symlink() or not path.is_dir())

    def test_name_and_control_data(self):
        architecture = subprocess.run(["dpkg", "--print-architecture"], capture_output=True, text=True, check=True).stdout.strip()
        self.assertEqual(self.package.name, f"povray-tilt-lens_{self.field('Version')}_{architecture}.deb")
        self.assertEqual(self.field("Maintainer"), "A tester <tester@example.org>")
        for library in ("libc6", "libpng16-16", "libtiff6", "libboost-thread"):
            self.assertIn(library, self.field("Depends"))
        self.assertIn("libsdl1.2", self.field("Recommends"))
        self.assertIn("unofficial version", self.field("Description"))

    def test_files_have_places_of_their_own(self):
        files = self.files()
        self.assertEqual([name for name in files if not OWN.fullmatch(name)], [])
        stock = subprocess.run(
            ["dpkg-query", "--listfiles", "povray", "povray-includes"], capture_output=True, text=True, check=True
        ).stdout.split("\n")
        self.assertGreater(len(stock), 50)
        self.assertEqual(set(files) & set(stock), set())

    def test_settings_are_configuration_files(self):
        listed = subprocess.run(
            ["dpkg-deb", "--info", str(self.package), "conffiles"], capture_output=True, text=True, check=True
        ).stdout.split()
        self.assertEqual(sorted(listed), [name for name in self.files() if name.startswith("/etc/")])
        for name in listed:
            self.assertNotIn(str(REPOSITORY), (self.root / name[1:]).read_text(encoding="utf-8"))

    def test_links_lead_somewhere(self):
        links = [path for path in self.root.rglob("*") if path.is_symlink()]
        self.assertGreater(len(links), 5)
        for link in links:
            target = link.readlink()
            target = self.root / str(target)[1:] if target.is_absolute() else link.parent / target
            self.assertTrue(target.exists(), link)

    def test_manual_pages_name_the_package_s_files(self):
        for section in (1, 7):
            page = self.root / f"usr/share/man/man{section}/povray-tilt-lens.{section}.gz"
            with gzip.open(page, "rt", encoding="utf-8") as opened:
                text = opened.read()
            self.assertIn("/usr/share/povray-tilt-lens", text)
            for other in (" PREFIX", "IPREFIX", "\\fBpovray\\fP", "povray (1)"):
                self.assertNotIn(other, text, page.name)

    def test_licence_and_source(self):
        doc = self.root / "usr/share/doc/povray-tilt-lens"
        self.assertIn("GNU AFFERO GENERAL PUBLIC LICENSE", (doc / "copyright").read_text(encoding="utf-8"))
        self.assertIn("Upstream-Name: jemalloc", (doc / "copyright.jemalloc").read_text(encoding="utf-8"))
        source = (doc / "SOURCE").read_text(encoding="utf-8")
        archive = next(doc.glob("*.tar.xz"))
        self.assertIn(archive.name, source)
        self.assertRegex(source, r"SHA-256 [0-9a-f]{64}\n")
        self.assert_is_the_source(archive)

    def assert_is_the_source(self, archive):
        with tarfile.open(archive) as opened:
            held = {name.partition("/")[2] for name in (entry.name for entry in opened if not entry.isdir())}
        self.assertIn("CMakeLists.txt", held)
        self.assertFalse([name for name in held if name.startswith((".git/", "build/")) or "__pycache__" in name])
        if (REPOSITORY / ".git").exists() and shutil.which("git"):  # missing in an archive and in a minimal system
            wanted = subprocess.run(
                ["git", "-C", str(REPOSITORY), "-c", "safe.directory=*", "ls-files", "-z"], capture_output=True, text=True, check=True
            ).stdout.split("\0")
            self.assertEqual({name for name in wanted if name and (REPOSITORY / name).exists()} - held, set())

    def test_source_can_be_configured(self):
        archive = next((self.root / "usr/share/doc/povray-tilt-lens").glob("*.tar.xz"))
        self.assert_succeeds(self.run_command("tar", "--extract", "--file", archive, "--directory", self.folder))
        cache = dict(re.findall(r"^(\w+):[A-Z]+=(.*)$", (BUILD / "CMakeCache.txt").read_text(encoding="utf-8"), re.MULTILINE))
        process = self.run_command(
            CMAKE,
            "--preset",
            "release",
            f"-DPOVRAY_TARBALL={cache['POVRAY_TARBALL'] or cache['TILT_LENS_DOWNLOADS']}",
            cwd=self.folder / archive.name.removesuffix(".tar.xz"),
        )
        self.assert_succeeds(process)
        self.assertNotIn("CMake Warning", process.stderr)

    def test_renders_from_the_package(self):
        scene = self.folder / "scene.pov"
        scene.write_text(SCENE, encoding="utf-8")
        process = self.run_command(
            self.root / "usr/bin/povray-tilt-lens",
            "scene.pov",
            "+W16",
            "+H12",
            "-D",
            f'+L"{self.root}/usr/share/povray-tilt-lens/include"',
            env={"HOME": str(self.folder)},
        )
        self.assert_succeeds(process)
        self.assertTrue((self.folder / "scene.png").read_bytes().startswith(b"\x89PNG"))


class PackageMaker(SetupTest):
    def test_who_makes_it_must_be_named(self):
        process = pack(self, {"DEBFULLNAME": "", "DEBEMAIL": ""})
        self.assert_fails_saying(process, "names who made it", "DEBFULLNAME", "DEBEMAIL")
        self.assertEqual(list(self.folder.glob("*.deb")), [])


if __name__ == "__main__":
    unittest.main()

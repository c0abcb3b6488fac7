# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later

import hashlib
import io
import json
import os
import tarfile

from tests.setup.scratch import CMAKE, REPOSITORY, SetupTest

TARBALL = "povray_1.orig.tar.gz"
PACKAGING = "povray_1-2.debian.tar.xz"
TARGET = "LICENSE"  # the upstream file that this test's patches change
NO_NETWORK = "http://127.0.0.1:9"  # the discard port refuses at once

# small enough to be unpacked a dozen times
ORIG = {
    "povray-1/LICENSE": "GENERAL PUBLIC LICENSE\n",
    "povray-1/changes.txt": "one\ntwo\n",
    "povray-1/source/main.cpp": "int main() {}\n",
    "povray-1/windows/unused.cpp": "",
}
DEBIAN = {
    "debian/copyright": "License: AGPL-3.0+\n",
    "debian/patches/series": "fix-main.patch\nfix-more.patch\n",
    "debian/patches/fix-main.patch": "--- a/source/main.cpp\n+++ b/source/main.cpp\n@@ -1 +1,2 @@\n int main() {}\n+// Debian's line\n",
    "debian/patches/fix-more.patch": "--- a/source/main.cpp\n+++ b/source/main.cpp\n@@ -1,2 +1,3 @@\n int main() {}\n // Debian's line\n+// another\n",
}
PATCHES = ["fix-main.patch", "fix-more.patch"]


def write_archive(path, mode, members):
    with tarfile.open(path, mode) as archive:
        for name, text in members.items():
            entry = tarfile.TarInfo(name)
            entry.size = len(text)
            archive.addfile(entry, io.BytesIO(text.encode()))


class SourcePackageTest(SetupTest):
    def setUp(self):
        super().setUp()
        self.work = self.folder / "work"
        self.downloads = self.folder / "downloads"
        self.archives = self.folder / "archives"
        self.archives.mkdir()
        write_archive(self.archives / TARBALL, "w:gz", ORIG)
        self.write_packaging(PACKAGING)
        self.write_pin()
        self.series = self.folder / "patches"
        self.series.mkdir()
        self.write_series("One")

    def write_packaging(self, name, mode="w:xz", without=(), **changed):
        """CHANGED: patches with another text, "_" for "-", no extension."""
        members = {path: text for path, text in DEBIAN.items() if path not in without}
        for patch, text in changed.items():
            members[f"debian/patches/{patch.replace('_', '-')}.patch"] = text
        write_archive(
            self.archives / name,
            mode,
            {
                **members,
                "debian/changelog": f"povray {name}\n",
                "debian/patches/series": "".join(os.path.basename(path) + "\n" for path in members if path.endswith(".patch")),
            },
        )

    def write_pin(self):
        self.pin = self.folder / "upstream.json"
        content = (self.archives / TARBALL).read_bytes()
        patches = [{"name": name, "sha256": hashlib.sha256(DEBIAN[f"debian/patches/{name}"].encode()).hexdigest()} for name in PATCHES]
        self.pin.write_text(
            json.dumps(
                {
                    "package": "povray",
                    "upstream_version": "1",
                    "source_folder": "povray-1",
                    "tarball": {"name": TARBALL, "size": len(content), "sha256": hashlib.sha256(content).hexdigest()},
                    "packaging_patches": patches,
                }
            ),
            encoding="utf-8",
        )

    def write_series(self, text):
        first = ORIG[f"povray-1/{TARGET}"]
        (self.series / "add-line.patch").write_text(f"--- a/{TARGET}\n+++ b/{TARGET}\n@@ -1 +1,2 @@\n+{text}\n {first}", encoding="utf-8")
        (self.series / "series").write_text("# a comment\nadd-line.patch\n", encoding="utf-8")

    def prepare(self, tarball="", env=None):
        script = self.folder / "prepare.cmake"
        script.write_text(
            f'include("{REPOSITORY}/cmake/PatchedSource.cmake")\n'
            f'set(POVRAY_TARBALL "{tarball}")\n'
            f'patched_source_prepare("{self.work}" "{self.downloads}" "{self.pin}" "{self.series}" TRUE)\n',
            encoding="utf-8",
        )
        return self.run_command(CMAKE, "-P", script, env=env)

    def prepared(self, name=TARGET):
        return self.work / "povray" / name

    def assert_prepared(self, text="One"):
        self.assertTrue((self.work / "key").is_file())
        self.assertFalse((self.work / "fresh").exists())
        self.assertEqual(self.prepared().read_text(encoding="utf-8").splitlines()[0], text)
        self.assertIn("Debian's line", self.prepared("source/main.cpp").read_text(encoding="utf-8"))
        self.assertFalse(self.prepared("windows").exists())
        self.assertEqual((self.work / "applied-patches").read_text(encoding="utf-8").split(), [*PATCHES, "add-line.patch"])

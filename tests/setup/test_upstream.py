# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The pinned source: every way it may fail to arrive has one clear message, and the next try starts clean."""

import hashlib
import io
import json
import os
import tarfile
import unittest

from tests.setup.harness import CMAKE, REPOSITORY, SetupTest

TARBALL = "povray_1.orig.tar.gz"
# The packaging revisions: name of the control file and of the archive of each.
REVISIONS = {"1": ("povray_1-1.dsc", "povray_1-1.debian.tar.xz"), "2": ("povray_1-2.dsc", "povray_1-2.debian.tar.xz")}
PACKAGING = REVISIONS["2"][1]       # the newest revision, which is preferred
TARGET = "LICENSE"                  # the upstream file that this test's patches change
NO_NETWORK = "http://127.0.0.1:9"   # the discard port: refuses at once

# A source package of the real one's shape, small enough to be unpacked a dozen times.
ORIG = {
    "povray-1/LICENSE": "GENERAL PUBLIC LICENSE\n",
    "povray-1/changes.txt": "one\ntwo\n",
    "povray-1/source/main.cpp": "int main() {}\n",
    "povray-1/windows/unused.cpp": "",
}
DEBIAN = {
    "debian/copyright": "License: AGPL-3.0+\n",
    "debian/patches/series": "fix-main.patch\n#left-out.patch\n",
    "debian/patches/fix-main.patch":
        "--- a/source/main.cpp\n+++ b/source/main.cpp\n@@ -1 +1,2 @@\n int main() {}\n+// Debian's line\n",
}


def write_archive(path, mode, members):
    with tarfile.open(path, mode) as archive:
        for name, text in members.items():
            entry = tarfile.TarInfo(name)
            entry.size = len(text)
            archive.addfile(entry, io.BytesIO(text.encode()))


class Upstream(SetupTest):
    def setUp(self):
        super().setUp()
        self.work = self.folder / "work"
        self.downloads = self.folder / "downloads"
        self.archives = self.folder / "archives"
        self.archives.mkdir()
        write_archive(self.archives / TARBALL, "w:gz", ORIG)
        for revision, (control, packaging) in REVISIONS.items():
            write_archive(self.archives / packaging, "w:xz", {**DEBIAN, "debian/changelog": f"povray (1-{revision})\n"})
            (self.archives / control).write_text(f"Version: 1-{revision}\n", encoding="utf-8")
        self.write_pin()
        self.series = self.folder / "patches"
        self.series.mkdir()
        self.write_series("One")

    def write_pin(self):
        """A pin of the archives as they are now."""
        self.pin = self.folder / "upstream.json"

        def pinned(name):
            content = (self.archives / name).read_bytes()
            return {"name": name, "size": len(content), "sha256": hashlib.sha256(content).hexdigest()}

        revisions = [{"version": f"1-{revision}", "releases": ["old", "new"], "dsc": pinned(control),
                      "debian": pinned(packaging)} for revision, (control, packaging) in REVISIONS.items()]
        self.pin.write_text(json.dumps({"package": "povray", "upstream_version": "1", "source_folder": "povray-1",
                                        "tarball": pinned(TARBALL), "revisions": revisions}), encoding="utf-8")

    def write_series(self, text):
        """A series of one patch that puts the line TEXT ahead of TARGET."""
        first = ORIG[f"povray-1/{TARGET}"]
        (self.series / "add-line.patch").write_text(
            f"--- a/{TARGET}\n+++ b/{TARGET}\n@@ -1 +1,2 @@\n+{text}\n {first}", encoding="utf-8")
        (self.series / "series").write_text("# a comment\nadd-line.patch\n", encoding="utf-8")

    def prepare(self, tarball="", env=None):
        """Prepares the source as the configure step does."""
        script = self.folder / "prepare.cmake"
        script.write_text(
            f'include("{REPOSITORY}/cmake/PatchedSource.cmake")\n'
            f'set(POVRAY_TARBALL "{tarball}")\n'
            f'patched_source_prepare("{self.work}" "{self.downloads}" "{self.pin}" "{self.series}" TRUE)\n',
            encoding="utf-8")
        return self.run_command(CMAKE, "-P", script, env=env)

    def prepared(self, name=TARGET):
        return self.work / "povray" / name

    def assert_prepared(self, text="One"):
        self.assertTrue((self.work / "key").is_file())
        self.assertFalse((self.work / "fresh").exists())
        self.assertEqual(self.prepared().read_text(encoding="utf-8").splitlines()[0], text)
        self.assertIn("Debian's line", self.prepared("source/main.cpp").read_text(encoding="utf-8"))
        self.assertFalse(self.prepared("windows").exists())
        self.assertEqual((self.work / "applied-patches").read_text(encoding="utf-8").split(),
                         ["fix-main.patch", "add-line.patch"])

    def test_folder_is_taken(self):
        self.assert_succeeds(self.prepare(self.archives))
        self.assert_prepared()

    def test_one_of_the_files_is_taken_for_its_folder(self):
        self.assert_succeeds(self.prepare(self.archives / TARBALL))
        self.assert_prepared()

    def test_any_one_revision_will_do(self):
        for revision in REVISIONS:
            folder = self.folder / f"only {revision}"
            folder.mkdir()
            for name in (TARBALL, *REVISIONS[revision]):
                os.link(self.archives / name, folder / name)
            (self.work / "key").unlink(missing_ok=True)
            self.assert_succeeds(self.prepare(folder))
            self.assert_prepared()

    def test_parts_of_two_revisions_are_none(self):
        (self.archives / REVISIONS["1"][0]).unlink()
        (self.archives / REVISIONS["2"][1]).unlink()
        self.assert_fails_saying(self.prepare(self.archives), f"{REVISIONS['1'][0]} is missing (revision 1-1)",
                                 f"{REVISIONS['2'][1]} is missing (revision 1-2)")

    def test_revision_that_is_not_pinned(self):
        for control, packaging in REVISIONS.values():
            (self.archives / control).unlink()
            (self.archives / packaging).unlink()
        (self.archives / "povray_1-7.dsc").write_text("Version: 1-7\n", encoding="utf-8")
        self.assert_fails_saying(self.prepare(self.archives), "povray_1-7.dsc, a packaging revision that is not pinned",
                                 "1-1 (old, new) 1-2 (old, new)", "Add a revision of Debian's package")

    def test_missing_folder(self):
        process = self.prepare(self.folder / "nowhere")
        self.assert_fails_saying(process, "POVRAY_TARBALL", TARBALL + " is missing")

    def test_changed_file_and_next_try(self):
        for name in REVISIONS["1"]:     # only one revision is at hand
            (self.archives / name).unlink()
        archive = self.archives / PACKAGING
        original = archive.read_bytes()
        archive.write_bytes(original[:-1])
        self.assert_fails_saying(self.prepare(self.archives), PACKAGING + " has", "bytes, expected")
        archive.write_bytes(original[:-1] + bytes([original[-1] ^ 1]))
        self.assert_fails_saying(self.prepare(self.archives), "SHA-256", "expected")
        archive.write_bytes(original)
        self.assert_succeeds(self.prepare(self.archives))
        self.assert_prepared()

    def test_damaged_download_is_dropped_and_no_network_is_told(self):
        config = self.folder / "apt.conf"
        config.write_text(f'Acquire::http::Proxy "{NO_NETWORK}";\nAcquire::https::Proxy "{NO_NETWORK}";\n',
                          encoding="utf-8")
        self.downloads.mkdir()
        (self.downloads / TARBALL).write_bytes(b"half a file")
        process = self.prepare(env={"APT_CONFIG": str(config), "http_proxy": NO_NETWORK, "https_proxy": NO_NETWORK})
        self.assert_fails_saying(process, "could not be downloaded", "could not be reached", "-DPOVRAY_TARBALL=")
        self.assertEqual(list(self.downloads.iterdir()), [])

    def test_interrupted_unpacking_is_told_and_leaves_no_tree(self):
        # A tar that stops half-way stands for a full disk.
        tools = self.folder / "tools"
        tools.mkdir()
        (tools / "tar").write_text("#!/bin/sh\nmkdir half\necho 'No space left on device' >&2\nexit 2\n", encoding="utf-8")
        (tools / "tar").chmod(0o755)
        process = self.prepare(self.archives, env={"PATH": f"{tools}:{os.environ['PATH']}"})
        self.assert_fails_saying(process, "could not be unpacked", "No space left on device")
        self.assertFalse((self.work / "fresh").exists())
        self.assertFalse((self.work / "key").exists())
        self.assert_succeeds(self.prepare(self.archives))
        self.assert_prepared()

    def test_leftovers_of_a_killed_run_do_not_matter(self):
        (self.work / "fresh" / "povray-1").mkdir(parents=True)
        (self.work / "povray" / "source").mkdir(parents=True)
        (self.work / "povray" / "source" / "left_over.cpp").write_text("", encoding="utf-8")
        self.assert_succeeds(self.prepare(self.archives))
        self.assert_prepared()
        self.assertFalse(self.prepared("source/left_over.cpp").exists())

    def test_changed_patch_touches_only_what_it_changes(self):
        self.assert_succeeds(self.prepare(self.archives))
        untouched = self.prepared("changes.txt")
        os.utime(untouched, (1, 1))
        os.utime(self.prepared(), (1, 1))
        self.write_series("Two")
        self.assert_succeeds(self.prepare(self.archives))
        self.assert_prepared("Two")
        self.assertEqual(untouched.stat().st_mtime, 1)
        self.assertGreater(self.prepared().stat().st_mtime, 1)

    def test_nothing_to_do_needs_no_archive(self):
        self.assert_succeeds(self.prepare(self.archives))
        self.assert_succeeds(self.prepare(self.folder / "nowhere"))

    def test_patch_that_needs_fuzz_is_refused(self):
        patch = self.series / "add-line.patch"
        patch.write_text(patch.read_text(encoding="utf-8").replace("GENERAL", "PARTICULAR"), encoding="utf-8")
        self.assert_fails_saying(self.prepare(self.archives), "add-line.patch does not apply", "docs/patching.md")

    def test_listed_patch_that_is_missing(self):
        (self.series / "series").write_text("add-other.patch\n", encoding="utf-8")
        self.assert_fails_saying(self.prepare(self.archives), "lists add-other.patch, which does not exist")


if __name__ == "__main__":
    unittest.main()

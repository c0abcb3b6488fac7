# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""A failed delivery of the source has one message."""

import os
import shutil
import unittest

from tests.setup.source_package import NO_NETWORK, PACKAGING, TARBALL, SourcePackageTest


class Upstream(SourcePackageTest):
    def test_folder_is_taken(self):
        self.assert_succeeds(self.prepare(self.archives))
        self.assert_prepared()

    def test_one_of_the_files_is_taken_for_its_folder(self):
        self.assert_succeeds(self.prepare(self.archives / TARBALL))
        self.assert_prepared()

    def test_any_revision_with_the_pinned_patches_will_do(self):
        (self.archives / PACKAGING).unlink()
        for name, mode in (
            ("povray_1-1.debian.tar.xz", "w:xz"),
            ("povray_1-2build3.debian.tar.gz", "w:gz"),
            ("povray_1-2ubuntu1~24.04.debian.tar.xz", "w:xz"),
            ("povray_1-7+rpi1.debian.tar.bz2", "w:bz2"),
        ):
            with self.subTest(name):
                self.write_packaging(name, mode)
                (self.work / "key").unlink(missing_ok=True)
                process = self.prepare(self.archives)
                self.assert_succeeds(process)
                self.assertIn(name, process.stdout)
                self.assert_prepared()
                (self.archives / name).unlink()

    def test_further_patches_of_a_packaging_are_not_compiled(self):
        self.write_packaging(PACKAGING, vendor="--- a/LICENSE\n+++ b/LICENSE\n@@ -1 +1 @@\n-GENERAL PUBLIC LICENSE\n+other\n")
        self.assert_succeeds(self.prepare(self.archives))
        self.assert_prepared()

    def test_revision_whose_patches_differ(self):
        self.write_packaging(PACKAGING, fix_more="another text\n")
        self.assert_fails_saying(
            self.prepare(self.archives),
            f"{PACKAGING}: debian/patches/fix-more.patch has SHA-256",
            "Take another packaging",
            "./render --source FOLDER",
        )

    def test_revision_with_missing_files(self):
        self.write_packaging(PACKAGING, without=("debian/patches/fix-main.patch", "debian/copyright"))
        process = self.prepare(self.archives)
        self.assert_fails_saying(
            process, f"{PACKAGING}: debian/patches/fix-main.patch is missing", f"{PACKAGING}: debian/copyright is missing"
        )
        self.assertNotIn("fix-more.patch", process.stderr)

    def test_good_revision_among_several_is_taken(self):
        self.write_packaging("povray_1-10.debian.tar.xz", fix_more="another text\n")
        (self.archives / "povray_1-9.debian.tar.xz").write_bytes(b"no archive")
        self.write_packaging("povray_1-1.debian.tar.xz", fix_more="another text\n")
        process = self.prepare(self.archives)
        self.assert_succeeds(process)
        self.assertIn(PACKAGING, process.stdout)
        self.assert_prepared()

    def test_folder_without_a_packaging(self):
        (self.archives / PACKAGING).unlink()
        (self.archives / "povray_0-1.debian.tar.xz").write_bytes(b"of another version")
        process = self.prepare(self.archives)
        self.assert_fails_saying(process, "povray_1-REVISION.debian.tar.xz is missing")
        self.assertNotIn(TARBALL + " is missing", process.stderr)

    def test_missing_folder(self):
        process = self.prepare(self.folder / "nowhere")
        self.assert_fails_saying(process, "POVRAY_TARBALL", TARBALL + " is missing")

    def test_changed_tarball_and_next_try(self):
        archive = self.archives / TARBALL
        original = archive.read_bytes()
        archive.write_bytes(original[:-1])
        self.assert_fails_saying(self.prepare(self.archives), TARBALL + " has", "bytes, expected")
        archive.write_bytes(original[:-1] + bytes([original[-1] ^ 1]))
        self.assert_fails_saying(self.prepare(self.archives), "SHA-256", "expected")
        archive.write_bytes(original)
        self.assert_succeeds(self.prepare(self.archives))
        self.assert_prepared()

    def test_damaged_packaging(self):
        archive = self.archives / PACKAGING
        archive.write_bytes(archive.read_bytes()[:-40])
        self.assert_fails_saying(self.prepare(self.archives), f"{PACKAGING} could not be unpacked", "damaged")

    def test_damaged_download_is_dropped_and_missing_network_reported(self):
        config = self.folder / "apt.conf"
        config.write_text(f'Acquire::http::Proxy "{NO_NETWORK}";\nAcquire::https::Proxy "{NO_NETWORK}";\n', encoding="utf-8")
        self.downloads.mkdir()
        (self.downloads / TARBALL).write_bytes(b"half a file")
        process = self.prepare(env={"APT_CONFIG": str(config), "http_proxy": NO_NETWORK, "https_proxy": NO_NETWORK})
        self.assert_fails_saying(process, "could not be downloaded", "could not be reached", "-DPOVRAY_TARBALL=")
        self.assertEqual(list(self.downloads.iterdir()), [])

    def test_interrupted_unpacking_is_reported_and_leaves_no_tree(self):
        tools = self.folder / "tools"
        tools.mkdir()
        (tools / "tar").write_text(
            f"#!/bin/sh\ncase $* in *{PACKAGING}*) exec {shutil.which('tar')} \"$@\" ;; esac\n"
            "mkdir half\necho 'No space left on device' >&2\nexit 2\n",
            encoding="utf-8",
        )
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

    def test_changed_patch_touches_only_its_files(self):
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

    def test_patch_needing_fuzz_is_refused(self):
        patch = self.series / "add-line.patch"
        patch.write_text(patch.read_text(encoding="utf-8").replace("GENERAL", "PARTICULAR"), encoding="utf-8")
        self.assert_fails_saying(self.prepare(self.archives), "add-line.patch does not apply", "docs/patching.md")

    def test_missing_listed_patch(self):
        (self.series / "series").write_text("add-other.patch\n", encoding="utf-8")
        self.assert_fails_saying(self.prepare(self.archives), "lists add-other.patch, which does not exist")


if __name__ == "__main__":
    unittest.main()

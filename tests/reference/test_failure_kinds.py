# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Every kind of failure, with a stand-in for POV-Ray."""

import os
import pathlib
import struct
import subprocess
import tempfile
import unittest
import zlib

from tests.tools import manifest, pictures
from tools.repository import module_command

NAME = "oracle/tilt"


def png(width, height, value):
    rows = b"".join(b"\0" + struct.pack(">H", value) * 3 * width for _ in range(height))

    def chunk(kind, data):
        check = struct.pack(">I", zlib.crc32(kind + data))
        return struct.pack(">I", len(data)) + kind + data + check

    header = struct.pack(">IIBBBBB", width, height, 16, 2, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b"")


class FailureKinds(unittest.TestCase):
    def setUp(self):
        self.compare = os.environ["COMPARE"]
        self.holder = tempfile.TemporaryDirectory()
        self.addCleanup(self.holder.cleanup)
        self.folder = pathlib.Path(self.holder.name)
        self.references = self.folder / "references"
        (self.references / "oracle").mkdir(parents=True)
        self.entry = manifest.entries()[NAME]
        self.reference = self.references / "oracle" / "tilt.exr"
        grey = self.picture(self.folder / "grey.png", self.entry.width, self.entry.height, 30000)
        subprocess.run([self.compare, "average", str(self.reference), str(grey)], check=True)
        self.record = dict.fromkeys(manifest.FIELDS, "something") | {
            "file": "oracle/tilt.exr",
            "sources_sha256": self.entry.sources_sha256(),
            "pixels_sha256": pictures.pixel_hash(self.compare, self.reference),
            "comparison": manifest.ORACLE_COMPARISON,
        }
        self.save(self.record)

    def picture(self, path, width, height, value):
        path.write_bytes(png(width, height, value))
        return path

    def save(self, record):
        manifest.save({NAME: record} if record else {}, self.references)

    def check(self, script, *more):
        stand_in = self.folder / "stand_in"
        stand_in.write_text("#!/bin/sh\n" + script + "\n")
        stand_in.chmod(0o755)
        done = subprocess.run(
            module_command(
                "tests.tools.check_picture",
                NAME,
                "--povray",
                stand_in,
                "--compare",
                self.compare,
                "--work",
                self.folder / "work",
                "--references",
                self.references,
                *more,
            ),
            capture_output=True,
            text=True,
            check=False,
        )
        return done.returncode, done.stderr

    def expect(self, outcome, script):
        code, message = self.check(script)
        self.assertEqual(code, pictures.OUTCOMES[outcome], message)
        self.assertIn(outcome, message)
        page = self.folder / "work" / NAME / "as_is" / "index.html"
        self.assertIn(outcome, page.read_text())
        return message, page

    def copy_of(self, width, height, value):
        return f"cp '{self.picture(self.folder / 'result.png', width, height, value)}' new.png"

    def test_same(self):
        code, message = self.check(self.copy_of(self.entry.width, self.entry.height, 30000))
        self.assertEqual(code, 0, message)

    def test_different(self):
        _, page = self.expect("different", self.copy_of(self.entry.width, self.entry.height, 31000))
        for word in (
            "new.png",
            "reference.png",
            "difference.png",
            "Worst pixels",
            "Render it again",
            "Accept the change",
            "tests.tools.update_references",
        ):
            self.assertIn(word, page.read_text())
        for name in ("new.png", "reference.png", "difference.png"):
            self.assertTrue((page.parent / name).is_file(), name)

    def test_wrong_size(self):
        self.expect("wrong size", self.copy_of(self.entry.width, self.entry.height + 1, 30000))

    def test_crash(self):
        message, _ = self.expect("crash", "echo all is lost; kill -SEGV $$")
        self.assertIn("signal 11", message)
        self.assertIn("all is lost", message)

    def test_error_exit(self):
        message, _ = self.expect("crash", "exit 3")
        self.assertIn("exit code 3", message)

    def test_no_output(self):
        self.expect("no output", "exit 0")

    def test_an_old_output_does_not_count(self):
        self.check(self.copy_of(self.entry.width, self.entry.height, 30000))
        self.expect("no output", "exit 0")

    def test_unreadable(self):
        self.expect("unreadable", "echo this is no picture > new.png")

    def test_missing_reference(self):
        self.reference.unlink()
        self.expect("missing reference", self.copy_of(self.entry.width, self.entry.height, 30000))
        self.assertFalse(self.reference.exists(), "a missing reference must not be made up")

    def test_missing_entry(self):
        self.save(None)
        self.expect("missing reference", self.copy_of(self.entry.width, self.entry.height, 30000))

    def test_stale_reference(self):
        self.record["sources_sha256"] = {path: "0" * 64 for path in self.record["sources_sha256"]}
        self.save(self.record)
        self.expect("stale reference", self.copy_of(self.entry.width, self.entry.height, 30000))

    def test_missing_expected_difference(self):
        right = self.copy_of(self.entry.width, self.entry.height, 30000)
        code, message = self.check(right, "--expect", "different")
        self.assertEqual(code, pictures.OUTCOMES["failure"], message)

    def test_expected_difference(self):
        wrong = self.copy_of(self.entry.width, self.entry.height, 31000)
        code, message = self.check(wrong, "--expect", "different")
        self.assertEqual(code, 0, message)

    def test_a_crash_is_not_the_expected_difference(self):
        code, message = self.check("exit 1", "--expect", "different")
        self.assertEqual(code, pictures.OUTCOMES["crash"], message)

    def test_not_finite(self):
        header = b"PF\n1 1\n-1.0\n"
        picture = self.folder / "nan.pfm"
        picture.write_bytes(header + struct.pack("<fff", 1.0, float("nan"), 1.0))
        with self.assertRaises(pictures.Trouble) as caught:
            pictures.compare(self.compare, picture, picture, {"kind": "exact"})
        self.assertEqual(caught.exception.outcome, "not finite")

    def test_manifest_checks(self):
        def complaints(names=(NAME,)):
            records = manifest.load(self.references)
            return "\n".join(manifest.complaints(records, self.references, names, self.compare))

        self.assertEqual(complaints(), "")
        self.assertIn("has no entry", complaints((NAME, "oracle/other")))
        self.assertIn("no such case", complaints(()))
        self.picture(self.folder / "other.png", self.entry.width, self.entry.height, 1)
        subprocess.run([self.compare, "average", str(self.references / "stray.exr"), str(self.folder / "other.png")], check=True)
        self.assertIn("stray.exr: is no entry's picture", complaints())
        (self.references / "stray.exr").replace(self.reference)
        self.assertIn("not those of the manifest", complaints())
        self.reference.unlink()
        self.assertIn("is missing", complaints())
        del self.record["reason"]
        self.save(self.record)
        self.assertIn("lacks reason", complaints())


if __name__ == "__main__":
    unittest.main()

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""A good series of patches passes, and each fault is found."""

import pathlib
import tempfile
import unittest

from tests.patch import check_patches

GOOD = """Description: add a camera item
 Why it has to be here.
Author: povray-tilt-lens developers
Origin: other
Forwarded: not-needed
Last-Update: 2025-01-31
Hooks: Parser::Parse_Camera
Tests: parse.empty_block

--- a/source/a.cpp
+++ b/source/a.cpp
@@ -1,2 +1,3 @@
 one
+\ttilt_lens::Hook();
 two
"""


class CheckPatchesTest(unittest.TestCase):
    def faults(self, check, patches, series=None):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            for patch, text in patches.items():
                (folder / patch).parent.mkdir(exist_ok=True)
                (folder / patch).write_text(text, encoding="utf-8")
            listed = "\n".join(patches) if series is None else series
            (folder / "series").write_text(listed + "\n", encoding="utf-8")
            return list(check_patches.CHECKS[check](folder))

    def assert_fault(self, check, text, expected, **kwargs):
        faults = self.faults(check, {"camera/add-item.patch": text}, **kwargs)
        self.assertTrue(any(expected in fault for fault in faults), f"{expected!r} not in {faults}")

    def test_good_patch_passes_all(self):
        for check in check_patches.CHECKS:
            self.assertEqual(self.faults(check, {"camera/add-item.patch": GOOD}), [], check)

    def test_list(self):
        self.assert_fault("list", GOOD, "no such file", series="camera/add-item.patch\ncamera/add-more.patch")
        self.assert_fault("list", GOOD, "listed 2 times", series="camera/add-item.patch\ncamera/add-item.patch")
        self.assert_fault("list", GOOD, "not listed", series="# camera/add-item.patch")
        for name in ("camera/01-Item.patch", "add-item.patch", "misc/add-item.patch"):
            faults = self.faults("list", {name: GOOD})
            self.assertTrue(any("named like" in fault for fault in faults), faults)

    def test_headers(self):
        for field in check_patches.REQUIRED_FIELDS:
            lines = [line for line in GOOD.splitlines() if not line.startswith(field + ":")]
            self.assert_fault("headers", "\n".join(lines), field)
        self.assert_fault("headers", GOOD.replace("2025-01-31", "January"), "expected a date")
        faults = self.faults("headers", {"fixes/mend-item.patch": GOOD})
        self.assertTrue(any("is to be reported" in fault for fault in faults), faults)

    def test_size(self):
        def longer(count):
            return GOOD.replace("+\ttilt", "+\tx();\n" * count + "+\ttilt")
        self.assertEqual(self.faults("size", {"camera/add-item.patch": longer(39)}), [])
        self.assert_fault("size", longer(40), "adds 41 lines")
        reasoned = longer(40).replace("Author:", "Size-Reason: a table\nAuthor:")
        self.assertEqual(self.faults("size", {"camera/add-item.patch": reasoned}), [])
        self.assert_fault("size", longer(80).replace("Author:", "Size-Reason: a table\nAuthor:"), "adds 81 lines")
        self.assert_fault("size", GOOD.replace("+\ttilt_lens::Hook();\n", ""), "adds no line")

    def test_style(self):
        self.assert_fault("style", GOOD.replace("Hook();", "Hook(); "), "white space at the end")
        self.assert_fault("style", GOOD.replace(" two", "-  tilt_lens::Hook();\n two"), "white space alone")


if __name__ == "__main__":
    unittest.main()

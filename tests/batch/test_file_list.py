# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later

import os
import subprocess

from tools import povray_run
from tests.batch import calls
from tests.batch.calls import SETTINGS, BatchTest

SCENE = (
    calls.STOCK
    + """
#declare Name = concat("cal", "culated.inc");
#include Name
text { ttf "timrom.ttf" "x" 0.1, 0 pigment { image_map { png "map.png" } } }
#fopen Data "data.txt" read
#if (file_exists("maybe.inc")) #end
"""
)


class FileList(BatchTest):
    def render(self, list_name="files", code=0):
        (self.folder / "scene.pov").write_text(SCENE)
        for name in ("calculated.inc", "data.txt"):
            (self.folder / name).write_text("// nothing\n")
        subprocess.run(["oiiotool", "--create", "4x4", "3", "-o", "map.png"], cwd=self.folder, check=True)
        command = povray_run.command(SETTINGS.povray, "scene.pov", "out.png", (8, 8))
        done = povray_run.run(command, self.folder, dict(self.env, TILT_LENS_FILE_LIST=list_name))
        self.assertEqual(done.code, code, done.told())
        return done.said

    def test_read_and_missing_files(self):
        self.render()
        entries = (self.folder / "files").read_bytes().split(b"\0")
        self.assertEqual(entries.pop(), b"")
        for name in (b"scene.pov", b"calculated.inc", b"map.png", b"data.txt"):
            self.assertIn(b"+" + name, entries)
        self.assertTrue(any(e.startswith(b"+") and e.endswith(b"/povray.ini") for e in entries), entries)
        self.assertTrue(any(e.startswith(b"+/") and e.endswith(b"include/timrom.ttf") for e in entries), entries)
        self.assertEqual([e for e in entries if e.startswith(b"=")], [b"=out.png"])
        self.assertIn(b"-timrom.ttf", entries)
        self.assertIn(b"-maybe.inc", entries)
        self.assertEqual(len(entries), len(set(entries)), "each name once")

    def test_unwritable_list_is_an_error(self):
        said = self.render("no/such/folder/files", code=1)
        self.assertIn("TILT_LENS_FILE_LIST", " ".join(said.split()))

    def test_without_the_variable_nothing_is_written(self):
        before = {"scene.pov", "calculated.inc", "data.txt", "map.png", "out.png"}
        self.render("")
        self.assertEqual(set(os.listdir(self.folder)), before)


if __name__ == "__main__":
    calls.main()

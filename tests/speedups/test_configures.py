# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Without the speedups, the other patches apply without fuzz.

usage: test_configures.py SOURCE DOWNLOADS TARBALL
"""

import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

SETTINGS = {}


def configure(folder):
    done = subprocess.run(
        (
            *("cmake", "--preset", "without-speedups", "-S", SETTINGS["source"], "-B", folder),
            *(f"-DTILT_LENS_DOWNLOADS={SETTINGS['downloads']}", f"-DPOVRAY_TARBALL={SETTINGS['tarball'].removeprefix('TARBALL=')}"),
        ),
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        check=False,
    )
    return done.returncode, done.stdout


class WithoutSpeedups(unittest.TestCase):
    def test_series_and_files(self):
        with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
            code, said = configure(name)
            self.assertEqual(code, 0, said[-4000:])
            applied = pathlib.Path(name, "upstream", "applied-patches").read_text(encoding="utf-8").split()
            compiled = pathlib.Path(name, "compile_commands.json").read_text(encoding="utf-8")
            compiled += "".join(path.read_text(encoding="utf-8") for path in pathlib.Path(name).rglob("Unity/*.cxx"))
            used = re.compile("speedups(/|::)")
            sources = [
                path
                for path in pathlib.Path(name, "upstream", "povray").rglob("*.[ch]*")
                if used.search(path.read_text(encoding="latin-1"))
            ]
        series = pathlib.Path(SETTINGS["source"], "patches", "series").read_text(encoding="utf-8").split()
        kept = [patch for patch in series if not patch.startswith("speedups/")]
        self.assertLess(len(kept), len(series))
        self.assertEqual(applied[-len(kept) :], kept)
        self.assertIn("povray-src/povray/source", compiled)
        self.assertEqual([line for line in compiled.splitlines() if "povray-src/speedups" in line], [])
        self.assertEqual(sources, [])


if __name__ == "__main__":
    SETTINGS.update(zip(("source", "downloads", "tarball"), sys.argv[1:4]))
    unittest.main(argv=sys.argv[:1])

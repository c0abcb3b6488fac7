# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The pages show the results of docs/benchmarks."""

import json
import pathlib
import shutil
import tempfile
import unittest

from benchmarks import pages, report


class Pages(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory(prefix="tilt_lens.")
        self.addCleanup(scratch.cleanup)
        self.docs = pathlib.Path(scratch.name)
        shutil.copytree(pages.DOCS / "benchmarks", self.docs / "benchmarks")
        for page in pages.DOCS.glob("*.md"):
            shutil.copy(page, self.docs)

    def text(self):
        return {page.name: page.read_text() for page in self.docs.glob("*.md")}

    def test_they_show_what_is_kept(self):
        self.assertEqual(pages.faults(self.docs), [])
        before = self.text()
        pages.update(self.docs)
        self.assertEqual(self.text(), before, "write the pages anew: benchmarks/run --pages")

    def test_each_kept_part_is_known_and_complete(self):
        for name, part in pages.load().items():
            self.assertIn(name, report.SECTIONS)
            self.assertTrue(part["program"] and part["machine"] and part["rows"], name)

    def test_kept_results_have_a_row_on_each_line(self):
        rows = [{"scene": f"scene {number}", "ratio": number / 3, "note": "x" * 60} for number in range(20)]
        text = pages.compact({"rows": rows})
        self.assertEqual(json.loads(text), {"rows": rows})
        self.assertEqual(len(text.splitlines()), len(rows) + 4)
        for path in (pages.DOCS / "benchmarks").glob("*.json"):
            self.assertEqual(path.read_text(), pages.compact(json.loads(path.read_text())) + "\n", path.name)

    def test_a_new_result_appears_in_its_place_alone(self):
        before = self.text()
        pages.save("loops", [["a function of the test", 1234.5]], "a program", self.docs)
        pages.update(self.docs)
        changed = [name for name, text in self.text().items() if text != before[name]]
        self.assertEqual(changed, ["notebook.md"])
        self.assertIn("| a function of the test | 1234.5 |\n\nMeasured with a program, on ", self.text()["notebook.md"])

    def test_summary_names_all_its_programs(self):
        kept = self.docs / "benchmarks" / "tilted.json"
        kept.write_text(json.dumps({**json.loads(kept.read_text()), "program": "another program"}))
        pages.update(self.docs)
        self.assertIn("; and with another program, on ", self.text()["benchmarks.md"])

    def test_missing_double_and_unknown_places_are_reported(self):
        page = self.docs / "notebook.md"
        text = page.read_text()
        place = "<!-- benchmark: {} -->\n<!-- end of benchmark -->\n"
        for more, words in ((place.format("loops"), "loops is shown in 2 places"), (place.format("nothing"), "a place for nothing")):
            page.write_text(text + more)
            self.assertIn(words, "\n".join(pages.faults(self.docs)))
        page.write_text(text.replace("<!-- benchmark: loops -->", ""))
        self.assertIn("loops is shown in 0 places", "\n".join(pages.faults(self.docs)))
        with self.assertRaises(ValueError):
            pages.update(self.docs)


if __name__ == "__main__":
    unittest.main()

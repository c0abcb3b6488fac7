# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Findings and wrong rays that the stress run must report."""

import pathlib
import tempfile
import unittest

from tests.stress import rays, reports, sanitizers

OURS = "/src/povray-src/povray/source/backend/scene/tilt_lens_camera.cpp:30"
UPSTREAM = "/build/upstream/povray/source/backend/lighting/media.cpp:12"
THREADS = """WARNING: ThreadSanitizer: data race (pid=3)
  Write of size 8 at 0x7b08 by thread T3:
    #0 pov::f() {place} (povray+0x1)

  Previous read of size 8 at 0x7b08 by thread T2:
    #0 pov::g() /build/upstream/povray/source/base/x.cpp:7 (povray+0x2)

SUMMARY: ThreadSanitizer: data race
"""
RACE = """WARNING: ThreadSanitizer: data race (pid=3)
  Write of size 8 at 0x7b08 by thread T3 (mutexes: write M1):
    #0 memcpy ../../../../src/libsanitizer/x.inc:827 (libtsan.so.2+0x6)
    #1 std::vector<int>::push_back(int const&) /usr/include/c++/12/bits/stl_vector.h:1 (povray+0x1)
    #2 {inner} ../../povray-src/povray/source/backend/x.cpp:12 (povray+0x1)
    #3 {outer} /build/upstream/povray/source/backend/y.cpp:12:3 (povray+0x1)

  Previous read of size 8 at 0x7b08 by thread T2:
    #0 {other} /build/upstream/povray/source/base/x.cpp:7 (povray+0x2)

  Location is heap block of size 8 at 0x7b08 allocated by main thread:
    #0 made() /build/upstream/z.cpp:1 (povray+0x3)

  Thread T3 (tid=5, running) created by thread T2 at:
    #0 pthread_create ../../../../src/libsanitizer/y.cpp:1001 (libtsan.so.2+0x5)

SUMMARY: ThreadSanitizer: data race
"""
UNDEFINED = """{place}:9: runtime error: division by zero
    #0 0x55 in pov::f() {place}
"""
OF_CLANG = """/build/upstream/povray/source/x.cpp:9:43: runtime error: downcast of address 0x614 which does not point to an object
0x614: note: object is of type 'pov::LightSource'
 00 00 00 00  70 16 5f 4f ae 55 00 00
              ^~~~~~~~~~~~~~~~~~~~~~~
              vptr for 'pov::LightSource'
    #0 0x55 in pov::f() {place}
"""
ADDRESS = """==7==ERROR: AddressSanitizer: heap-use-after-free on address 0x60
READ of size 8 at 0x60 thread T0
    #0 0x55 in pov::f() {place}
"""
VALGRIND = """==7== Conditional jump or move depends on uninitialised value(s)
==7==    at 0x1: pov::f() ({place})
==7==
"""


class Findings(unittest.TestCase):
    def found(self, text):
        with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
            (pathlib.Path(name) / "log.1").write_text("Parsing...\n" + text + "Done.\n")
            return [len(blocks) for blocks in reports.findings(name)[:2]]

    def test_tools(self):
        for text in (THREADS, UNDEFINED, OF_CLANG, ADDRESS, VALGRIND):
            with self.subTest(text):
                self.assertEqual(self.found(text.format(place=OURS)), [1, 0])
                self.assertEqual(self.found(text.format(place=UPSTREAM)), [0, 1])
                self.assertEqual(self.found(text.format(place=UPSTREAM) + text.format(place=OURS)), [1, 1])

    def test_progress_in_between(self):
        lines = THREADS.format(place=OURS).splitlines(keepends=True)
        for at in range(1, len(lines)):
            for words in ("Rendered 24 of 3072 pixels (0%)\n", "\n", "Parsing...\n\n"):
                text = "".join((*lines[:at], words, *lines[at:]))
                self.assertEqual(self.found(text + text), [2, 0], text)

    def test_nothing(self):
        self.assertEqual(self.found("Parse Error: tilt 90\n"), [0, 0])

    def test_said_on_standard_error_is_kept(self):
        with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
            folder = pathlib.Path(name)
            program = folder / "program"
            program.write_text('#!/bin/sh\necho "$*: runtime error: x" >&2\n')
            program.chmod(0o755)
            script = sanitizers.listener(program, folder, "+WT4")
            row = sanitizers.watched("x", "tool", [[str(script), "+WT1"]], folder, folder)
            self.assertEqual((row["others"], row["failed"]), (1, 0))
            self.assertIn("+WT1 +WT4:", row["first"][0])

    def test_failed_runs_say_why(self):
        with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
            row = sanitizers.watched("x", "tool", [["sh", "-c", "echo why; exit 3"]], pathlib.Path(name), name)
        self.assertEqual(row["failed"], 1)
        self.assertIn("exit code 3\nwhy\n", row["said"][0])
        self.assertTrue(sanitizers.faults({"rows": [row]}))

    def test_a_deaf_sanitizer_is_a_fault(self):
        row = {"what": "x, nothing suppressed", "tool": "t", "ours": 0, "others": 0, "failed": 0}
        self.assertTrue(sanitizers.faults({"rows": [row]}))
        self.assertFalse(sanitizers.faults({"rows": [{**row, "others": 1}]}))


class Known(unittest.TestCase):
    NAMES = ("race:pov::f", "race:pov::g")

    def known(self, inner, outer, other="pov::g()"):
        return reports.known(RACE.format(inner=inner, outer=outer, other=other), [name.split(":", 1)[1] for name in self.NAMES])

    def test_both_sides(self):
        self.assertEqual(self.known("pov::f(int)", "main"), ("pov::f", "pov::g"))
        self.assertEqual(self.known("pov::f", "main", "pov::f<double>(x)"), ("pov::f",))

    def test_one_side(self):
        self.assertEqual(self.known("pov::f(int)", "main", "pov::h()"), ())
        self.assertEqual(self.known("pov::h(int)", "main"), ())

    def test_outer_functions_hide_nothing(self):
        """A thread's first function would hide the whole thread."""
        self.assertEqual(self.known("tilt_lens::Cell::Add()", "pov::f(int)"), ())

    def test_other_stacks_do_not_count(self):
        text = RACE.format(inner="pov::f()", outer="main", other="pov::g()")
        made = "  Mutex M1 (0x7b68) created at:\n    #0 made() /build/upstream/z.cpp:1 (povray+0x3)\n\n"
        for title in ("Mutex M1 (0x7b68) created", "As if synchronized via sleep", "sages of size"):
            self.assertEqual(
                reports.known(
                    text.replace("  Location", made.replace("Mutex M1 (0x7b68) created", title) + "  Location"), ["pov::f", "pov::g"]
                ),
                ("pov::f", "pov::g"),
            )

    def test_a_lost_stack(self):
        """The other side decides; two lost stacks are unknown."""
        lost = "    [failed to restore the stack]\n"
        for side, names in ("pov::f()", ("pov::f", "a lost stack")), ("pov::h()", ()):
            text = RACE.format(inner=side, outer="main", other="pov::g()")
            begin = text.index("    #0 pov::g()")
            text = text[:begin] + lost + text[text.index("\n", begin) + 1 :]
            self.assertEqual(reports.known(text, ["pov::f", "pov::g"]), names)
        self.assertEqual(reports.known("WARNING: ThreadSanitizer: data race\n  Write of size 8 at 0x7:\n" + lost, ["pov::f"]), ())

    def test_a_name_is_whole(self):
        self.assertEqual(self.known("pov::four()", "main"), ())

    def test_other_tools(self):
        self.assertEqual(reports.known(UNDEFINED.format(place=OURS), ["pov::f"]), ())

    def test_each_name_has_its_reason(self):
        for tool in ("ubsan", "tsan", "valgrind"):
            for name, reason in reports.suppressed(tool):
                self.assertGreater(len(reason), 20, name)


class Rays(unittest.TestCase):
    def tally(self, **changed):
        spread = {"count": 1, "worst": 0.0, "sum": 0.0, "by_power": {}}
        tally = {**{name: 0 for name in rays.COUNTS}, **{name: dict(spread) for name in rays.SPREADS}, "refusals": {}}
        for name, worst in changed.items():
            tally[name]["worst"] = worst
        return {"corners": rays.merge([tally])}

    def test_faults(self):
        self.assertEqual(rays.faults(self.tally(well_posed=4.0, pixels=1e-6, narrow_pixels=1.0, narrow_roundings=4.0)), [])
        for name, worst in (
            ("well_posed", 4.1),
            ("pixels", 1.1e-6),
            ("pixels", None),
            ("narrow_roundings", 4.1),
            ("narrow_roundings", None),
        ):
            with self.subTest(name=name, worst=worst):
                self.assertEqual(len(rays.faults(self.tally(**{name: worst}))), 1)

    def test_reversed_rays_are_seen(self):
        tally = self.tally()["corners"]
        self.assertEqual(len(rays.faults({"behind": tally})), 1)
        tally["obvious_pixels"]["by_power"]["30"] = 1
        self.assertEqual(rays.faults({"behind": tally}), [])


if __name__ == "__main__":
    unittest.main()

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The stress run does not take results of other programs, reports findings, and tells CPU time from waiting."""

import pathlib
import sys
import tempfile
import time
import types
import unittest
import unittest.mock

from tests.stress import fuzz, harness, rays, reports, run, sanitizers, soak, watch

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


class Once(unittest.TestCase):
    """A stored result is that of the same program."""

    def setUp(self):
        holder = tempfile.TemporaryDirectory(prefix="tilt_lens.")
        self.addCleanup(holder.cleanup)
        self.folder = pathlib.Path(holder.name)
        self.program, self.script = self.folder / "program", self.folder / "script.py"
        self.program.write_bytes(b"one")
        self.script.write_text("a")
        self.made = 0
        self.faulty = ()

    def ask(self, name="x"):
        def make():
            self.made += 1
            return self.made
        return harness.once(self.folder, name, [self.program, self.script], make, lambda number: number in self.faulty)

    def test_same_files(self):
        self.assertEqual([self.ask(), self.ask(), self.ask("other"), self.ask()], [1, 1, 2, 1])

    def test_another_program(self):
        self.ask()
        self.program.write_bytes(b"two")
        self.assertEqual(self.ask(), 2)
        self.program.write_bytes(b"one")
        self.assertEqual(self.ask(), 1)

    def test_another_script(self):
        self.ask()
        self.script.write_text("b")
        self.assertEqual(self.ask(), 2)

    def test_what_could_not_be_made_is_not_kept(self):
        with self.assertRaises(ZeroDivisionError):
            harness.once(self.folder, "x", [self.program, self.script], lambda: 1 / 0, lambda result: [])
        self.assertEqual(self.ask(), 1)

    def test_what_has_faults_is_not_kept(self):
        self.faulty = (1, 2)
        self.assertEqual([self.ask(), self.ask(), self.ask(), self.ask()], [1, 2, 3, 3])


class Runs(unittest.TestCase):
    """A part whose results are lists of their faults."""

    def setUp(self):
        holder = tempfile.TemporaryDirectory(prefix="tilt_lens.")
        self.addCleanup(holder.cleanup)
        folder = pathlib.Path(holder.name)
        self.setup = harness.Setup(folder)
        results = iter((["broken"], [], ["broken again"]))
        self.part = types.SimpleNamespace(faults=lambda result: result, measure=lambda setup, **_: harness.once(
            setup.work("part"), "x", [__file__], lambda: next(results), self.part.faults))
        for place, name, value in ((run.importlib, "import_module", lambda _: self.part), (harness, "RESULTS", folder / "results"),
                                   (run, "QUICK", {"part": {}})):
            patch = unittest.mock.patch.object(place, name, value)
            patch.start()
            self.addCleanup(patch.stop)

    def test_short_forms_take_nothing_from_another_run(self):
        self.assertEqual([run.quickly(self.setup, ["part"]) for _ in range(3)], [["part: broken"], [], ["part: broken again"]])
        self.assertIsNone(harness.load("part"))

    def test_long_forms_store_results_without_faults(self):
        self.assertEqual(run.at_length(self.setup, ["part"]), ["part: broken"])
        self.assertIsNone(harness.load("part"))
        self.assertEqual([run.at_length(self.setup, ["part"]) for _ in range(2)], [[], []])
        self.assertEqual(harness.load("part"), [])


class Corpus(unittest.TestCase):
    """Inputs that the parser's target ignores are not kept."""

    def test_refused_inputs_go(self):
        kept = [b"tilt 6", b"tilt 6\n\tswing 2", b""]
        refused = [b"#while(1)", b'"text"', b"tilt \0 6", b"tilt \x7f", b"tilt \xc3\xa9", b"tilt 6\r\n"]
        with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
            folder = pathlib.Path(name)
            for number, data in enumerate(kept + refused):
                (folder / str(number)).write_bytes(data)
            fuzz.drop_refused(folder)
            self.assertEqual({path.read_bytes() for path in folder.iterdir()}, set(kept))


class Soak(unittest.TestCase):
    def faults(self, frame=0, tile=0, pixel=0, once=0):
        rows = (384, 1536)
        return soak.faults({"frames": [{"frames": n, "kept": 4000 + once * (n > 10) + n * frame, "most": 9000} for n in (10, 20)],
                            "rows": [{"rows": n, "kept": 4000 + n // soak.TILE * tile,
                                      "most": 9000 + (soak.PIXEL + pixel) * soak.WIDTH * n} for n in rows]})

    def test_nothing_is_left(self):
        self.assertEqual(self.faults(), [])
        self.assertEqual(self.faults(once=64), [])

    def test_the_smallest_block(self):
        for fault in ({"frame": soak.SMALLEST}, {"tile": soak.SMALLEST}, {"pixel": 9}):
            self.assertEqual(len(self.faults(**fault)), 1, fault)

    def test_counts_among_messages(self):
        one, two = ('{"jemalloc":{"stats":{"allocated":%d}}}' % number for number in (5, 7))
        self.assertEqual(soak.counts(f"Parsing...\n{one}\n{two[:20]}Done.{two[20:]}\n{two}{one}"), [5, 7, 5])


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
        """The wrapper passes on the program's messages, and its options come last."""
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
        self.assertEqual(row["said"], ["exit code 3: why\n"])
        self.assertTrue(sanitizers.faults({"rows": [row]}))

    def test_a_deaf_sanitizer_is_a_fault(self):
        row = {"what": "x, nothing suppressed", "tool": "t", "ours": 0, "others": 0, "failed": 0}
        self.assertTrue(sanitizers.faults({"rows": [row]}))
        self.assertFalse(sanitizers.faults({"rows": [{**row, "others": 1}]}))


class Known(unittest.TestCase):
    """A race is known by the innermost function of both sides."""

    NAMES = ("race:pov::f", "race:pov::g")

    def known(self, inner, outer, other="pov::g()"):
        return reports.known(RACE.format(inner=inner, outer=outer, other=other),
                             [name.split(":", 1)[1] for name in self.NAMES])

    def test_both_sides(self):
        self.assertEqual(self.known("pov::f(int)", "main"), ("pov::f", "pov::g"))
        self.assertEqual(self.known("pov::f", "main", "pov::f<double>(x)"), ("pov::f",))

    def test_one_side(self):
        self.assertEqual(self.known("pov::f(int)", "main", "pov::h()"), ())
        self.assertEqual(self.known("pov::h(int)", "main"), ())

    def test_outer_functions_hide_nothing(self):
        """Otherwise a thread's first function would hide everything that the thread does."""
        self.assertEqual(self.known("tilt_lens::Cell::Add()", "pov::f(int)"), ())

    def test_other_stacks_do_not_count(self):
        text = RACE.format(inner="pov::f()", outer="main", other="pov::g()")
        made = "  Mutex M1 (0x7b68) created at:\n    #0 made() /build/upstream/z.cpp:1 (povray+0x3)\n\n"
        for title in ("Mutex M1 (0x7b68) created", "As if synchronized via sleep", "sages of size"):
            self.assertEqual(reports.known(text.replace("  Location", made.replace("Mutex M1 (0x7b68) created", title) + "  Location"),
                                           ["pov::f", "pov::g"]), ("pov::f", "pov::g"))

    def test_a_lost_stack(self):
        """The other side decides; a race with two lost stacks is not known."""
        lost = "    [failed to restore the stack]\n"
        for side, names in ("pov::f()", ("pov::f", "a lost stack")), ("pov::h()", ()):
            text = RACE.format(inner=side, outer="main", other="pov::g()")
            begin = text.index("    #0 pov::g()")
            text = text[:begin] + lost + text[text.index("\n", begin) + 1:]
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


class Watch(unittest.TestCase):
    """A limit in seconds is one of processor time."""

    def watched(self, code, limit):
        with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
            return watch.watch([sys.executable, "-c", code], pathlib.Path(name) / "log", 0.1, limit)

    def test_waiting_does_not_count(self):
        self.assertEqual(self.watched("import time; time.sleep(1)", 0.5).returncode, 0)

    def test_working_counts(self):
        begin = time.monotonic()
        done = self.watched("while True: pass", 0.5)
        self.assertEqual(done.returncode, -9)
        self.assertGreater(done.cpu, 0.5)
        self.assertGreaterEqual(time.monotonic() - begin, done.cpu / 2)


class Rays(unittest.TestCase):
    def tally(self, **changed):
        spread = {"count": 1, "worst": 0.0, "sum": 0.0, "by_power": {}}
        tally = {**{name: 0 for name in rays.COUNTS}, **{name: dict(spread) for name in rays.SPREADS}, "refusals": {}}
        for name, worst in changed.items():
            tally[name]["worst"] = worst
        return {"corners": rays.merge([tally])}

    def test_faults(self):
        self.assertEqual(rays.faults(self.tally(well_posed=4.0, pixels=1e-6, narrow_pixels=1.0, narrow_roundings=4.0)), [])
        for name, worst in (("well_posed", 4.1), ("pixels", 1.1e-6), ("pixels", None), ("narrow_roundings", 4.1),
                            ("narrow_roundings", None)):
            with self.subTest(name=name, worst=worst):
                self.assertEqual(len(rays.faults(self.tally(**{name: worst}))), 1)

    def test_reversed_rays_are_seen(self):
        """Reversed rays of the obvious formula, if the focus lies behind the camera: shows that the test would detect ours."""
        tally = self.tally()["corners"]
        self.assertEqual(len(rays.faults({"behind": tally})), 1)
        tally["obvious_pixels"]["by_power"]["30"] = 1
        self.assertEqual(rays.faults({"behind": tally}), [])


if __name__ == "__main__":
    unittest.main()

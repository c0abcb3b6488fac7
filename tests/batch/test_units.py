# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Parts of ./batch without POV-Ray."""

import contextlib
import io
import os
import pathlib
import re
import shlex
import shutil
import struct
import subprocess
import tempfile
import time
import unittest
import unittest.mock

from tests.batch import calls
from tools.batch import batch, key, merge, plan, pov_options, povray, progress, slurm, store, task
from tools.repository import ROOT


class Bands(unittest.TestCase):
    def test_every_row_once_for_any_number(self):
        for height in (2, 3, 31, 32, 33, 64, 75, 100, 481):
            for count in range(1, height + 3):
                bands = plan.cut_bands(height, count)
                rows = [row for first, last in bands for row in range(first, last + 1)]
                self.assertEqual(rows, list(range(1, height + 1)), (height, count, bands))
                if len(bands) > 1:
                    self.assertGreater(bands[0][1], 1, "+SR1 +ER1 means all rows")

    def test_requested_number(self):
        self.assertEqual(len(plan.cut_bands(100, 7)), 7)
        self.assertEqual(len(plan.cut_bands(320, 10)), 10)
        self.assertEqual(plan.cut_bands(1, 5), [[1, 1]])

    def test_cut_between_blocks(self):
        for height, count in ((75, 3), (480, 15), (480, 4), (2160, 8)):
            self.assertTrue(all(last % 32 == 0 for _, last in plan.cut_bands(height, count)[:-1]))


class Values(unittest.TestCase):
    def test_ranges_are_exact(self):
        self.assertEqual(plan.values("-8:8:4"), ["-8", "-4", "0", "4", "8"])
        self.assertEqual(plan.values("0.1:0.4:0.1"), ["0.1", "0.2", "0.3", "0.4"])
        self.assertEqual(plan.values("3:1:-1"), ["3", "2", "1"])
        self.assertEqual(plan.values("1e2,1e-3"), ["100", "0.001"])

    def test_what_is_wrong_is_named(self):
        for text, said in (
            ("a", "not a number"),
            ("1:2", "FROM:TO:STEP"),
            ("1:2:0", "not zero"),
            ("1:2:-1", "0 values"),
            ("1,1.0", "twice"),
            ("nan", "FROM:TO:STEP"),
            ("", "not a number"),
            ("0:1:1e-9", "values"),
        ):
            with self.assertRaisesRegex(store.BatchError, said, msg=text):
                plan.values(text)

    def test_sets(self):
        self.assertEqual(plan.parse_sets(["A=1,2", "B=3"]), [("A", ["1", "2"]), ("B", ["3"])])
        for words, said in ((["A"], "NAME=VALUES"), (["A=1", "A=2"], "twice"), (["1A=1"], "NAME=VALUES")):
            with self.assertRaisesRegex(store.BatchError, said):
                plan.parse_sets(words)


class Options(unittest.TestCase):
    def test_what_the_batch_sets_is_refused(self):
        for word in (
            "+Iother.pov",
            "+Oa.png",
            "+C",
            "-C",
            "+SR1",
            "+ER0.5",
            "+SC3",
            "+EC4",
            "+SF1",
            "+EF2",
            "+KFI1",
            "+KFF9",
            "+UF",
            "+TH",
            "Output_File_Name=x",
            "Continue_Trace=on",
            "Start_Row=1",
            "Final_Frame=9",
            "+FJ",
            "+FT",
            "Post_Frame_Command=rm",
            "+WT0",
            "picture.pov",
            "Output_File_Type=J",
            "+HIx.inc",
            "+RFsaved",
        ):
            with self.assertRaises(store.BatchError, msg=word):
                pov_options.PovOptions([word])

    def test_the_others_pass(self):
        words = ["+W64", "-A", "+AM2", "+UA", "Declare=A=1", "Width=3", "+KC", "-TH", "+K0.5", "+Q9", "+CC", "Dither=off"]
        self.assertEqual(pov_options.PovOptions(words).words, words)

    def test_files_threads_and_kind(self):
        options = pov_options.PovOptions(['+L"my files"', "Library_Path=b", "+WT2", "+FN16", "quick.ini[draft]"])
        self.assertEqual(list(options.named_files("/x")), ["/x/my files", "/x/b", "/x/quick.ini"])
        self.assertEqual((options.threads, options.kind, options.words), (2, "png", ["+FN16", "../../inputs/options0.ini[draft]"]))


def message(contents):
    return b"POVRAYMS\0\0\3p" + struct.pack(">i", len(contents)) + b"RAWS" + contents


class StateFile(unittest.TestCase):
    head = b"POV-Ray Render State File\0\0\x000001".ljust(512, b"\1")

    def test_only_whole_messages_are_kept(self):
        whole = self.head + message(b"a" * 5000) + message(b"b" * 300)
        cut = message(b"c" * 4000)
        for length in (0, 1, 7, 8, 15, 19, 20, 3000):
            self.assertEqual(povray.whole_length(whole + cut[:length], True), len(whole))
        self.assertEqual(povray.whole_length(whole + cut, True), len(whole + cut))

    def test_not_a_state_file(self):
        self.assertEqual(povray.whole_length(b"", True), 0)
        self.assertEqual(povray.whole_length(b"x" * 9000, True), 0)

    def test_black_pictures_are_kept_on_the_same_machine(self):
        black = self.head + message(b"\0" * 20000) + message(b"\0" * 20000)
        self.assertEqual(povray.whole_length(black, True), len(black))

    def test_unwritten_pages_end_it(self):
        first = self.head + message(b"a" * 9000)
        lost = bytearray(first + message(b"b" * 30000) + message(b"c" * 9000))
        lost[12288:16384] = bytes(4096)
        self.assertEqual(povray.whole_length(bytes(lost), False), len(first))

    def test_another_machine_s_file_is_cut(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            lost = bytearray(self.head + message(b"a" * 9000) + message(b"b" * 30000))
            lost[16384:20480] = bytes(4096)
            (folder / "picture.pov-state").write_bytes(lost)
            (folder / "boot.json").write_text('"another start"')
            self.assertTrue(povray.prepare_state(folder))
            self.assertEqual((folder / "picture.pov-state").stat().st_size, 512 + 20 + 9000)
            (folder / "picture.pov-state").write_bytes(lost[:600])
            self.assertFalse(povray.prepare_state(folder))
            self.assertFalse((folder / "picture.pov-state").exists())


class Lists(unittest.TestCase):
    links = key.Links({"here": "/a b", "scene": "/c"})

    def test_names_come_back(self):
        self.assertEqual(self.links.real("../../inputs/here/x.inc"), "/a b/x.inc")
        self.assertEqual(self.links.real("../../inputs/scene/../x"), "/c/../x")
        self.assertEqual(self.links.real("/usr/x"), "/usr/x")
        self.assertIsNone(self.links.real("own.inc"))
        self.assertIsNone(self.links.real("../../inputs/povray.ini"))

    def test_any_name_in_the_list(self):
        with tempfile.TemporaryDirectory() as name:
            path = pathlib.Path(name) / "files"
            path.write_bytes(b"+/a\nb\0-/c\0+/c\0-/d'\"\0+picture.pov-state\0=/e.png\0")
            self.assertEqual(key.listed_files(path, self.links), ({"/a\nb", "/c"}, {"/d'\""}))
            with self.assertRaisesRegex(store.BatchError, "does not list"):
                key.listed_files(path.with_name("none"), self.links)

    def test_a_file_that_was_written_while_a_unit_read_it(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            path = folder / "own.inc"
            path.write_text("#declare Own = 1;")
            (folder / "files").write_bytes(b"+" + os.fsencode(path) + b"\0")
            files, stamps = key.hashes([str(path)]), {str(path): key.file_stamp(path)}
            description = {"key": {"files": files, "missing": []}, "stamps": stamps, "links": {}}
            begun = time.time()
            before = task.stamps_before(description, folder)
            self.assertEqual(task.check_inputs(description, folder, before, begun), ({}, []))
            # only the directory entry shows the change
            times = path.stat()
            path.write_text("#declare Own = 2;")
            path.write_text("#declare Own = 1;")
            os.utime(path, ns=(times.st_atime_ns, times.st_mtime_ns))
            with self.assertRaisesRegex(store.BatchError, "written while it was being read"):
                task.check_inputs(description, folder, before, begun)

    def test_a_file_with_a_date_in_the_future(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            path = folder / "own.inc"
            path.write_text("#declare Own = 1;")
            os.utime(path, (time.time() + 1e6, time.time() + 1e6))
            (folder / "files").write_bytes(b"+" + os.fsencode(path) + b"\0")
            files, begun = key.hashes([str(path)]), time.time() + 1.0
            for known in (files, {}):
                description = {"key": {"files": known, "missing": []}, "stamps": {}, "links": {}}
                extra = {} if known else files
                for before in (task.stamps_before(description, folder), key.change_stamps(known)):
                    self.assertEqual(task.check_inputs(description, folder, before, begun), (extra, []))
            with self.assertRaisesRegex(store.BatchError, "written while it was being read"):
                task.check_inputs(description, folder, {}, begun - 100.0)
            before = task.stamps_before(description, folder)
            self.assertEqual(task.check_inputs(description, folder, before, begun - 100.0), (files, []))
            path.write_text("#declare Own = 1;")
            with self.assertRaisesRegex(store.BatchError, "written while it was being read"):
                task.check_inputs(description, folder, before, begun)

    def test_array_ranges(self):
        self.assertEqual(slurm.ranges([0, 1, 2, 5, 7, 8]), "0-2,5,7-8")


class Documents(unittest.TestCase):
    def commands(self):
        for page in ("README.md", "docs/batch.md"):
            for line in (ROOT / page).read_text().splitlines():
                found = re.match(r"    (?:python3 -m tools.cluster 3 )?\./batch (.*)", line)
                if found and "SCENE" not in line:
                    yield page, shlex.split(found.group(1))

    def test_each_command_is_understood_and_its_scene_is_there(self):
        commands = list(self.commands())
        self.assertGreater(len(commands), 6)
        for page, words in commands:
            settings, rest = batch.parser().parse_known_args(words)
            pov_options.PovOptions(rest)
            if settings.scene != "scene.pov":
                self.assertTrue((ROOT / settings.scene).is_file(), f"{page}: {words}")

    def test_every_option_is_in_the_page(self):
        page = (ROOT / "docs/batch.md").read_text()
        for kind in ("still", "film", "sweep"):
            done = subprocess.run([str(ROOT / "batch"), kind, "--help"], capture_output=True, text=True, check=True)
            for option in set(re.findall(r"--[a-z]+", done.stdout)) - {"--help", "--mem"}:
                self.assertIn(f"`{option}", page)


class Terminal(io.StringIO):
    def isatty(self):
        return True

    def fileno(self):
        return 2


class ProgressLine(unittest.TestCase):
    description = {"key": {"bands": [[1, 9]], "pictures": [{"label": f"frame {n}"} for n in range(1, 6)]}}

    def told(self, columns, stream):
        clock = unittest.mock.patch.object(time, "monotonic", lambda: 1000.0)
        with tempfile.TemporaryDirectory() as name, contextlib.redirect_stderr(stream), clock:
            work = store.Work(name)
            work.make()
            line = progress.Progress(work, self.description)
            for number, state in enumerate(("done", "running", "failed")):
                record = {"since": time.time() - 300, "log": str(work.log(0)), "begins": 9}
                store.write_json(work.record(state, plan.unit_name(number, 1)), record)
            work.log(0).write_text("old (99%)Rendered 1 of 3 pixels (33% of the work)\r")
            line.begun -= 10
            size = os.terminal_size((columns, 24))
            with unittest.mock.patch.object(os, "get_terminal_size", lambda _: size):
                line.show()
                line.show()
                line.show(final=True)
        return stream.getvalue()

    def test_overwritten_line(self):
        text = "1 of 5 pictures done, 1 running, 1 failed, 28 s left: frame 2 (5 min, 33%)"
        self.assertEqual(self.told(80, Terminal()), f"\r\033[K{text}\r\033[K{text}\n")
        self.assertEqual(self.told(20, Terminal()), f"\r\033[K{text[:19]}\r\033[K{text[:19]}\n")

    def test_a_line_now_and_then_in_a_file(self):
        text = "1 of 5 pictures done, 1 running, 1 failed, 28 s left: frame 2 (5 min, 33%)\n"
        self.assertEqual(self.told(80, io.StringIO()), text)

    def test_hint_for_a_very_long_unit(self):
        with unittest.mock.patch.object(progress, "LONG", 5):
            self.assertIn("frame 2 has been running for 5 min; log: ", self.told(80, io.StringIO()))


class Joining(unittest.TestCase):
    def test_what_oiiotool_complains_of_is_told_from_its_beginning(self):
        with tempfile.TemporaryDirectory() as name:
            tool = pathlib.Path(name) / "oiiotool"
            tool.write_text("#!/bin/sh\necho 'ERROR: no space left on device' >&2\nseq 400 >&2\nexit 1\n")
            tool.chmod(0o755)
            full = shutil.disk_usage(name)._replace(free=4096)
            with unittest.mock.patch.dict(os.environ, PATH=f"{name}:{os.environ['PATH']}"), unittest.mock.patch.object(
                shutil, "disk_usage", lambda _: full
            ), self.assertRaises(store.BatchError) as raised:
                merge.oiiotool(name, ["--version"])
        said = str(raised.exception).splitlines()
        self.assertEqual(said[1], "  ERROR: no space left on device")
        self.assertRegex(said[-1], "^The disk is full: 4 KB are left")
        self.assertLess(len(said), 10)


class Records(unittest.TestCase):
    def test_written_whole(self):
        with tempfile.TemporaryDirectory() as name:
            path = pathlib.Path(name) / "r.json"
            store.write_json(path, {"name": os.fsdecode(b"\xff\n'")})
            self.assertEqual(store.read_json(path), {"name": os.fsdecode(b"\xff\n'")})
            path.write_text('{"cut')
            self.assertIsNone(store.read_json(path))
            self.assertEqual(os.listdir(name), ["r.json"])


class Interrupted(unittest.TestCase):
    def test_before_the_wait_begins(self):
        said = io.StringIO()
        with tempfile.TemporaryDirectory() as name, unittest.mock.patch.object(
            progress, "Progress", side_effect=KeyboardInterrupt
        ), contextlib.redirect_stderr(said), self.assertRaises(KeyboardInterrupt):
            batch.watch(store.Work(name), ["7", "8"], unittest.mock.Mock(quiet=True))
        self.assertIn("To end them: scancel 7 8", said.getvalue())


if __name__ == "__main__":
    calls.main()

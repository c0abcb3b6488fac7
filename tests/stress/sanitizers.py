# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The whole program under AddressSanitizer with UndefinedBehaviorSanitizer, ThreadSanitizer and valgrind.

The presets asan and tsan are built first. What is upstream's is suppressed by name in tests/stress/suppressions,
with a reason each; a finding counts as ours where a frame of its stack lies in one of our files.
"""

import os
import pathlib
import re
import subprocess
import tempfile

import common

SUPPRESSIONS = common.ROOT / "tests" / "stress" / "suppressions"
OURS = re.compile(r"tilt_lens|install_folders|whole_file")
BLOCKS = re.compile(r"(?:^.*runtime error: .*$|^.*(?:ERROR|WARNING): (?:Address|Leak|Thread)Sanitizer.*$|^==\d+== (?:Invalid|Conditional|Use of|Syscall).*$)"
                    r"(?:\n(?:\s+#\d+|==\d+==    |\s*$|  ).*)*", re.MULTILINE)
TUTORIAL = sorted((common.ROOT / "scenes" / "tutorial").glob("*.pov"))
MODULES = ("light", "noise", "cameras")  # of tests/render: radiosity, photons, media, interiors, bokeh


def environment(log):
    """Each sanitizer writes to files of its own, goes on after a finding, and knows upstream's."""
    return {**os.environ,
            "ASAN_OPTIONS": f"log_path={log}.asan:detect_leaks=0:halt_on_error=0:suppressions={SUPPRESSIONS}/asan.txt:"
                            "new_delete_type_mismatch=0",
            "UBSAN_OPTIONS": f"log_path={log}.ubsan:print_stacktrace=1:suppressions={SUPPRESSIONS}/ubsan.txt",
            "TSAN_OPTIONS": f"log_path={log}.tsan:halt_on_error=0:suppressions={SUPPRESSIONS}/tsan.txt:second_deadlock_stack=1"}


def findings(folder):
    """Blocks of all logs: (ours, others)."""
    ours, others = [], []
    for path in folder.glob("log.*"):
        for block in BLOCKS.findall(path.read_text(errors="replace")):
            (ours if OURS.search(block) else others).append(block[:1500])
    return ours, others


def build(setup, preset):
    """The program and what the tests need."""
    for command in (["cmake", "--preset", preset], ["cmake", "--build", "--preset", preset, "-j", str(setup.jobs),
                                                    "--target", "povray", "parse_blocks", "compare"]):
        subprocess.run(command, cwd=common.ROOT, check=True)
    return common.ROOT / "build" / preset


def watched(what, tool, commands, folder, work):
    """Runs commands with the logs in a folder; a row."""
    codes = [subprocess.run(command, cwd=work, env=environment(folder / "log"), stdin=subprocess.DEVNULL,
                            capture_output=True, check=False).returncode for command in commands]
    ours, others = findings(folder)
    return {"what": what, "tool": tool, "runs": len(commands), "failed": sum(code != 0 for code in codes),
            "ours": len(ours), "suppressed": 0, "others": len(others), "first": (ours + others)[:3]}


def tutorial(povray, threads):
    """Each tutorial scene, small."""
    return [[str(povray), f"+I{scene}", "+Op.png", "+W48", "+H36", "-D", "-P", "-A", f"+WT{threads}", "+BS8",
             f"+L{common.ROOT / 'scenes' / 'include'}"] for scene in TUTORIAL]


def battery(tree, module):
    """A module of the render tests."""
    return [["python3", "-B", str(common.ROOT / "tests" / "render" / f"{module}.py"), "--povray",
             str(tree / "bin" / "povray"), "--compare", str(tree / "tests" / "tools" / "compare")]]


def parser(tree):
    """The parser battery: every file of cases."""
    cases = sorted((common.ROOT / "tests" / "parse" / "cases").glob("*.txt"))
    return [["python3", "-B", str(common.ROOT / "tests" / "parse" / "check_messages.py"), "--povray",
             str(tree / "bin" / "povray"), str(path)] for path in cases]


def valgrind(setup, folder, work):
    """memcheck on one tutorial scene, in the release build."""
    log = folder / "log.valgrind"
    command = ["valgrind", f"--log-file={log}", f"--suppressions={SUPPRESSIONS}/valgrind.supp", "--error-exitcode=0",
               *tutorial(setup.povray, 1)[0]]
    return watched(TUTORIAL[0].name, "valgrind", [command], folder, work)


def measure(setup):
    """A row for each group of runs."""
    rows = []
    with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
        work = pathlib.Path(name)

        def row(what, tool, commands):
            folder = work / f"logs{len(rows)}"
            folder.mkdir()
            rows.append(watched(what, tool, commands, folder, work))

        for preset, tool, threads in (("asan", "ASan, UBSan", 2), ("tsan", "TSan", 4)):
            tree = build(setup, preset)
            row("tutorial scenes", tool, tutorial(tree / "bin" / "povray", threads))
            row("parser battery", tool, parser(tree))
            for module in MODULES:
                row(f"tests/render/{module}.py", tool, battery(tree, module))
        folder = work / "valgrind"
        folder.mkdir()
        rows.append(valgrind(setup, folder, work))
    return {"rows": rows}


def faults(result):
    """Findings that nothing suppresses, and runs that failed."""
    return [f"{row['what']}, {row['tool']}: {row}" for row in result["rows"] if row["ours"] or row["others"] or row["failed"]]

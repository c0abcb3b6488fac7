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


def environment(tool_suppressions=True):
    """Each sanitizer goes on after a finding and knows upstream's, or is to tell of those as well."""
    def named(tool):
        return f":suppressions={SUPPRESSIONS}/{tool}.txt" if tool_suppressions else ""

    return {**os.environ,
            # what upstream has parsed stays until the end: tests/stress/soak.py looks at what stays behind
            "ASAN_OPTIONS": "detect_leaks=0:halt_on_error=0",
            "UBSAN_OPTIONS": f"print_stacktrace=1{named('ubsan')}",
            "TSAN_OPTIONS": f"halt_on_error=0:second_deadlock_stack=1:exitcode=0{named('tsan')}"}


def listener(program, folder):
    """A command in place of the program, which keeps what it writes to standard error: not every sanitizer of gcc heeds
    log_path, and the render tests take standard error for themselves."""
    script = folder / "povray"
    script.write_text(f'#!/bin/bash\nexec "{program}" "$@" 2> >(tee "{folder}/log.$$" >&2)\n')
    script.chmod(0o755)
    return script


def findings(folder):
    """Blocks of all logs: (ours, others)."""
    ours, others = [], []
    for path in folder.glob("log.*"):
        for block in BLOCKS.findall(path.read_text(errors="replace")):
            (ours if OURS.search(block) else others).append(block[:1500])
    return ours, others


def suppressed(tool):
    """The names in a tool's file, each with the reason that stands above it."""
    pairs, reason = [], []
    lines = (SUPPRESSIONS / f"{tool}.txt").read_text().splitlines()[2:]
    for number, line in enumerate(lines):
        if line.startswith("#"):
            reason.append(line[1:].strip())
        elif not line.strip():
            reason = []
        elif tool != "valgrind":
            pairs.append((line, " ".join(reason)))
        elif line == "{":
            pairs.append((lines[number + 1].strip(), " ".join(reason)))
    return pairs


def build(setup, preset):
    """The program and what the tests need."""
    for command in (["cmake", "--preset", preset], ["cmake", "--build", "--preset", preset, "-j", str(setup.jobs),
                                                    "--target", "povray", "parse_blocks", "compare"]):
        subprocess.run(command, cwd=common.ROOT, check=True)
    return common.ROOT / "build" / preset


def watched(what, tool, commands, folder, work, suppressions=True):
    """Runs commands with the logs in a folder; a row."""
    codes = [subprocess.run(command, cwd=work, env=environment(suppressions), stdin=subprocess.DEVNULL, capture_output=True,
                            check=False).returncode for command in commands]
    ours, others = findings(folder)
    return {"what": what, "tool": tool, "runs": len(commands), "failed": sum(code != 0 for code in codes),
            "ours": len(ours), "others": len(others), "first": (ours + others)[:3]}


def tutorial(povray, threads):
    """Each tutorial scene, small."""
    return [[str(povray), f"+I{scene}", "+Op.png", "+W48", "+H36", "-D", "-P", "-A", f"+WT{threads}", "+BS8",
             f"+L{common.ROOT / 'scenes' / 'include'}"] for scene in TUTORIAL]


def battery(povray, tree, module):
    """A module of the render tests."""
    return [["python3", "-B", str(common.ROOT / "tests" / "render" / f"{module}.py"), "--povray", str(povray), "--compare",
             str(tree / "tests" / "tools" / "compare")]]


def parser(povray):
    """The parser battery: every file of cases."""
    cases = sorted((common.ROOT / "tests" / "parse" / "cases").glob("*.txt"))
    return [["python3", "-B", str(common.ROOT / "tests" / "parse" / "check_messages.py"), "--povray", str(povray), str(path)]
            for path in cases]


def valgrind(setup, folder, work):
    """memcheck on one tutorial scene, in the release build."""
    log = folder / "log.valgrind"
    command = ["valgrind", f"--log-file={log}", f"--suppressions={SUPPRESSIONS}/valgrind.txt", "--error-exitcode=0",
               *tutorial(setup.povray, 1)[0]]
    return watched(TUTORIAL[0].name, "valgrind", [command], folder, work)


def program_rows(tree, tool, threads, work):
    """All runs of one sanitized program. The first one without suppressions shows that findings are seen at all."""
    groups = [("a tutorial scene, nothing suppressed", lambda povray: tutorial(povray, threads)[:1]),
              ("tutorial scenes", lambda povray: tutorial(povray, threads)), ("parser battery", parser),
              *((f"tests/render/{module}.py", lambda povray, module=module: battery(povray, tree, module))
                for module in MODULES)]
    rows = []
    for number, (what, commands) in enumerate(groups):
        folder = work / f"{tree.name}{number}"
        folder.mkdir()
        povray = listener(tree / "bin" / "povray", folder)
        rows.append(watched(what, tool, commands(povray), folder, work, suppressions=number > 0))
    return rows


def measure(setup):
    """A row for each group of runs."""
    rows = []
    with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
        work = pathlib.Path(name)
        for preset, tool, threads in (("asan", "ASan, UBSan", 2), ("tsan", "TSan", 4)):
            rows += program_rows(build(setup, preset), tool, threads, work)
        folder = work / "valgrind"
        folder.mkdir()
        rows.append(valgrind(setup, folder, work))
    return {"rows": rows}


def faults(result):
    """Findings that nothing suppresses, runs that failed, and a sanitizer that nobody hears."""
    found = []
    for row in result["rows"]:
        if row["what"].endswith("nothing suppressed"):
            found += [f"{row['tool']} finds nothing where it must"] if not row["others"] else []
        elif row["ours"] or row["others"] or row["failed"]:
            found.append(f"{row['what']}, {row['tool']}: {row}")
    return found

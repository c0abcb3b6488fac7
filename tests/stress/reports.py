# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Parses sanitizers' reports.

A finding is ours if one of our files is in its stacks. It is known if both sides' innermost functions are: ThreadSanitizer's
suppressions match any frame, and could hide a whole thread."""

import collections
import pathlib
import re

from tools.repository import ROOT

SUPPRESSIONS = ROOT / "tests" / "stress" / "suppressions"
OURS = re.compile(r"povray-src/")
# first lines of findings, and lines that may belong to them
BLOCKS = re.compile(
    r"(?:^.*runtime error: .*$|^.*(?:ERROR|WARNING): (?:Address|Leak|Thread)Sanitizer.*$"
    r"|^==\d+== (?:Invalid|Conditional|Use of|Syscall).*$)"
    r"(?:\n(?:\s+#\d+|==\d+==    |\s*$|  |(?:READ|WRITE) of size|freed by|previously allocated by"
    r"|0x[0-9a-f]+(?: is located|: note:)| [0-9a-f]{2} |==\d+==(?:The signal|Hint)).*)*",
    re.MULTILINE,
)
# a report, and foreign lines within it
THREADS = re.compile(r"^WARNING: ThreadSanitizer.*?^SUMMARY: ThreadSanitizer", re.MULTILINE | re.DOTALL)
FOREIGN = re.compile(r"^(?!WARNING: ThreadSanitizer|SUMMARY|  |\n).*\n", re.MULTILINE)
# conflicting accesses; other stacks show allocations
SIDE = re.compile(r"^  (?!Location)\S.* of size \d+ at 0x.*\n((?:    [#\[].*\n?)+)", re.MULTILINE)
LOST = "failed to restore the stack"
FRAME = re.compile(r"^    #\d+ (.*?) (\S+?)(?::\d+)*(?: \([^()]*\))?$", re.MULTILINE)
LIBRARIES = ("<null>", "/usr/", "../../../../src/libsanitizer")  # their callers count instead
SMALL = re.compile(r"pov::Vector3d::|pov_base::Generic\w*Colour<|pov::pov_(?:malloc|calloc|free)\(|pov::dot\(|\S+::~?ot_\w+_struct\(")


def innermost(stack):
    for function, path in FRAME.findall(stack):
        if not path.startswith(LIBRARIES) and not SMALL.match(function):
            return function
    return ""


def known(block, names):
    sides = SIDE.findall(block) if "ThreadSanitizer" in block else []
    seen = [innermost(stack) for stack in sides if LOST not in stack]
    found = {next((name for name in names if re.match(re.escape(name) + r"(?:\(|<|$)", function)), None) for function in seen}
    return () if None in found or not found else tuple(sorted(found)) + ("a lost stack",) * (len(seen) < len(sides))


def suppressed(tool):
    pairs, reason = [], []
    lines = (SUPPRESSIONS / f"{tool}.txt").read_text().split("\n\n", 1)[1].splitlines()
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


def findings(folder, suppress=True):
    """(ours, others), and the count of known pairs."""
    names = [name.split(":", 1)[1] for name, _ in suppressed("tsan")] if suppress else []
    ours, others, met = [], [], collections.Counter()
    for path in pathlib.Path(folder).glob("log.*"):
        text = THREADS.sub(lambda report: FOREIGN.sub("", report[0]), path.read_text(errors="replace"))
        for block in BLOCKS.findall(text):
            pair = known(block, names)
            if pair:
                met[" / ".join(pair)] += 1
            else:
                (ours if OURS.search(block) else others).append(block[:3000])
    return ours, others, dict(met)

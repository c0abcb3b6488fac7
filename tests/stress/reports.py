# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Reads what sanitizers report: which findings there are, whose they are, which of them are known.

A finding is ours where a frame of its stacks lies in one of our files. ThreadSanitizer's own suppressions match any frame
of a stack, so that the name of a thread's first function would hide all that the thread does. Names are therefore held
here against the innermost function of each side of a race, and both sides must be known.
"""

import collections
import pathlib
import re

import common

SUPPRESSIONS = common.ROOT / "tests" / "stress" / "suppressions"
OURS = re.compile(r"povray-src/")
# how a finding begins, for each tool, and what lines may belong to it
BLOCKS = re.compile(r"(?:^.*runtime error: .*$|^.*(?:ERROR|WARNING): (?:Address|Leak|Thread)Sanitizer.*$"
                    r"|^==\d+== (?:Invalid|Conditional|Use of|Syscall).*$)"
                    r"(?:\n(?:\s+#\d+|==\d+==    |\s*$|  |(?:READ|WRITE) of size|freed by|previously allocated by"
                    r"|0x[0-9a-f]+ is located|==\d+==(?:The signal|Hint)).*)*", re.MULTILINE)
# the stacks of a report of ThreadSanitizer that say what happened; others say where things were made
SIDE = re.compile(r"^  (?!Location|Mutex|Thread|As if|Hint)\S.*\n((?:    #.*\n?)+)", re.MULTILINE)
FRAME = re.compile(r"^    #\d+ (.*?) (\S+?)(?::\d+)*(?: \([^()]*\))?$", re.MULTILINE)
LIBRARIES = ("<null>", "/usr/", "../")  # of the system: what they were called for counts


def innermost(stack):
    """Name of the first function of a stack that is the program's own."""
    for function, path in FRAME.findall(stack):
        if not path.startswith(LIBRARIES):
            return function
    return ""


def known(block, names):
    """The names that explain a race, or none where a side of it has none."""
    if "ThreadSanitizer" not in block:
        return ()
    found = []
    for stack in SIDE.findall(block):
        function = innermost(stack)
        found.append(next((name for name in names if re.match(re.escape(name) + r"(?:\(|<|$)", function)), None))
    return () if None in found else tuple(sorted(set(found)))


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


def findings(folder, suppress=True):
    """Blocks of all logs, (ours, others), and how often each pair of known names was met."""
    names = [name.split(":", 1)[1] for name, _ in suppressed("tsan")] if suppress else []
    ours, others, met = [], [], collections.Counter()
    for path in pathlib.Path(folder).glob("log.*"):
        for block in BLOCKS.findall(path.read_text(errors="replace")):
            pair = known(block, names)
            if pair:
                met[" / ".join(pair)] += 1
            else:
                (ours if OURS.search(block) else others).append(block[:3000])
    return ours, others, dict(met)

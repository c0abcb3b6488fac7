# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Checks a folder of patches against the rules of docs/patching.md.

usage: check_patches.py list|headers|size|style FOLDER
   check_patches.py tests FOLDER BUILD

Prints each fault on a line; the exit code is not 0 if there is a fault.
"""

import datetime
import fnmatch
import pathlib
import re
import subprocess
import sys

# Folders in the order of the series; -DSPEEDUPS=OFF leaves out the last.
FOLDERS = ("fixes", "camera", "output", "speedups")
# fixes of the same names for POV-Ray's GitHub master; not in the series
MASTER = "master"

REQUIRED_FIELDS = ("Description", "Author", "Origin", "Forwarded", "Last-Update", "Hooks", "Tests")

# "Size-Reason" permits a larger patch, up to a second limit.
LINE_BUDGET = 40
LINE_BUDGET_WITH_REASON = 80
# A fix must be complete, so a file that it adds may be longer.
NEW_FILE_BUDGET = 250

# words of a description's first sentence
SENTENCE_BUDGET = 32


def series(folder):
    lines = (folder / "series").read_text(encoding="utf-8").splitlines()
    names = (line.split("#", 1)[0].strip() for line in lines)
    return [name for name in names if name]


def master_patches(folder):
    return sorted(path.relative_to(folder).as_posix() for path in (folder / MASTER).glob("*"))


def all_patches(folder):
    for name in [*series(folder), *master_patches(folder)]:
        path = folder / name
        if path.is_file():
            yield name, path.read_text(encoding="utf-8", errors="surrogateescape")


def header_fields(text):
    """DEP-3 fields before the first file."""
    fields = {}
    current = None
    for line in text.splitlines():
        if line.startswith(("--- ", "diff ", "Index: ", "---\n")) or line == "---":
            break
        match = re.match(r"([A-Za-z][A-Za-z-]*):\s*(.*)$", line)
        if match:
            current = match.group(1)
            fields[current] = match.group(2).strip()
        elif current and line.startswith((" ", "\t")):
            fields[current] = (fields[current] + " " + line.strip()).strip()
    return fields


def new_files(text):
    return [(name, int(lines)) for name, lines in re.findall(r"^\+\+\+ b/(\S+)\n@@ -0,0 \+1,(\d+) @@$", text, re.MULTILINE)]


def changed_lines(text, sign):
    in_hunk = False
    for line in text.splitlines():
        if line.startswith("@@"):
            in_hunk = True
        elif line.startswith(("diff ", "Index: ")) or (line.startswith("--- ") and not in_hunk):
            in_hunk = False
        elif in_hunk and re.match(r"--- \S+/\S", line):
            in_hunk = False
        elif in_hunk and line.startswith(sign):
            yield line[1:]


def check_list(folder):
    names = series(folder)
    for name in sorted(set(names)):
        if names.count(name) > 1:
            yield f"{name}: listed {names.count(name)} times"
        if not (folder / name).is_file():
            yield f"{name}: listed in series, but there is no such file"
        if not re.fullmatch(rf"({'|'.join(FOLDERS)})/[a-z]+(-[a-z0-9]+)+\.patch", name):
            yield (
                f"{name}: a patch is named like camera/add-camera-item.patch (words, no number in front, in one of "
                f"the folders {', '.join(FOLDERS)})"
            )
    places = [FOLDERS.index(part) for part in (name.split("/")[0] for name in names) if part in FOLDERS]
    if places != sorted(places):
        yield f"series: the folders are not in the order {', '.join(FOLDERS)}"
    for path in sorted(folder.rglob("*")):
        name = path.relative_to(folder).as_posix()
        if path.is_file() and name != "series" and not name.startswith(f"{MASTER}/") and name not in names:
            yield f"{name}: not listed in series"
    in_master = {name: header_fields(text).get("Upstream-Master", "") for name, text in all_patches(folder) if name.startswith("fixes/")}
    with_defect = {f"{MASTER}/{name[6:]}" for name, said in in_master.items() if said.startswith("has the defect")}
    for name in sorted(with_defect ^ set(master_patches(folder))):
        yield f"{name}: there is such a patch if, and only if, Upstream-Master of the fix of this name says 'has the defect'"


def check_headers(folder):
    for name, text in all_patches(folder):
        fields = header_fields(text)
        for field in REQUIRED_FIELDS:
            if not fields.get(field) and not (field == "Tests" and name.startswith(f"{MASTER}/")):
                yield f"{name}: header field {field} is missing or empty"
        date = fields.get("Last-Update", "")
        try:
            datetime.date.fromisoformat(date)
        except ValueError:
            yield f"{name}: Last-Update is {date!r}, expected a date such as 2025-01-31"
        if name.startswith("fixes/") and fields.get("Forwarded") == "not-needed":
            yield f"{name}: Forwarded is not-needed, but a defect of upstream's is to be reported: no, or where it was"
        if name.startswith("fixes/") and not re.match(r"has (the defect|it no more)\b.*\(\S+ of ", fields.get("Upstream-Master", "")):
            yield f"{name}: Upstream-Master says 'has the defect' or 'has it no more', and in brackets which commit of which date was read"
        sentence = re.match(r".*?[.](?=\s|$)", fields.get("Description", ""))
        if not sentence or len(sentence.group().split()) > SENTENCE_BUDGET:
            yield f"{name}: Description does not begin with its reason in one sentence of at most {SENTENCE_BUDGET} words"


def check_size(folder):
    for name, text in all_patches(folder):
        created = new_files(text)
        added = sum(1 for _ in changed_lines(text, "+")) - sum(lines for _, lines in created)
        reason = header_fields(text).get("Size-Reason", "")
        budget = LINE_BUDGET_WITH_REASON if reason else LINE_BUDGET
        if added == 0:
            yield f"{name}: adds no line"
        for path, lines in created:
            if not name.startswith(("fixes/", f"{MASTER}/")):
                yield f"{name}: creates {path}, which belongs into povray-src/; only a fix brings its own files"
            if lines > NEW_FILE_BUDGET:
                yield f"{name}: {path} has {lines} lines, allowed are {NEW_FILE_BUDGET}"
        if added > budget:
            yield (
                f"{name}: adds {added} lines, allowed are {budget}; move the logic into povray-src/, or "
                f"say in the field Size-Reason why it cannot be (then up to {LINE_BUDGET_WITH_REASON})"
            )


def check_style(folder):
    for name, text in all_patches(folder):
        if "GIT binary patch" in text:
            yield f"{name}: holds a binary file"
        for line in changed_lines(text, "+"):
            if line.rstrip("\r") != line.rstrip():
                yield f"{name}: white space at the end of an added line: {line!r}"
        for hunk in re.split(r"^(?=@@)", text, flags=re.MULTILINE)[1:]:
            added = list(changed_lines(hunk, "+"))
            for line in changed_lines(hunk, "-"):
                if re.search(r"\w", line) and any(line.split() == other.split() for other in added):
                    yield f"{name}: changes white space alone: {line!r}"


def check_tests(folder, build):
    """A star stands for any letters."""
    listed = subprocess.run(["ctest", "-N"], cwd=build, stdout=subprocess.PIPE, text=True, check=True).stdout
    known = re.findall(r"^ *Test +#\d+: (\S+)", listed, re.MULTILINE)
    for name, text in all_patches(folder):
        for test in re.findall(r"[\w.*/]+\.[\w.*/]+", header_fields(text).get("Tests", "")):
            if not fnmatch.filter(known, test):
                yield f"{name}: there is no test {test}, which the header field Tests names"


CHECKS = {"list": check_list, "headers": check_headers, "size": check_size, "style": check_style, "tests": check_tests}


def main(arguments):
    if len(arguments) < 3 or arguments[1] not in CHECKS or len(arguments) != (4 if arguments[1] == "tests" else 3):
        sys.exit(__doc__)
    faults = list(CHECKS[arguments[1]](pathlib.Path(arguments[2]), *arguments[3:]))
    for fault in faults:
        print(fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv))

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Files of cases: small scenes with the expected messages.

    === name of the case
    camera { @view tilt_lens { tilt 90 } }      // <<
    --- error: part of the message | another part

"<<" in a comment marks the message's line. Below the scene stand, in this order:

    --- file NAME           further lines, up to the next "---", are a file that the scene includes
    --- options +A +K0.5    further options of POV-Ray
    --- error: PARTS        one error with these parts (separated by " | ") in this order, at the mark
    --- warning: PARTS      a warning at the mark; may stand several times
    --- says: PARTS         the message stream has these parts in this order
    --- ok                  no error, and no warning

At least one of the last four must stand; other messages are faults.

HEAD begins each scene without a #version; "@view" stands for VIEW.
"""

import dataclasses
import re

HEAD = "#version 3.7; global_settings { assumed_gamma 1 } sphere { <0, 0, 99>, 1 }\n"
VIEW = "location <0, 1, -5> look_at <0, 1, 0>"
SCENE = "scene.pov"
MARK = "<<"


class BadCase(Exception):
    """An error in the file of cases."""


@dataclasses.dataclass
class Expected:
    kind: str  # "error", "warning" or "says"
    parts: list


@dataclasses.dataclass
class Case:
    name: str
    files: dict  # name -> text; the scene is SCENE
    options: list
    expected: list
    place: tuple  # file and line that the messages name, or None

    def parts(self, kind):
        return [e.parts for e in self.expected if e.kind == kind]


def place_of_mark(name, files):
    places = [(file, number) for file, text in files.items() for number, line in enumerate(text.split("\n"), 1) if MARK in line]
    if len(places) > 1:
        raise BadCase(f"{name}: more than one mark {MARK}")
    return places[0] if places else None


def parse_case(name, lines):
    files, options, expected, ok = {SCENE: []}, [], [], False
    target = SCENE
    for line in lines:
        if not line.startswith("---"):
            if target is None:
                if line.strip():
                    raise BadCase(f"{name}: text after the expectations: {line}")
                continue
            files[target].append(line)
            continue
        words = line[3:].split()
        verb = words[0].rstrip(":") if words else ""
        target = None
        if verb == "file" and len(words) == 2:
            target = words[1]
            files[target] = []
        elif verb == "options":
            options += words[1:]
        elif verb in ("error", "warning", "says"):
            parts = [part.strip() for part in line.split(":", 1)[1].split(" | ")]
            expected.append(Expected(verb, parts))
        elif verb == "ok":
            ok = True
        else:
            raise BadCase(f"{name}: cannot read '{line}'")
    texts = {file: "\n".join(text).replace("@view", VIEW) + "\n" for file, text in files.items()}
    if not re.search(r"^\s*#version", texts[SCENE], re.MULTILINE):
        texts[SCENE] = HEAD + texts[SCENE]
    case = Case(name, texts, options, expected, place_of_mark(name, texts))
    if not expected and not ok:
        raise BadCase(f"{name}: has neither an expected message nor ok")
    has_place = any(e.kind != "says" for e in expected)
    if len(case.parts("error")) > 1 or has_place != (case.place is not None):
        raise BadCase(f"{name}: needs at most one error, and a mark where an error or warning is expected")
    return case


def read_cases(path):
    blocks = []
    for line in path.read_text().split("\n"):
        if line.startswith("==="):
            blocks.append((line[3:].strip(), []))
        elif blocks:
            blocks[-1][1].append(line)
        elif line.strip() and not line.startswith("#"):
            raise BadCase(f"{path}: text before the first case: {line}")
    names = [name for name, _ in blocks]
    twice = {name for name in names if names.count(name) > 1}
    if twice or not blocks:
        raise BadCase(f"{path}: " + (f"cases of one name: {sorted(twice)}" if twice else "no case"))
    return [parse_case(name, lines) for name, lines in blocks]

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Reads code, commands, links and headings of a Markdown page.

Every example, which is code in a fence ```povray, is rendered by a test:

- A whole scene has #version, and its name in the first line: // tilt.pov: a board and cones
- Other code has a comment right above its fence:
    <!-- example: camera items -->        is put into a camera that has a view
    <!-- example: tilt_lens items -->     is put into a tilt_lens block of such a camera
    <!-- example: scene -->               has a camera statement; gets #version and objects
    <!-- example: not rendered, REASON -->
- Further parts of the comment, each behind a semicolon: the texts of "says: TEXT" and "warns: TEXT" must appear in the
  messages; "fails: TEXT" makes the code an example of an error. Without "warns" there must be no warning.

A fence ```text is compared with the messages of an example of the page named in a comment above it:
<!-- output of tilt.pov +W640 +H360 -->. A line "..." stands for any lines.

Commands are in a fence ```sh, ```bash or ```console, or indented by four blanks.
"""

import dataclasses
import re

KINDS = ("camera items", "tilt_lens items", "scene", "not rendered")
SHELL = ("sh", "bash", "console")
FENCE = re.compile(r"^( *)(```+)\s*([\w+-]*)\s*$")
MARKER = re.compile(r"^\s*<!--\s*(example|output of)\b:?\s*(.*?)\s*-->\s*$")


class BadPage(Exception):
    pass


@dataclasses.dataclass
class Block:
    page: str
    line: int
    language: str
    text: str
    marker: tuple  # (word, rest) of the comment above, or None

    def place(self):
        return f"{self.page}:{self.line}"


@dataclasses.dataclass
class Example:
    block: Block
    kind: str  # "whole" or one of KINDS
    name: str  # "" if the page gives none
    expected: dict  # "says", "warns", "fails" -> list of texts


def blocks_of(page, text):
    blocks, lines, number = [], text.split("\n"), 0
    while number < len(lines):
        fence = FENCE.match(lines[number])
        if not fence:
            number += 1
            continue
        start = number
        number += 1
        while number < len(lines) and lines[number].strip() != fence[2]:
            number += 1
        if number == len(lines):
            raise BadPage(f"{page}:{start + 1}: the fence is not closed")
        body = "\n".join(line[len(fence[1]) :] for line in lines[start + 1 : number]) + "\n"
        above = MARKER.match(lines[start - 1]) if start > 0 else None
        blocks.append(Block(page, start + 1, fence[3], body, above.groups() if above else None))
        number += 1
    return blocks


def example_of(block):
    whole = re.search(r"^\s*#version", block.text, re.MULTILINE)
    if whole:
        named = re.match(r"//\s*(\w[\w.-]*\.pov)\b", block.text)
        kind, rest = "whole", block.marker[1] if block.marker else ""
        parts = [part for part in rest.split(";") if part.strip()]
        return Example(block, kind, named[1] if named else "", expectations(block, parts))
    if block.marker is None or block.marker[0] != "example":
        raise BadPage(
            f"{block.place()}: code without #version and without a comment <!-- example: ... --> right above "
            f"its fence. One of {', '.join(KINDS)} is allowed; see tools/docs/pages.py."
        )
    kind, *parts = block.marker[1].split(";")
    kind = kind.strip()
    reason = ""
    if kind.startswith("not rendered"):
        kind, _, reason = kind.partition(",")
        if not reason.strip():
            raise BadPage(f"{block.place()}: 'not rendered' gives no reason: <!-- example: not rendered, REASON -->")
    if kind not in KINDS:
        raise BadPage(f"{block.place()}: '{kind}' in the comment above the code. One of {', '.join(KINDS)} is allowed.")
    return Example(block, kind, "", expectations(block, parts))


def expectations(block, parts):
    expected = {"says": [], "warns": [], "fails": []}
    for part in parts:
        verb, colon, text = part.strip().partition(":")
        if verb not in expected or not colon or not text.strip():
            raise BadPage(
                f"{block.place()}: '{part.strip()}' in the comment above the code. 'says: TEXT', 'warns: TEXT' and "
                "'fails: TEXT' are allowed."
            )
        expected[verb].append(text.strip())
    return expected


def examples_of(blocks):
    examples = [example_of(block) for block in blocks if block.language == "povray"]
    names = [example.name for example in examples if example.name]
    for name in names:
        if names.count(name) > 1:
            raise BadPage(f"{blocks[0].page}: two scenes are named {name}")
    return examples


def commands_of(page, text):
    found, inside, fenced = [], False, ""
    lines = text.split("\n")
    for number, line in enumerate(lines, 1):
        fence = FENCE.match(line)
        if fence or (inside and line.strip() == "```"):
            inside = not inside
            fenced = fence[3] if fence else ""
            continue
        indented = re.match(r" {4}(?=\S)", line) and not inside
        if indented or (inside and fenced in SHELL):
            command = re.sub(r"^\$ ", "", line.strip())
            if found and found[-1][1].endswith("\\"):
                found[-1] = (found[-1][0], found[-1][1][:-1].rstrip() + " " + command)
            elif command and not command.startswith("#"):
                found.append((number, command))
    return [(number, re.sub(r"\s+#\s.*$", "", command)) for number, command in found]


def without_code(text):
    """Without fences, inline code and comments; lines kept."""
    lines, inside = [], False
    for line in text.split("\n"):
        if FENCE.match(line) or (inside and line.strip().startswith("```")):
            inside = not inside
            lines.append("")
        else:
            lines.append("" if inside else re.sub(r"`[^`]*`", "", line))
    return re.sub(r"<!--.*?-->", lambda m: "\n" * m[0].count("\n"), "\n".join(lines), flags=re.DOTALL)


def links_of(text):
    return re.findall(r"\]\(\s*([^()\s]+)\s*\)", re.sub(r"\n\s*", " ", without_code(text)))


def anchors_of(text):
    """Names that a link to a heading may have on GitHub."""
    anchors = []
    in_fence = False
    for line in text.split("\n"):
        if FENCE.match(line) or (in_fence and line.strip().startswith("```")):
            in_fence = not in_fence
        heading = re.match(r"#+\s+(.*?)\s*#*$", line)
        if heading and not in_fence:
            words = re.sub(r"[^\w\s-]", "", heading[1].replace("`", "").lower())
            anchor = re.sub(r"\s", "-", words)
            count = anchors.count(anchor)
            anchors.append(anchor if count == 0 else f"{anchor}-{count}")
    return anchors

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Where a scene's text has its camera and its `tilt_lens` block, and the text with another block."""

import re

# Items of a block that the page writes, and those that it knows nothing of.
WRITTEN = ("film_width", "focal_length", "scene_unit", "shift", "f_stop", "blades", "tilt", "swing", "focus_tilt",
           "focus_swing", "focal_plane", "focal_points")
NOT_WRITTEN = ("denoise", "focus_peaking", "focus_map", "show_planes")


class Doubt(Exception):
    """The block cannot be put into the text without a guess; says why."""


def blanked(text):
    """The text with comments and the insides of strings turned to blanks, so that places stay and only code is left."""
    pattern = re.compile(r'"(?:\\.|[^"\\])*"|//[^\n]*|/\*', re.DOTALL)
    out, at = [], 0
    while True:
        found = pattern.search(text, at)
        if not found:
            return "".join(out) + text[at:]
        end = found.end() if found.group() != "/*" else comment_end(text, found.end())
        out += [text[at : found.start()], re.sub(r"[^\n]", " ", text[found.start() : end])]
        at = end


def comment_end(text, at):
    """Behind the comment that is open at a place; comments nest."""
    depth = 1
    while depth > 0:
        found = re.compile(r"/\*|\*/").search(text, at)
        if not found:
            return len(text)
        depth += 1 if found.group() == "/*" else -1
        at = found.end()
    return at


def version_of(text):
    """The number behind the first #version, as it is written, or None."""
    found = re.search(r"#\s*version\s+([0-9.]+)\s*;", blanked(text))
    return found.group(1) if found else None


def closing(code, opening):
    """Place of the brace that closes the one at `opening`."""
    depth = 0
    for found in re.compile(r"[{}]").finditer(code, opening):
        depth += 1 if found.group() == "{" else -1
        if depth == 0:
            return found.start()
    raise Doubt("the braces of the scene do not match")


def statements(code, word, start=0, end=None):
    """(word's place, opening, closing) of each `word { ... }` in the code."""
    found = []
    for match in re.compile(rf"(?<![\w#])\b{word}\s*\{{").finditer(code, start, len(code) if end is None else end):
        found.append((match.start(), match.end() - 1, closing(code, match.end() - 1)))
    return found


def camera_at(text, line):
    """The camera statement whose closing brace stands in a line (from 1): (word's place, opening, closing)."""
    code = blanked(text)
    ends = [s for s in statements(code, "camera") if code.count("\n", 0, s[2]) + 1 == line]
    if len(ends) != 1:
        raise Doubt("the camera comes from a macro, an identifier or another file")
    return ends[0]


def indented(block, indent):
    """The lines of a block, moved to the right."""
    return "\n".join((indent if line else "") + line for line in block.splitlines())


def line_indent(text, at):
    """The blanks that begin the line of a place."""
    start = text.rfind("\n", 0, at) + 1
    return re.match(r"[ \t]*", text[start:]).group()


def with_item(body, item, value):
    """A camera's text with another value of an item, which is a number or a vector of numbers; None where the item is
    not there in this simple form."""
    number = r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?"
    pattern = re.compile(rf"\b{item}\s*(?:<[^<>{{}}#]*>|{number})(?=[\s}}])")
    found = pattern.search(blanked(body))
    if not found:
        return None
    if value is None:
        before, behind = body[: found.start()].rstrip(" \t"), body[found.end() :].lstrip(" \t")
        return before + ("" if before.endswith("\n") or behind.startswith("\n") else " ") + behind
    return body[: found.start()] + f"{item} {value}" + body[found.end() :]


def with_block(text, line, block, items):
    """The scene's text with this block in the camera whose closing brace stands in a line.

    `items` are items of the camera itself that go with the block: name -> value, or None for one that must go.
    @throws Doubt"""
    word, opening, end = camera_at(text, line)
    body = text[opening + 1 : end]
    for item, value in items.items():
        if not re.search(rf"\b{item}\b", blanked(body)):
            if value is not None:
                block = f"{item} {value}\n{block}"
            continue
        changed = with_item(body, item, value)
        if changed is None:
            raise Doubt(f"the camera's {item} is an expression")
        body = changed
    code = blanked(body)
    blocks = statements(code, "tilt_lens")
    if len(blocks) > 1:
        raise Doubt("the camera has more than one tilt_lens block in its text")
    if blocks:
        start, inner, stop = blocks[0]
        if "#" in code[inner:stop]:
            raise Doubt("the block has directives such as #if, which would be lost")
        lost = [item for item in NOT_WRITTEN if re.search(rf"\b{item}\b", code[inner:stop])]
        if lost:
            raise Doubt(f"the block has {' and '.join(lost)}, which would be lost")
        indent = line_indent(body, start) if body[:start].strip() else "  "
        before = body[:start]
        lead = re.search(r"[ \t]*$", before).group()
        replacement = indented(block, indent)
        if before.endswith("\n" + lead) or not before:
            before = before[: len(before) - len(lead)]
        else:
            replacement = replacement.lstrip()
        body = before + replacement + body[stop + 1 :]
    else:
        indent = line_indent(text, word)
        body = body.rstrip() + "\n" + indented(block, indent + "  ") + "\n" + indent
    return text[: opening + 1] + body + text[end:]

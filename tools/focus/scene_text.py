# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Finds the camera and its `tilt_lens` block in a scene's text, and replaces the block."""

import re

# written by the page; kept; omitted by the true picture, which has a quality of its own
WRITTEN = (
    "film_width",
    "focal_length",
    "scene_unit",
    "shift",
    "f_stop",
    "blades",
    "tilt",
    "swing",
    "focus_tilt",
    "focus_swing",
    "focal_plane",
    "focal_points",
    "sharp_points",
    "sharp_within",
    "circle_of_confusion",
    "focus_on",
    "focus_at",
    "film_distance",
    "focus_scale",
)
NOT_IN_PICTURE = ("budget", "focus_peaking", "focus_map", "show_planes")
KEPT = (
    "blade_curvature",
    "squeeze",
    "edge_light",
    "natural_vignetting",
    "optical_vignetting",
    "distortion",
    "field_curvature",
    "lateral_colour",
    "axial_colour",
    "denoise",
    "sample_seed",
    *NOT_IN_PICTURE,
)
# the page models the ideal lens, and its focal length would conflict
REFUSED = ("prescription", "dispersion")


class EditError(Exception):
    """It would need a guess; the message says why."""


def blanked(text):
    """Without comments and string contents; positions stay."""
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
    """Comments nest."""
    depth = 1
    while depth > 0:
        found = re.compile(r"/\*|\*/").search(text, at)
        if not found:
            return len(text)
        depth += 1 if found.group() == "/*" else -1
        at = found.end()
    return at


def version_of(text):
    found = re.search(r"#\s*version\s+([0-9.]+)\s*;", blanked(text))
    return found.group(1) if found else None


def closing(code, opening):
    depth = 0
    for found in re.compile(r"[{}]").finditer(code, opening):
        depth += 1 if found.group() == "{" else -1
        if depth == 0:
            return found.start()
    raise EditError("the braces of the scene do not match")


def statements(code, word, start=0, end=None):
    """(position of the word, opening, closing) of each `word { ... }`."""
    found = []
    for match in re.compile(rf"(?<![\w#])\b{word}\s*\{{").finditer(code, start, len(code) if end is None else end):
        found.append((match.start(), match.end() - 1, closing(code, match.end() - 1)))
    return found


def camera_at(text, line):
    """By the line (from 1) of its closing brace: (position of the word, opening, closing)."""
    code = blanked(text)
    ends = [s for s in statements(code, "camera") if code.count("\n", 0, s[2]) + 1 == line]
    if len(ends) != 1:
        raise EditError("the camera comes from a macro, an identifier or another file")
    return ends[0]


def newline_of(text):
    return "\r\n" if re.match(r"[^\n]*\r\n", text) else "\n"


def indented(block, indent, newline):
    return newline.join((indent if line else "") + line for line in block.splitlines())


def line_indent(text, at):
    start = text.rfind("\n", 0, at) + 1
    return re.match(r"[ \t]*", text[start:]).group()


def with_item(body, item, value):
    number = r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?"
    pattern = re.compile(rf"\b{item}\s*(?:<[^<>{{}}#]*>|{number})(?=[\s}}])")
    found = pattern.search(blanked(body))
    if not found:
        return None
    if value is None:
        before, behind = body[: found.start()].rstrip(" \t"), body[found.end() :].lstrip(" \t")
        return before + ("" if before.endswith("\n") or behind.startswith(("\r", "\n")) else " ") + behind
    return body[: found.start()] + f"{item} {value}" + body[found.end() :]


def kept_items(inside):
    """@throws EditError the text holds more than items"""
    code = blanked(inside)
    if "#" in code:
        raise EditError("the block has directives such as #if, which would be lost")
    for word in REFUSED:
        if re.search(rf"\b{word}\b", code):
            raise EditError(
                f"the block has the item {word}, beside which the page's focal_length cannot stand: copy the page's block, and put "
                "its other items into the scene by hand"
            )
    words = list(re.finditer(rf"\b(?:{'|'.join(WRITTEN + KEPT)})\b", code))
    ends = [word.start() for word in words[1:]] + [len(code)]
    items = [(word.group(), " ".join(code[word.start() : end].split())) for word, end in zip(words, ends)]
    return [text for word, text in items if word in KEPT]


def block_in(body):
    """(word, opening, closing), or None. @throws EditError"""
    blocks = statements(blanked(body), "tilt_lens")
    if len(blocks) > 1:
        raise EditError("the camera has more than one tilt_lens block in its text")
    return blocks[0] if blocks else None


def kept_at(text, line):
    """None without a block."""
    _, opening, end = camera_at(text, line)
    body = text[opening + 1 : end]
    block = block_in(body)
    return kept_items(body[block[1] + 1 : block[2]]) if block else None


def with_items(block, items):
    return block.removesuffix("}") + "".join(f"  {item}\n" for item in items) + "}"


def with_block(text, line, block, items):
    """`items`: {name: value, or None to remove}; others of the block stay. @throws EditError"""
    word, opening, end = camera_at(text, line)
    body = text[opening + 1 : end]
    block = with_items(block, kept_at(text, line) or [])
    for item, value in items.items():
        if not re.search(rf"\b{item}\b", blanked(body)):
            if value is not None:
                block = f"{item} {value}\n{block}"
            continue
        changed = with_item(body, item, value)
        if changed is None:
            raise EditError(f"the camera's {item} is an expression")
        body = changed
    return text[: opening + 1] + with_block_in(body, block, line_indent(text, word), newline_of(text)) + text[end:]


def behind_camera(text, line, block):
    """Repeats the camera, whose own block may come from a macro or have directives. @throws EditError"""
    word, _, end = camera_at(text, line)
    if re.search(r"[=(,]\s*$", blanked(text)[:word]):
        raise EditError("the camera is part of a declaration")
    number = 1
    while re.search(rf"\b{(name := f'Focus_Camera_{number}')}\b", text):
        number += 1
    indent, newline = line_indent(text, word), newline_of(text)
    lines = [f"{indent}camera {{", f"{indent}  {name}", indented(block, indent + "  ", newline), indent + "}"]
    return f"{text[:word]}#declare {name} = {text[word : end + 1]}{newline}{newline.join(lines)}{text[end + 1 :]}"


PULL_HEAD = re.compile(r'#include "tilt_lens\.inc"\s+#declare Tilt_Lens_Keys = 0;\s+(?:Tilt_Lens_Key_Points\([^()]*\)\s+)+\Z')


def with_head(changed, text, line, head):
    """Replaces the lines of an earlier focus pull. The line is of the text before the change. @throws EditError"""
    word = camera_at(text, line)[0]
    start = text.rfind("\n", 0, word) + 1
    if text[start:word].strip():
        raise EditError("the camera does not begin its line")
    before, newline = changed[:start], newline_of(text)
    old = PULL_HEAD.search(before)
    if old:
        before = before[: old.start()]
    return before + indented(head, text[start:word], newline) + newline + changed[start:]


def with_block_in(body, block, indent, newline):
    old = block_in(body)
    if old is None:
        return body.rstrip() + newline + indented(block, indent + "  ", newline) + newline + indent
    start, _, stop = old
    before = body[:start]
    replacement = indented(block, line_indent(body, start) if before.strip() else "  ", newline)
    lead = re.search(r"[ \t]*$", before).group()
    if before.endswith("\n" + lead) or not before:
        before = before[: len(before) - len(lead)]
    else:
        replacement = replacement.lstrip()
    return before + replacement + body[stop + 1 :]

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""A schema of the page's messages; all others are refused."""

import json

import jsonschema

from tools.focus.scene_text import with_items

LARGEST = 16384  # pixels of a side
MOST_POINTS = MOST_KEYS = 100  # the program's own limits
MOST_CHECKS = 5  # of a focus pull
LONGEST_BLOCK = 1000 + 80 * MOST_POINTS  # characters
QUALITIES = ("blur_samples 32", "blur_samples 256 variance 1/8000", "blur_samples 1024 variance 1/20000")
WORDS = (
    "film_width", "focal_length", "scene_unit", "tilt", "swing", "focus_tilt", "focus_swing", "focal_plane", "focal_points",
    "sharp_points", "sharp_within", "circle_of_confusion", "shift", "f_stop", "blades",
)  # fmt: skip


class BadRequest(Exception):
    pass


def need(condition):
    if not condition:
        raise BadRequest


DIGITS = r"-?[0-9]{1,40}(?:\.[0-9]{1,40})?(?:e[-+]?[0-9]{1,3})?"
VECTOR_TEXT = rf"<{DIGITS}(?:, {DIGITS}){{2}}>"
BLOCK_PART = rf"(?:[ \n<>,]|(?:{'|'.join(WORDS)}|{DIGITS})(?=[ \n<>,{{}}]))*"
BLOCK_TEXT = rf"tilt_lens \{{{BLOCK_PART}(?:\{{{BLOCK_PART}\}}{BLOCK_PART})?\}}"

KEY_TEXT = rf"Tilt_Lens_Key_Points\({DIGITS}, {DIGITS}(?:, {VECTOR_TEXT}){{3}}\)\n"
HEAD_TEXT = rf'#include "tilt_lens\.inc"\n#declare Tilt_Lens_Keys = 0;\n(?:{KEY_TEXT}){{2,{MOST_KEYS}}}'
PULL_TEXT = rf"tilt_lens \{{{BLOCK_PART}Tilt_Lens_Pull\(clock, {VECTOR_TEXT}\)\n\}}"

NUMBER = {"type": "number", "minimum": -1e300, "maximum": 1e300}
NUMBER_OR_NONE = {"anyOf": [NUMBER, {"type": "null"}]}


def text(pattern, longest=2000):
    return {"type": "string", "maxLength": longest, "pattern": rf"\A(?:{pattern})\Z"}


def values(item, count, most=None):
    return {"type": "array", "items": item, "minItems": count, "maxItems": most or count}


def record(**parts):
    return {"type": "object", "properties": parts, "required": list(parts), "additionalProperties": False}


def some_of(**parts):
    return {"type": "object", "properties": parts, "additionalProperties": False}


VECTOR = values(NUMBER, 3)
CAMERA = record(location=VECTOR, direction=VECTOR, right=VECTOR, up=VECTOR)
BLOCK = text(BLOCK_TEXT, LONGEST_BLOCK)
ITEMS = some_of(focal_point=text(VECTOR_TEXT), angle={"anyOf": [text(DIGITS), {"type": "null"}]}, aperture={"type": "null"})
LENS = {
    "filmWidth": NUMBER, "focalLength": NUMBER_OR_NONE, "sceneUnit": NUMBER, "shift": values(NUMBER, 2), "fStop": NUMBER,
    "blades": NUMBER, "bladesAngle": NUMBER,
}  # fmt: skip
FOCUS = {
    "lensTurn": {"tilt": NUMBER, "swing": NUMBER, "focalPoint": VECTOR},
    "plane": {"planeNormal": VECTOR, "planeDistance": NUMBER},
    "points": {"points": values(VECTOR, 3)},
    "sharp": {"sharpPoints": values(VECTOR, 3, MOST_POINTS), "sharpWithin": NUMBER_OR_NONE},
}
EXPECTED = {"anyOf": [record(family={"const": family}, **LENS, **focus) for family, focus in FOCUS.items()]}
EXPECT = record(block=EXPECTED, camera=CAMERA)
CHANGE = {"block": BLOCK, "items": ITEMS, "expect": EXPECT, "behind": record(block=BLOCK, expect=EXPECT)}
MESSAGES = {
    "preview": {"camera": CAMERA, "clock": NUMBER, "chosen": {"anyOf": [{"type": "integer", "minimum": 0}, {"type": "null"}]}},
    "render": {
        "size": values({"type": "integer", "minimum": 2, "maximum": LARGEST}, 2),
        "quality": {"type": "integer", "minimum": 0, "maximum": len(QUALITIES) - 1},
        "camera": CAMERA,
        "block": BLOCK,
        "items": ITEMS,
    },
    "stop": {},
    "write": CHANGE,
    "try": CHANGE,
    "undo": {},
    "pull": {
        "write": {"type": "boolean"},
        "head": text(HEAD_TEXT, 1000 + 300 * MOST_KEYS),
        "block": text(PULL_TEXT),
        "items": ITEMS,
        "checks": {"type": "array", "items": record(time=NUMBER, expect=EXPECT), "minItems": 1, "maxItems": MOST_CHECKS},
    },
}
OPTIONAL = {"preview"}  # messages with optional members


def schema_of(name):
    schema = (some_of if name in OPTIONAL else record)(do={"const": name}, **MESSAGES[name])
    return {**schema, "required": schema.get("required", ["do"])}


VALIDATORS = {name: jsonschema.Draft7Validator(schema_of(name)) for name in MESSAGES}


def not_finite(word):
    """Python's JSON accepts NaN and Infinity."""
    raise BadRequest(word)


def read(sent):
    """@throws BadRequest"""
    try:
        message = json.loads(sent, parse_constant=not_finite)
    except (ValueError, RecursionError):
        raise BadRequest from None
    need(isinstance(message, dict) and isinstance(message.get("do"), str))
    need(message["do"] in VALIDATORS and VALIDATORS[message["do"]].is_valid(message))
    return message["do"], message


def picture(message, kept):
    """`kept`: further items of the block; the page recognises the picture by `lens`."""
    point = message["items"].get("focal_point")
    more = [f"focal_point {point}"] if point else []
    inside = "\n".join([QUALITIES[int(message["quality"])], *more, with_items(message["block"], kept)])
    lens = {"camera": message["camera"], "block": message["block"]}
    return {"size": [int(side) for side in message["size"]], "camera": message["camera"], "inside": inside, "lens": lens}

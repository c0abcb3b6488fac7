# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""What the page may ask for. Whatever is not exactly of these forms is refused."""

import json
import math
import re

from tools.focus.scene_text import with_items

LARGEST = 16384  # pixels of a side
QUALITIES = (
    "blur_samples 32",
    "blur_samples 256 variance 1/8000",
    "blur_samples 1024 variance 1/20000",
)
VECTORS = ("location", "direction", "right", "up")
WORDS = {
    "tilt_lens", "film_width", "focal_length", "scene_unit", "tilt", "swing", "focus_tilt", "focus_swing", "focal_plane",
    "focal_points", "shift", "f_stop", "blades",
}  # fmt: skip
ITEMS = {"focal_point", "angle", "aperture", "bokeh"}
NUMBER = r"-?\d+(?:\.\d+)?(?:e[-+]?\d+)?"


class BadRequest(Exception):
    """A message that the page does not send."""


def need(condition):
    """Refuses a message."""
    if not condition:
        raise BadRequest


def number(value):
    """A finite number."""
    need(isinstance(value, (int, float)) and not isinstance(value, bool) and math.isfinite(value))
    return float(value)


def vector(value):
    """Three finite numbers."""
    need(isinstance(value, list) and len(value) == 3)
    return [number(part) for part in value]


def camera(value):
    """Location, direction, right and up."""
    need(isinstance(value, dict) and set(value) == set(VECTORS))
    return {name: vector(value[name]) for name in VECTORS}


def block(value):
    """The text of a tilt_lens block: its words, numbers and signs, and nothing else."""
    need(isinstance(value, str) and len(value) < 2000)
    need(re.fullmatch(r"tilt_lens \{[^{}]*(?:\{[^{}]*\}[^{}]*)?\}", value))
    for part in re.findall(r"[<>{},]|[^<>{}, \n]+", value):
        need(part in "<>{}," or part in WORDS or re.fullmatch(NUMBER, part))
    return value


def items(value):
    """Items of the camera that go with the block: text of a number or a vector, or None."""
    need(isinstance(value, dict) and set(value) <= ITEMS)
    for text in value.values():
        need(text is None or re.fullmatch(rf"{NUMBER}|<{NUMBER}(?:, {NUMBER}){{2}}>", str(text)))
    return value


def picture(message, kept):
    """A request for the true picture; `kept` are further items of the block."""
    size = message.get("size")
    need(isinstance(size, list) and len(size) == 2 and all(isinstance(n, int) and 2 <= n <= LARGEST for n in size))
    quality = message.get("quality")
    need(quality in range(len(QUALITIES)))
    text = block(message.get("block"))
    more = [f"{name} {value}" for name, value in items(message.get("items")).items() if value and name == "focal_point"]
    inside = "\n".join([QUALITIES[quality], *more, with_items(text, kept)])
    return {"size": size, "camera": camera(message.get("camera")), "inside": inside}


def change(message):
    """A request to change the file."""
    expect = message.get("expect")
    need(isinstance(expect, dict) and isinstance(expect.get("block"), dict))
    need(expect["block"].get("family") in ("lensTurn", "focusTurn", "plane", "points"))
    camera(expect.get("camera"))
    return {"block": block(message.get("block")), "items": items(message.get("items")), "expect": expect}


def read(text):
    """A message of the page as (what it asks for, the rest)."""
    try:
        message = json.loads(text)
    except ValueError:
        raise BadRequest from None
    need(isinstance(message, dict) and isinstance(message.get("do"), str))
    return message["do"], message

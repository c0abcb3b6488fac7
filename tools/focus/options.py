# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Size and clock in POV-Ray's options."""

import dataclasses
import re

WIDTH, HEIGHT = 960, 540  # of the preview, if the options have none
SWITCHES = {"W": "width", "H": "height", "K": "clock", "KI": "initial_clock", "KF": "final_clock", "KFF": "final_frame"}
NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?"


def settings_in(words, depth=0):
    """In POV-Ray's order."""
    for word in words:
        switch = re.fullmatch(rf"[-+](W|H|KFF|KI|KF|K)({NUMBER})", word, re.IGNORECASE)
        named = re.fullmatch(rf"(\w+)\s*=\s*({NUMBER})", word)
        ini = re.fullmatch(r"(.+\.ini)(?:\[(.*)\])?", word, re.IGNORECASE)
        if switch:
            yield SWITCHES[switch[1].upper()], float(switch[2])
        elif named and named[1].lower() in SWITCHES.values():
            yield named[1].lower(), float(named[2])
        elif ini and depth < 8:
            yield from settings_in(lines_of(ini[1], ini[2]), depth + 1)


def lines_of(path, section):
    try:
        with open(path, encoding="utf-8", errors="replace") as stream:
            lines = stream.read().splitlines()
    except OSError:
        return  # POV-Ray reports it, or finds it in another folder
    current = None
    for line in lines:
        line = line.split(";")[0].strip()
        head = re.fullmatch(r"\[(.*)\]", line)
        if head:
            current = head[1].strip().lower()
        elif current in (None, (section or "").strip().lower()):
            yield from [line] if "=" in line else line.split()


@dataclasses.dataclass
class Options:
    """`words` go to POV-Ray; `size`: pixels; `size_given`: both sides; `clock`: None for 0; `clocks`: the page's range."""

    words: list
    size: tuple = (WIDTH, HEIGHT)
    size_given: bool = False
    clock: float | None = None
    clocks: tuple = (0.0, 1.0)

    def __post_init__(self):
        found = dict(settings_in(self.words))
        width, height = (max(2, int(found[name])) if name in found else None for name in ("width", "height"))
        self.size_given = bool(width and height)
        if width or height:
            self.size = (width or round(height * WIDTH / HEIGHT), height or round(width * HEIGHT / WIDTH))
        first, last = found.get("initial_clock", 0.0), found.get("final_clock", 1.0)
        self.clock = first if found.get("final_frame", 1) > 1 else found.get("clock")
        start = first if self.clock is None else self.clock
        self.clocks = (min(first, last, start), max(first, last, start))

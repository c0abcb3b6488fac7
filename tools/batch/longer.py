# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Extends a film: frames stay if nothing in them depends on its length."""

import re
import struct

from tools.batch import key as keys
from tools.batch.plan import read_ini
from tools.batch.store import read_json
from tools.focus import scene_text

# POV-Ray computes these from the last frame; values of `clock` are compared
LENGTHS = re.compile(r"\b(final_frame|final_clock|clock_delta)\b")
CLOCK = re.compile(r"\bclock\b")
FIRST = re.compile(r"\+KI(.*)|Initial_Clock\s*=(.*)", re.IGNORECASE)
LAST = re.compile(r"\+KF(.*)|Final_Clock\s*=(.*)", re.IGNORECASE)
CYCLIC = re.compile(r"[+-]KC|Cyclic_Animation\s*=.*", re.IGNORECASE)
IN_INI = re.compile(r"^\s*([+-]K|\w+_Clock|Cyclic_Animation)", re.IGNORECASE | re.MULTILINE)


def single(value):
    """In single precision, like POV-Ray's options."""
    return struct.unpack("f", struct.pack("f", value))[0]


class Clock:
    def __init__(self, words, frames):
        self.first, self.last, self.frames = 0.0, 1.0, frames
        self.known = not any(CYCLIC.fullmatch(word) for word in words)
        for word in words:
            for name, pattern in (("first", FIRST), ("last", LAST)):
                found = pattern.fullmatch(word)
                if found:
                    setattr(self, name, self.number(found))

    def number(self, found):
        try:
            return single(float(found.group(1) or found.group(2)))
        except (TypeError, ValueError, OverflowError):
            self.known = False
            return 0.0

    def of(self, frame):
        step = single(self.last - self.first) / (self.frames - 1)
        return single(step * (frame - 1) + self.first)


def without_clock(words):
    return [word for word in words if not (FIRST.fullmatch(word) or LAST.fullmatch(word))]


def code_of(path):
    """None for other files, which match a pattern by chance."""
    try:
        with open(path, encoding="latin-1") as stream:
            return scene_text.blanked(stream.read())
    except OSError:
        return ""


def files_of(work, key):
    files = set(key["files"])
    for name in work.names("done"):
        files |= set((read_json(work.record("done", name)) or {"read": {}})["read"])
    return sorted(files)


def sets_clock(inputs):
    targets = inputs.links.targets
    inis = [targets[name] for name in targets if name.startswith("options")] + [inputs.ini] * bool(inputs.ini)
    return any(IN_INI.search(read_ini(path)) for path in inis)


def objection(work, old, new, inputs):
    frames = len(new["pictures"])
    code = {path: code_of(path) for path in files_of(work, old)}
    for path, text in code.items():
        found = LENGTHS.search(text)
        if found:
            return f"file {path!r} uses {found.group(1)}, which depends on the number of frames"
    was, now = Clock(old["options"], len(old["pictures"])), Clock(new["options"], frames)
    if not any(CLOCK.search(text) for text in code.values()):
        return None
    if sets_clock(inputs) or not (was.known and now.known):
        return "the clock of its frames cannot be compared (it can where only +KI and +KF set it, on the command line)"
    for frame in range(1, was.frames + 1):
        if was.of(frame) != now.of(frame):
            return (
                f"the clock of frame {frame} was {was.of(frame):.7g}, and is {now.of(frame):.7g}. A film can be made longer where the "
                f"clock goes on at the same pace, such as with +KF{was.frames - 1} for {was.frames} frames and "
                f"+KF{frames - 1} for {frames}"
            )
    return None


def lengthen(work, request, stored, new):
    old = stored["key"]
    longer = request.kind == old["kind"] == "film" and len(new["pictures"]) > len(old["pictures"]) > 1
    if not longer or new["pictures"][: len(old["pictures"])] != old["pictures"]:
        return []
    if without_clock(old["options"]) != without_clock(new["options"]):
        return []
    reason = objection(work, old, new, request.inputs)
    if reason:
        return [f"the film is to have {len(new['pictures'])} frames in place of {len(old['pictures'])}, but {reason}"]
    old["pictures"], old["options"] = new["pictures"], new["options"]
    stored["frames"] = request.frames
    stored["hash"] = keys.key_hash(old)
    return []

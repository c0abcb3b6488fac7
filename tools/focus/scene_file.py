# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The scene's file: whether it has changed, and its change with a copy that is kept."""

import contextlib
import itertools
import os
import re
import shutil

import numpy

from tools.focus import replacing, scene_text
from tools.focus.scene_text import EditError

ENCODING = "latin-1"  # every byte is a character, so that what is not changed stays as it was

# what says where the focus lies, by family
FOCUS = {
    "lensTurn": ("tilt", "swing", "focalPoint"),
    "plane": ("plane",),
    "points": ("points",),
}
LENS = ("filmWidth", "focalLength", "sceneUnit", "shift", "fStop", "blades", "bladesAngle")
CAMERA = ("location", "direction", "right", "up")


def flat(value):
    """The numbers of a value."""
    if isinstance(value, (list, tuple)):
        return [number for part in value for number in flat(part)]
    return [] if value is None else [float(value)]


def same(a, b):
    """Whether two values are the same but for the digits that the block's text leaves out."""
    a, b = flat(a), flat(b)
    size = max([abs(x) for x in a + b], default=0)
    return len(a) == len(b) and all(abs(x - y) <= 1e-6 * size for x, y in zip(a, b))


def seen_from(location, block):
    """A block with its focus as the lens sees it, in which far numbers count no more than near ones; in units of the world."""
    found = {**block, "sceneUnit": block["sceneUnit"] / block.get("scale", 1)}
    if block["family"] == "plane":
        normal = numpy.array(block["planeNormal"]) / numpy.linalg.norm(block["planeNormal"])
        found["plane"] = list(normal / (block["planeDistance"] - normal @ location))
    elif block["family"] == "points":
        found["points"] = [list(numpy.subtract(point, location)) for point in block["points"]]
    else:
        found["focalPoint"] = list(numpy.subtract(block["focalPoint"], location))
    return found


def differences(camera, expected):
    """Names of what a camera, as the program tells it, has otherwise than expected."""
    block, wanted = camera["block"], expected["block"]
    if block is None:
        return ["camera"]
    if block["family"] != wanted["family"]:
        return ["focus"]
    wrong = [name for name in CAMERA if not same(camera[name], expected["camera"][name])]
    if block["focalLength"] is not None and "direction" in wrong:
        wrong.remove("direction")  # its length is left to the lens
    block, wanted = (seen_from(numpy.array(part["location"]), each) for part, each in ((camera, block), (expected["camera"], wanted)))
    return wrong + [name for name in (*LENS, *FOCUS[wanted["family"]]) if not same(block[name], wanted[name])]


def stamp(path):
    """What changes where a file does."""
    try:
        info = os.stat(path)
    except OSError:
        return None
    return info.st_mtime_ns, info.st_size, info.st_ino


class SceneFile:
    """The file of the scene, and the files that it reads."""

    def __init__(self, scene):
        self.path = os.path.realpath(scene)
        self.stamps = {self.path: stamp(self.path)}
        self.kept = None  # the copy of the last change
        self.written = None  # what was written

    def bytes(self):
        """The file's contents.
        @throws EditError"""
        return replacing.contents(self.path)

    def text(self):
        """The file as text, a character for each byte."""
        return self.decoded(self.bytes())

    @staticmethod
    def decoded(data):
        """Bytes as such a text."""
        return data.decode(ENCODING)

    @staticmethod
    def encoded(text):
        """The bytes of such a text."""
        return text.encode(ENCODING)

    def uses_clock(self):
        """Whether the scene asks for the clock."""
        return bool(re.search(r"\bclock\b", scene_text.blanked(self.text())))

    def replace(self, before, after):
        """Writes new contents in place of those that were read before, which are kept; returns the copy's name.
        @throws EditError"""
        replacing.require_writable(self.path)
        copy = self.keep(before)
        try:
            replacing.replace(self.path, before, after)
        except EditError:
            os.unlink(copy)
            raise
        self.kept, self.written = copy, after
        return os.path.basename(copy)

    def keep(self, data):
        """Writes a copy beside the scene; returns its path."""
        with replacing.in_words("no copy of the scene can be kept in its folder"):
            for number in itertools.count(1):
                copy = f"{self.path}.before-focus" + (f"-{number}" if number > 1 else "")
                with contextlib.suppress(FileExistsError):
                    stream = open(copy, "xb")
                    break
            try:
                with stream:
                    stream.write(data)
                shutil.copystat(self.path, copy)
            except OSError:
                os.unlink(copy)
                raise
        return copy

    def undo(self):
        """Puts the kept copy back.
        @throws EditError"""
        if self.kept is None:
            raise EditError("there is no change to take back")
        if self.bytes() != self.written:
            raise EditError("the file was changed by somebody else since; the copy is kept as " + os.path.basename(self.kept))
        replacing.replace(self.path, self.written, replacing.contents(self.kept))
        os.unlink(self.kept)
        self.kept = self.written = None

    def watch(self, file_list, own):
        """Takes note of the files that a render has read, which the program lists, but for those in our own folder."""
        names = {self.path}
        try:
            entries = open(file_list, "rb").read().split(b"\0")
            names |= {os.fsdecode(entry[1:]) for entry in entries if entry.startswith(b"+")}
        except OSError:
            pass
        names = {name for name in map(os.path.realpath, names) if not name.startswith(f"{os.path.realpath(own)}/")}
        self.stamps = {name: self.stamps.get(name, stamp(name)) for name in names}

    def changed(self):
        """Files that have changed since the last call."""
        found = [name for name, old in self.stamps.items() if stamp(name) not in (old, None)]
        for name in found:
            self.stamps[name] = stamp(name)
        return found

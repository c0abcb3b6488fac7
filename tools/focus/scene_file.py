# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Detects changes of the scene's file, and changes it with a backup."""

import contextlib
import itertools
import os
import re
import shutil

import numpy

from tools.focus import replacing, scene_text
from tools.focus.scene_text import EditError

ENCODING = "latin-1"  # every byte is a character, so that unchanged bytes survive

FOCUS = {"lensTurn": ("tilt", "swing", "focalPoint"), "plane": ("plane",), "points": ("points",), "sharp": ("sharpPoints", "sharpWithin")}
LENS = ("filmWidth", "focalLength", "sceneUnit", "shift", "fStop", "blades", "bladesAngle")
CAMERA = ("location", "direction", "right", "up")


def flat(value):
    if isinstance(value, (list, tuple)):
        return [number for part in value for number in flat(part)]
    return [] if value is None else [float(value)]


def same(a, b):
    a, b = flat(a), flat(b)
    size = max([abs(x) for x in a + b], default=0)
    return len(a) == len(b) and all(abs(x - y) <= 1e-6 * size for x, y in zip(a, b))


def seen_from(location, block):
    """Relative to the lens, so that distant points count no more; world units."""
    found = {**block, "sceneUnit": block["sceneUnit"] / block.get("scale", 1)}
    if block["family"] == "plane":
        normal = numpy.array(block["planeNormal"]) / numpy.linalg.norm(block["planeNormal"])
        found["plane"] = list(normal / (block["planeDistance"] - normal @ location))
    elif block["family"] in ("points", "sharp"):
        name = "points" if block["family"] == "points" else "sharpPoints"
        found[name] = [list(numpy.subtract(point, location)) for point in block[name]]
    else:
        found["focalPoint"] = list(numpy.subtract(block["focalPoint"], location))
    return found


def differences(camera, expected):
    block, wanted = camera["block"], expected["block"]
    if block is None:
        return ["camera"]
    if block["family"] != wanted["family"]:
        return ["focus"]
    wrong = [name for name in CAMERA if not same(camera[name], expected["camera"][name])]
    if block["focalLength"] is not None and "direction" in wrong:
        wrong.remove("direction")  # its length follows from the lens
    block, wanted = (seen_from(numpy.array(part["location"]), each) for part, each in ((camera, block), (expected["camera"], wanted)))
    return wrong + [name for name in (*LENS, *FOCUS[wanted["family"]]) if not same(block[name], wanted[name])]


def stamp(path):
    """Differs after each change. None without a file."""
    try:
        info = os.stat(path)
    except OSError:
        return None
    return f"{info.st_mtime_ns} {info.st_size} {info.st_ino}"


class SceneFile:
    def __init__(self, scene):
        self.path = os.path.realpath(scene)
        self.stamps = {self.path: stamp(self.path)}
        self.kept = None  # backup of the last change
        self.written = None  # contents of the last change

    def stamp(self):
        return stamp(self.path)

    def bytes(self):
        return replacing.contents(self.path)

    def text(self):
        """One character per byte."""
        return self.decoded(self.bytes())

    @staticmethod
    def decoded(data):
        return data.decode(ENCODING)

    @staticmethod
    def encoded(text):
        return text.encode(ENCODING)

    def uses_clock(self):
        return bool(re.search(r"\bclock\b", scene_text.blanked(self.text())))

    def replace(self, before, after):
        """Returns the backup's name. @throws EditError"""
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
        if self.kept is None:
            raise EditError("there is no change to take back")
        if self.bytes() != self.written:
            raise EditError("the file was changed by somebody else since; the copy is kept as " + os.path.basename(self.kept))
        replacing.replace(self.path, self.written, replacing.contents(self.kept))
        os.unlink(self.kept)
        self.kept = self.written = None

    @staticmethod
    def files_read(file_list, own):
        try:
            entries = file_list.read_bytes().split(b"\0")
        except OSError:
            return set()
        names = {os.path.realpath(os.fsdecode(entry[1:])) for entry in entries if entry.startswith(b"+")}
        return {name for name in names if not name.startswith(f"{os.path.realpath(own)}/")}

    def watch(self, names):
        self.stamps = {name: self.stamps.get(name, stamp(name)) for name in {self.path, *names}}

    def changed(self):
        found = [name for name, old in self.stamps.items() if stamp(name) not in (old, None)]
        for name in found:
            self.stamps[name] = stamp(name)
        return found

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Reads a picture's tiles during the render, from POV-Ray's state file.

A message: mark, version, size, "RAWSOBJE", number of attributes; each has name, type, length of four bytes, value. Big-endian."""

import dataclasses
import struct

import numpy

from tools.povray_run import STATE_HEADER, whole_messages

VECTORS = {b"VFL4": ">f4", b"VIN4": ">i4"}


PREVIEW, PICTURE = 1, 2  # of a rectangle for the page


def packed(kind, number, left, top, values):
    rows, columns = values.shape[:2]
    head = struct.pack("<6I", kind, number, left, top, columns, rows)
    return head + numpy.ascontiguousarray(values).tobytes()


@dataclasses.dataclass
class Tile:
    """Colours (rows, columns, 3) in the scene's light, or named layers."""

    left: int
    top: int
    colours: numpy.ndarray | None = None
    layers: dict | None = None


def attributes(message):
    (count,) = struct.unpack(">i", message[24:28])
    found, at = {}, 28
    for _ in range(count):
        name, kind = message[at : at + 4], message[at + 4 : at + 8]
        (length,) = struct.unpack(">i", message[at + 8 : at + 12])
        at += 12
        if kind in VECTORS:
            found[name] = numpy.frombuffer(message, VECTORS[kind], length, at)
            length *= 4
        else:
            found[name] = message[at : at + length]
        at += length
    return found


def tile_of(message):
    found = attributes(message)
    try:
        left, top, right, bottom = (struct.unpack(">i", found[name])[0] for name in (b"Left", b"Top ", b"Righ", b"Bott"))
    except KeyError:
        return None
    shape = (bottom - top + 1, right - left + 1)
    if found[b"MIDE"] == b"PxBS" and found[b"PiSi"] == b"\0\0\0\1":
        colours = found[b"PBlo"].reshape(*shape, 5)[:, :, :3]
        return Tile(left, top, colours=colours.astype("<f4"))
    if found[b"MIDE"] == b"LayT":
        names = found[b"LayN"].split(b"\0")[0].decode().split()
        values = found[b"LayV"].reshape(len(names), *shape).astype("<f4")
        return Tile(left, top, layers=dict(zip(names, values)))
    return None


class StateFile:
    """Created empty and held open: POV-Ray removes its name at the end, when tiles may be unread."""

    def __init__(self, path):
        path.unlink(missing_ok=True)
        path.touch()
        self.stream = open(path, "rb")
        self.data = b""  # header and unread bytes

    def tiles(self):
        self.data += self.stream.read()
        ends = whole_messages(self.data)
        for at, end in zip(ends, ends[1:]):
            tile = tile_of(self.data[at:end])
            if tile:
                yield tile
        if ends:
            self.data = self.data[:STATE_HEADER] + self.data[ends[-1] :]

    def close(self):
        self.stream.close()

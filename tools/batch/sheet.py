# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The contact sheet of a sweep."""

import math
import os
import pathlib

from tools.batch import merge, povray
from tools.batch.store import sync_file

THUMB = 320  # columns of a picture
STRIP = 26
AT_ONCE = 50  # pictures per call: starting oiiotool takes longer than a thumbnail


def columns(sets, count):
    """A column for each value of the last parameter; for a single one, slightly wider than tall."""
    if len(sets) > 1:
        return len(sets[-1][1])
    return math.ceil(math.sqrt(count))


def thumb(link, target, size, label):
    width, height = size
    words = [link, "--ch", "R,G,B"]
    if link.endswith(".exr"):
        words += ["--colorconvert", "linear", "sRGB", "--clamp:min=0:max=1"]
    words += ["--resize", f"{width}x{height}"]
    words += ["--pattern", "constant:color=0.12,0.12,0.12", f"{width}x{height + STRIP}", "3", "--paste", "+0+0"]
    words += [f"--text:x=8:y={height + 18}:size=15:font=../inputs/font.ttf:color=0.9,0.9,0.9", label]
    return [*words, "-d", "uint8", "-o", target, "--pop"]


def font_file(program):
    prefix = pathlib.Path(os.path.realpath(program)).parent.parent
    return str(prefix / "share" / "povray-3.7" / "include" / "cyrvetic.ttf")


def make(work, description):
    folder = work.folder / "sheet"
    folder.mkdir(exist_ok=True)
    font = work.inputs / "font.ttf"
    font.unlink(missing_ok=True)
    font.symlink_to(font_file(description["program"]))
    width, height = description["key"]["size"]
    size = [min(THUMB, width), max(1, round(height * min(THUMB, width) / width))]
    names, words = [], []
    for i, picture in enumerate(description["key"]["pictures"]):
        link = folder / f"in{i:05d}.{description['key']['extension']}"
        link.unlink(missing_ok=True)
        link.symlink_to(os.path.join(description["output"], picture["name"]))
        names.append(f"out{i:05d}.png")
        words.append(thumb(link.name, names[-1], size, label_that_fits(picture["label"], size[0])))
    for i in range(0, len(words), AT_ONCE):
        merge.oiiotool(folder, sum(words[i : i + AT_ONCE], []))
    across = min(len(names), columns(description["sets"], len(names)))
    down = -(-len(names) // across)
    merge.oiiotool(folder, [*names, "--mosaic:pad=6", f"{across}x{down}", "-o", "sheet.png"])
    sync_file(folder / "sheet.png")
    povray.image_info(folder / "sheet.png")
    target = pathlib.Path(description["output"]) / description["sheet"]
    merge.deliver(folder / "sheet.png", target)
    return target


def label_that_fits(label, width):
    most = max(4, (width - 16) // 8)
    return label if len(label) <= most else label[: most - 3] + "..."

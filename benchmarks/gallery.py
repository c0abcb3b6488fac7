# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The gallery's scenes with the cameras that compete.

The unpatched program cannot read their `tilt_lens`: copies use `camera.inc` with the reported numbers and a round diaphragm. The
untilted variant keeps lens and focus, aimed at the middle of the picture."""

import json
import math
import re

from benchmarks.lab import SCENES, Failed, digest
from tools import povray_run
from tools.repository import ROOT

GALLERY = ROOT / "scenes" / "gallery"
SIZE = (1280, 720)
CAMERA = re.compile(r"^camera \{\n.*?^\}\n", re.MULTILINE | re.DOTALL)


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def total(*terms):
    return [sum(factor * vector[i] for factor, vector in terms) for i in range(3)]


def normalized(vector):
    return total((1 / math.sqrt(dot(vector, vector)), vector))


def told(lab, name, folder):
    record = folder / "camera.json"
    command = povray_run.command(
        lab.ours,
        GALLERY / f"{name}.pov",
        folder / "pixel.png",
        SIZE,
        "-C",
        "+WT1",
        "+SC2",
        "+EC2",
        "+SR2",
        "+ER2",
        library=[povray_run.INCLUDE],
    )
    # a preview without aperture does not tell it
    runs = [
        povray_run.run(command, folder, povray_run.environment(**preview), limit=None).succeeded()
        for preview in ({"TILT_LENS_PREVIEW": str(record)}, {})
    ]
    return json.loads(record.read_text())["view"], runs[-1].said


def numbers(messages, words):
    found = re.search(rf"^ +{words}\.+(.*)$", messages, re.MULTILINE)
    if not found:
        raise Failed(f"the program does not report: {words}")
    return [float(number) for number in re.findall(r"-?\d+(?:\.\d+)?(?:e[-+]?\d+)?", found.group(1))]


def lens(view, messages):
    axis, right, up = (normalized(view[name]) for name in ("direction", "right", "up"))
    film, _, *shift = numbers(messages, "Film")
    _, diameter, units = numbers(messages, "Aperture")
    return {
        "Eye": view["location"],
        "Axis_": axis,
        "Right_": right,
        "Up_": up,
        "Angle": math.degrees(2 * math.atan(film / 2 / numbers(messages, "Focal length")[1])),
        "Film_": film,
        "Unit_": diameter / units,
        "Aperture": 2 * units,
        "Shift_": shift,
        "Focus": numbers(messages, "Sharp plane through"),
        "Normal_": numbers(messages, "normal"),
    }


def untilted(tilted):
    eye, normal, (shift_right, shift_up) = tilted["Eye"], tilted["Normal_"], tilted["Shift_"]
    film_distance = tilted["Film_"] / 2 / math.tan(math.radians(tilted["Angle"] / 2))
    middle = total((film_distance, tilted["Axis_"]), (shift_right, tilted["Right_"]), (shift_up, tilted["Up_"]))
    axis = normalized(middle)
    up = normalized(total((1, tilted["Up_"]), (-dot(tilted["Up_"], axis), axis)))
    hand = math.copysign(1.0, dot(cross(tilted["Up_"], tilted["Axis_"]), tilted["Right_"]))
    across = dot(normal, axis)
    distance = dot(normal, total((1, tilted["Focus"]), (-1, eye))) / across if across else math.inf
    if not 0.0 < distance < math.inf:
        raise Failed("nothing is sharp in the middle of the picture")
    return {
        **tilted,
        "Axis_": axis,
        "Right_": total((hand, cross(up, axis))),
        "Up_": up,
        "Normal_": axis,
        "Focus": total((1, eye), (distance, axis)),
        "Shift_": [0, 0],
        "Angle": math.degrees(2 * math.atan(tilted["Film_"] / 2 / math.sqrt(dot(middle, middle)))),
    }


def declared(camera):
    def text(value):
        return f"<{', '.join(map(text, value))}>" if isinstance(value, list) else f"{value:.12g}"

    return "".join(f"  #declare {name} = {text(value)};\n" for name, value in camera.items())


def copy(lab, name):
    original = (GALLERY / f"{name}.pov").read_text()
    path = lab.work / "scenes" / digest(original, (SCENES / "camera.inc").read_text()) / f"{name}.pov"
    if path.is_file():
        return path.parent
    lab.say(f"  the camera of {name}")
    path.parent.mkdir(parents=True, exist_ok=True)
    tilted = lens(*told(lab, name, path.parent))
    camera = (
        f"#ifndef (Tilted) #declare Tilted = 0; #end\n#if (Tilted)\n{declared(tilted)}#else\n"
        f'{declared(untilted(tilted))}#end\n#include "camera.inc"\n'
    )
    text, count = CAMERA.subn("", original)
    if count != 1:
        raise Failed(f"{name}.pov has {count} cameras that begin a line, not one")
    unfinished = path.with_suffix(".part")
    unfinished.write_text("#version 3.7;\n" + camera + text)  # before the scene can take one of the camera's names
    unfinished.rename(path)
    return path.parent

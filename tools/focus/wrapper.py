# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""A file that includes the scene and states another camera, because POV-Ray takes the last one."""

import os
import re

from tools.focus import scene_text
from tools.focus.render import nameable
from tools.povray_run import INCLUDE, quoted

VECTORS = ("location", "direction", "right", "up")


def search(settings, folder):
    places = {"includes": INCLUDE, "beside": os.path.dirname(settings.scene)}
    return [f"+L{quoted(nameable(place, folder, link))}" for link, place in places.items()]


def vector(values):
    return "<" + ", ".join(repr(float(value)) for value in values) + ">"


def write(folder, scene, camera, inside, name="scene"):
    text = open(scene, encoding="latin-1").read()
    version = scene_text.version_of(text)
    included = str(scene)
    if not re.fullmatch(r"[ !#-\[\]-~]+", included):  # characters allowed in a string of POV-Ray without escapes
        link = folder / "included.pov"
        link.unlink(missing_ok=True)
        link.symlink_to(included)
        included = str(link)
    lines = [
        f"#version {version};" if version else "",
        f'#include "{included}"',
        "camera {",
        "  perspective",
        *(f"  {name} {vector(camera[name])}" for name in VECTORS),
        inside,
        "}",
        "",
    ]
    path = folder / f"{name}.pov"
    path.write_text("\n".join(lines), encoding="ascii")
    return path

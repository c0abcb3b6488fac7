# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Reading a scene: one pixel of the gallery's scenes, by a pinhole."""

from benchmarks import gallery, suite
from benchmarks.lab import PINHOLE

REPETITIONS = 5


def measure(lab):
    lab.say("reading the scenes of the gallery")
    rows = []
    for name in suite.DISPLAY:
        scene = suite.of_gallery(name, gallery.copy(lab, name))
        shot = lab.one_pixel(scene.shot(PINHOLE, size=suite.DISPLAY_SIZE, part=None))
        stock, ours = lab.interleaved([(lab.stock, shot), (lab.ours, shot)], 1 if lab.quick else REPETITIONS)
        rows.append({"scene": name, "stock": stock["cpu"], "ours": ours["cpu"]})
    return rows

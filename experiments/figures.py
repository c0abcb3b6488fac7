# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The paper's pictures for the eye: Figs. 4, 5, 6 and 9. They make no claims in numbers; the other
experiments measure what these show."""

from common import SCENES

PICTURES = {
    "dragons": (["dragons_normal", "dragons_tilted"], (480, 270)),
    "box": (["box_a", "box_b", "box_c"], (360, 240)),
    "landscape": ([f"landscape_{letter}" for letter in "abcd"], (480, 270)),
}


def make(lab, group):
    names, size = PICTURES[group]
    if lab.quick:
        size = (size[0] // 4, size[1] // 4)
    for name in names:
        picture = lab.render(SCENES / f"{name}.pov", f"{name}.png", size)
        print(f"        {picture}", flush=True)
    return ()


def dragons(lab):
    """Fig. 4."""
    return make(lab, "dragons")


def box(lab):
    """Figs. 5 and 6."""
    return make(lab, "box")


def landscape(lab):
    """Fig. 9."""
    return make(lab, "landscape")

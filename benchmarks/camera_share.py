# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The share of camera and sampler in a cheap ray: callgrind's instructions in the sampling of tiles, without tracing."""

from benchmarks import instructions, suite
from benchmarks.lab import TILT_LENS, Shot

SCENES = ("wall", "checks", "town")
SIZE = instructions.SIZE
SAMPLES = 64
SETTINGS = [suite.limits(SAMPLES, SAMPLES, 0), suite.limits(8, 1024, 1e-4)]
ALL, RAYS = "tilt_lens::TileSampler::Run(*", "pov::Trace::TraceRay(*"


def measure(lab, count=instructions.count):
    lab.say("share of camera and sampler in the cost of a ray")
    rows = []
    for scene in SCENES[:1] if lab.quick else SCENES:
        both = [
            [count(lab, lab.ours, Shot(scene, TILT_LENS, size=SIZE, declare=declare), within=function) for function in (ALL, RAYS)]
            for declare in SETTINGS
        ]
        rays = SAMPLES * SIZE[0] * SIZE[1]
        rows.append(
            {
                "scene": scene,
                "instructions": both[0][0] / rays,
                "camera": (both[0][0] - both[0][1]) / rays,
                "share": 1 - both[0][1] / both[0][0],
                "share_judged": 1 - both[1][1] / both[1][0],
            }
        )
    return rows

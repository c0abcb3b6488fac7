# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later

from benchmarks import gallery, suite
from benchmarks.lab import TILT_LENS

SCENE = "miniature_town"
REPETITIONS = 3


def measure(lab):
    lab.say("one sample in each pixel")
    scene = suite.of_gallery(SCENE, gallery.copy(lab, SCENE))
    whole = scene.shot(TILT_LENS, 1, size=suite.DISPLAY_SIZE, part=None, declare=suite.limits(1, 1, 1e-3))
    (run,) = lab.interleaved([(lab.ours, whole)], 1 if lab.quick else REPETITIONS)
    return [{"scene": SCENE, "cpu": run["cpu"], "rays": run["rays"]}]

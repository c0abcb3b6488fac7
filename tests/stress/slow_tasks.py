# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""A slowly starting program must not read the parser's lights; with late tiles, progress must not fall.

python3 -m tests.stress.slow_tasks PROGRAM"""

import pathlib
import re
import sys
import tempfile

from tools import povray_run

SCENE = """#version 3.7; global_settings { assumed_gamma 1 }
camera { location -4*z look_at 0 aperture 0.3 blur_samples 4 tilt_lens { tilt 3 } }
#for (I, 1, 50) light_source { <I, 8, -6>, rgb 0.02 } #end
sphere { 0, 1 pigment { rgb 1 } }
"""


def main():
    with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
        folder = pathlib.Path(name)
        (folder / "scene.pov").write_text(SCENE)
        done = povray_run.run(povray_run.command(sys.argv[1], "scene.pov", "p.png", (32, 24), "+WT2", "+BS4", "+V"), folder)
        made = (folder / "p.png").is_file()
    copied = re.findall(r"Bounding has copied (\d+) light sources", done.said)
    rendered = [
        (int(pixels), int(percent)) for pixels, percent in re.findall(r"Rendered (\d+) of 768 pixels \((\d+)% of the work\)", done.said)
    ]
    if len(rendered) < 24 or rendered != sorted(rendered) or rendered[-1] != (768, 100):
        sys.exit(f"(pixels, per cent) as told: {rendered}")
    if done.code != 0 or not made or copied != ["0"]:
        sys.exit(f"picture {made}, lights copied while the scene was parsed: {copied}\n{done.told()}")


if __name__ == "__main__":
    main()

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Memory leaks by frames, by tiles, and within a picture.

jemalloc counts allocated bytes: a leak adds at least the smallest block each time.
"""

import json
import pathlib
import tempfile

from tests.render import scenes
from tests.stress import results
from tools import povray_run

FRAMES, ROWS = (250, 500), (1536, 12288)
SMALLEST = 8  # bytes of jemalloc's smallest block
WIDTH, TILE = 64, 32
PIXEL = 20  # bytes: five floats
# JSON on standard error, without the threads' caches
COUNTS = "tcache:false,stats_print:true,stats_print_opts:Jdablxeh,stats_interval:1000000,stats_interval_opts:Jdablxeh"
HEAD = "#version 3.7; global_settings { assumed_gamma 1 }\n"
MOVING = (
    HEAD
    + scenes.camera("tilt 4 + 3*sin(clock) swing clock/4", samples="blur_samples 8, 32 ", tail="bokeh { pigment { gradient x } }")
    + scenes.WORLD
)
LARGE = (
    HEAD
    + """camera { right x*image_width/image_height location <0.4, 3, -3.5> look_at <0, 0, 0.2> angle 45 aperture 0.3
  blur_samples 4, 16 confidence 0.9 variance 1/1500 tilt_lens { tilt 4 swing 2 blades 7 } }
plane { y, 0 pigment { checker rgb <0.9, 0.8, 0.7> rgb <0.1, 0.3, 0.5> scale 0.5 } normal { bumps 0.1 scale 0.05 }
  finish { ambient 0.1 diffuse 0.8 reflection 0.05 } }
sphere { <0.3, 0.6, 0>, 0.6 pigment { rgb <0.8, 0.2, 0.1> } finish { reflection 0.3 phong 0.5 } }
sphere { <-0.9, 0.4, -0.7>, 0.4 pigment { rgbf 0.9 } interior { ior 1.5 } finish { phong 0.9 reflection 0.1 } }
#declare R = seed(3);
#for (I, 0, 400) sphere { <6*rand(R)-3, 0.05, 8*rand(R)-2>, 0.05+0.05*rand(R) pigment { rgb <rand(R), rand(R), rand(R)> } } #end
light_source { <4, 8, -6>, rgb 0.7 area_light x, z, 3, 3 jitter adaptive 1 }
light_source { <-4, 6, -3>, rgb 0.3 }
background { rgb <0.3, 0.5, 0.8> }
"""
)


def counts(said):
    found, at = [], said.find('{"jemalloc"')
    while at >= 0:
        try:
            found.append(json.JSONDecoder().raw_decode(said, at)[0]["jemalloc"]["stats"]["allocated"])
        except json.JSONDecodeError:
            pass
        at = said.find('{"jemalloc"', at + 1)
    return found


def render(setup, scene, size, *options):
    with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
        (pathlib.Path(name) / "scene.pov").write_text(scene)
        command = povray_run.command(setup.povray, "scene.pov", "picture.png", size, "-V", "-GA", *options)
        done = povray_run.run(command, name, povray_run.environment(MALLOC_CONF=COUNTS)).succeeded()
    found = counts(done.said)
    if not found:
        raise RuntimeError(f"no counts\n{done.told()}")
    return {"kept": found[-1], "most": max(found)}


def measure(setup, frames=FRAMES, rows=ROWS):
    """Uses one thread: with two, the peak depends on which is faster."""
    work = setup.work("soak")

    def made(name, number, scene, size, *options):
        result = results.once(
            work,
            f"{name}-{number}",
            [setup.povray, __file__, scenes.__file__],
            lambda: render(setup, scene, size, *options),
            lambda result: [],
        )
        return {name: number, **result}

    return {
        "frames": [made("frames", n, MOVING, (16, 12), "+WT2", f"+KFF{n}", "+KF6.28") for n in frames],
        "rows": [made("rows", n, LARGE, (WIDTH, n), "+WT1", f"+BS{TILE}") for n in rows],
    }


def faults(result):
    found = []
    for name, size in (("frames", 1), ("rows", TILE)):
        few, many = result[name]
        kept, more = many["kept"] - few["kept"], many[name] - few[name]
        if kept >= SMALLEST * more // size:
            found.append(f"{kept} bytes more are allocated at the end after {more} more {name}")
    few, many = result["rows"]
    pixels = WIDTH * (many["rows"] - few["rows"])
    held = many["most"] - few["most"]
    if held > (PIXEL + 8) * pixels:
        found.append(f"{held} bytes more are allocated at a time for {pixels} more pixels")
    return found

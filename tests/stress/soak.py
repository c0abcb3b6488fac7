# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Memory over time: an animation of many tiny frames, and one large picture, each in one process. For the
large picture, CPU time counts, because a waiting program allocates nothing."""

import itertools
import re
import statistics
import subprocess
import tempfile
import pathlib

from tests.render import scenes
from tests.stress import harness, watch

FRAMES, SECONDS = 1000, 3600
HEAD = "#version 3.7; global_settings { assumed_gamma 1 }\n"
MOVING = (HEAD + scenes.camera("tilt 4 + 3*sin(clock) swing clock/4 blades 5, 10", samples="blur_samples 8, 32 ",
                               tail="bokeh { pigment { gradient x } }").replace("blades 5, 10", "") + scenes.WORLD)
# no sky in it: all tiles weigh alike
LARGE = """camera { right x*image_width/image_height location <0.4, 3, -3.5> look_at <0, 0, 0.2> angle 45 aperture 0.3
  blur_samples 64, 512 confidence 0.9 variance 1/15000 tilt_lens { tilt 4 swing 2 blades 7 } }
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


def command(setup, *options):
    """Two threads, which share the sampler's blocks."""
    return [str(setup.povray.resolve()), "+Iscene.pov", "+Opicture.png", "-D", "-P", "-A", "+WT2", *options]


def growth(course):
    """KiB of resident memory that the second half of a run gained: the lesser of two estimates, because each errs in its own way.
    What is left behind is left again and again; an allocator takes much at once, now and then, which the first does not see, and
    gives it back soon, which the second does not see."""
    second = course[len(course) // 2:]
    return min(by_steps([point["kib"] for point in second]), by_slopes([(point["seconds"], point["kib"]) for point in second]))


def by_steps(sizes):
    """By the medians of six parts, five times the usual step."""
    size = len(sizes) // 6
    parts = [statistics.median_low(sizes[i * size:(i + 1) * size]) for i in range(6)]
    return 5 * statistics.median_low([after - before for before, after in zip(parts, parts[1:])])


def by_slopes(points):
    """By the median slope of all pairs of points (Theil and Sen's estimator)."""
    slopes = [(kib - before) / (t - start) for (start, before), (t, kib) in itertools.combinations(points, 2) if t > start]
    return round(statistics.median(slopes) * (points[-1][0] - points[0][0])) if slopes else 0


def summary(watched, **more):
    """What is kept of a run."""
    return {"seconds": round(watched.seconds), "processor_seconds": round(watched.cpu), "peak_kib": watched.peak,
            "exit": watched.returncode,
            "course": [{"seconds": t, "kib": m} for t, _, m in watched.course[::max(1, len(watched.course) // 100)]], **more}


def animation(setup, frames):
    """So many tiny frames in one process."""
    with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
        folder = pathlib.Path(name)
        (folder / "scene.pov").write_text(MOVING)
        watched = watch.watch(command(setup, "+W16", "+H12", f"+KFF{frames}", "+KF6.28"), folder / "said.txt", 0.05, cwd=folder)
        done = len(list(folder.glob("picture*.png")))
    return summary(watched, frames=done)


def large_picture(setup, seconds):
    """One picture, stopped after so many seconds of processor time if it is not done."""
    with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
        folder = pathlib.Path(name)
        (folder / "scene.pov").write_text(HEAD + LARGE)
        # so narrow that what the blocks along a row of tiles need is taken in a small part of the time
        size = ("+W8000", "+H6000") if seconds > 300 else ("+W160", "+H6000")
        watched = watch.watch(command(setup, *size), folder / "said.txt", max(0.2, seconds / 720), seconds, cwd=folder)
    return summary(watched, width=int(size[0][2:]), height=int(size[1][2:]), asked_seconds=seconds)


def heap(setup, frames):
    """heaptrack over an animation: what is still held at the end, for each frame more."""
    held = []
    with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
        folder = pathlib.Path(name)
        (folder / "scene.pov").write_text(MOVING)
        for count in (frames, 2 * frames):
            out = folder / f"heap{count}"
            subprocess.run(["heaptrack", "-o", str(out), *command(setup, "+W16", "+H12", f"+KFF{count}", "+KF6.28")],
                           cwd=folder, stdin=subprocess.DEVNULL, capture_output=True, check=True)
            data = next(folder.glob(f"heap{count}.*"))
            said = subprocess.run(["heaptrack_print", str(data)], capture_output=True, text=True, check=True).stdout
            found = re.search(r"total memory leaked: ([\d.]+)([KMG]?)B?", said)
            held.append(float(found[1]) * {"": 1, "K": 1e3, "M": 1e6, "G": 1e9}[found[2]])
    return {"frames": frames, "held_bytes": held, "bytes_per_frame": round((held[1] - held[0]) / frames)}


def measure(setup, frames=FRAMES, seconds=SECONDS, heap_frames=50):
    """All of it; without heaptrack where the number of its frames is 0."""
    work = setup.work("soak")
    parts = {"large": (seconds, large_picture), "animation": (frames, animation), "heap": (heap_frames, heap)}
    wanted = [(name, size, run) for name, (size, run) in parts.items() if size]

    def made(part):
        name, size, run = part
        return harness.once(work, f"{name}-{size}", [setup.povray, __file__], lambda: run(setup, size))

    return dict(zip([name for name, _, _ in wanted], harness.in_parallel(setup.jobs, made, wanted)))


def faults(result):
    """What breaks the promises, in words."""
    found = []
    animation_, large = result["animation"], result["large"]
    if animation_["exit"] != 0:
        found.append(f"animation: exit code {animation_['exit']}, {animation_['frames']} frames")
    if large["exit"] not in (0, -9):
        found.append(f"large picture: exit code {large['exit']}")
    # what a frame leaves behind would be there a thousand times
    for name, course in (("animation", animation_["course"]), ("large picture", large["course"])):
        if len(course) < 24:
            found.append(f"{name}: memory measured {len(course)} times, 24 are needed; make it longer")
        elif growth(course) > 512:
            found.append(f"{name}: {growth(course)} KiB more in the second half")
    if large["processor_seconds"] < large["asked_seconds"]:
        found.append(f"large picture: done after {large['processor_seconds']} of {large['asked_seconds']} seconds; make it larger")
    if "heap" in result and result["heap"]["bytes_per_frame"] > 1000:
        found.append(f"heap: {result['heap']['bytes_per_frame']} bytes a frame are not freed")
    return found

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
import subprocess

from tests.stress import rays, reports, results, soak
from tools.repository import ROOT

TITLES = {
    "random": "what people photograph",
    "corners": "corners of a picture 100,000 pixels wide",
    "tilt": "lens turned by 75 to 89.9 degrees",
    "parallel": "focus parallel to the ray, exactly or but for 1e-11 to 1e-16",
    "through_view": "focus through the view, down to 1e-13 of the numbers it is written with",
    "behind": "focus behind the camera",
    "far_focus": "focus 1e9 to 1e15 away",
    "far_camera": "scene 1e7 from the origin",
    "farther_camera": "scene 1e12 from the origin",
    "scale": "whole scene 1e-9 to 1e9 times as large",
    "unit": "`scene_unit` 1e-9 to 1e9 mm",
    "aperture": "aperture 0 to 1000 distances",
    "film": "film 0.1 mm to 10 m",
    "narrow": "angle of view 1e-9 to 1e-4 of a usual one",
    "odd_numbers": "signed zeros, denormals, the largest numbers, infinities, NaN",
    "several": "three of these at once",
}


HEAD = """<!--
povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
SPDX-License-Identifier: AGPL-3.0-or-later
-->
# Numbers under stress

This page shows how the camera behaves with extreme numbers, hostile input, faults and long runs. It is made by
`python3 -m tests.stress.run`; `python3 -m tests.stress.run rays` measures one part again, and `--page` only writes the page
from the results in `docs/numerics`. `./check -L "stress|fuzz"` runs a short form of the parts.
"""

RAYS = """
## Solver and rays

A lens is solved in 113 bits from the numbers of the scene, and rounded once; rays are computed in double precision
(`povray-src/tilt_lens/camera/optics.cpp`, `ray.h`). Each ray is compared with a geometric construction in 50 digits
(`tests/unit/reference_camera.h`, boost::multiprecision), which shares no formula with the camera.

- *ulp*: the length of the difference of the two directions over the direction's length, in units of 2^-52. A camera is
  well-posed if its ray is at least a quarter as long as the sum of the vectors that it is added up from.
- *pixels*: the error in a picture 100,000 pixels wide: the distance from the given film point to the one that exactly has
  the computed direction, or the angle between the two directions in pixels, where that is less.
- *narrow*: angles of view so small (below about 0.0013 degrees in that picture) that a millionth of a pixel is less than
  the last place of a direction of length 1. They have a separate table below.
- *reaches the film*: lenses whose rim passes through the film; the program warns of them.

| cameras | accepted | refused | worst ulp, well-posed | worst ulp | worst pixels | reaches the film | no numbers |
| --- | --: | --: | --: | --: | --: | --: | --: |
"""

NARROW = """
### Narrow pictures

In narrow pictures, not every ray is within 1e-6 pixels. No program that stores a direction as three doubles can achieve
that: the exact direction, rounded to nearest, has such an error as well. *Roundings* is the angular error of the camera's
ray over the largest angle by which that rounding can turn the direction (half a last place of each coordinate). It
is {roundings:.1f} at most. In all other pictures, the largest error is {others:.1e} pixels.

| cameras | narrow | worst pixels | of the true direction, rounded | worst roundings |
| --- | --: | --: | --: | --: |
"""


def number(value, form="{:.2g}"):
    return "-" if value is None or value == 0 else form.format(value)


def narrow_table(result):
    sets = [name for name in ("random", *rays.SETS) if result[name]["narrow_pixels"]["count"]]
    text = NARROW.format(
        roundings=max((result[name]["narrow_roundings"]["worst"] for name in sets), default=0.0),
        others=max(tally["pixels"]["worst"] for tally in result.values()),
    )
    for name in sets:
        t = result[name]
        text += (
            f"| {TITLES[name]} | {t['narrow_pixels']['count']:,} | {number(t['narrow_pixels']['worst'])} | "
            f"{number(t['narrow_rounded']['worst'])} | {number(t['narrow_roundings']['worst'], '{:.1f}')} |\n"
        )
    return text


def rays_section(result):
    text = RAYS
    for name in ("random", *rays.SETS):
        t = result[name]
        text += (
            f"| {TITLES[name]} | {t['cameras'] - t['refused']:,} | {t['refused']:,} | "
            f"{number(t['well_posed']['worst'], '{:.1f}')} | {number(t['ulps']['worst'], '{:.1f}')} | "
            f"{number(t['pixels']['worst'])} | "
            f"{number(t['reach_pixels']['worst'])} | {t['broken']} |\n"
        )
    text += narrow_table(result)
    text += "\n### Refused cameras\n\nEach refused camera causes an error message:\n\n| message begins | times |\n| --- | --: |\n"
    refusals = {}
    for t in result.values():
        for words, count in t["refusals"].items():
            refusals[words] = refusals.get(words, 0) + count
    text += "".join(f"| {words} | {count:,} |\n" for words, count in sorted(refusals.items()))
    text += (
        "\n![Share of rays by error in units of the last place](numerics/ulps.svg)\n\n### The obvious formula\n\n"
        "The obvious formula finds the point of sharp focus P on the chief ray by a division, and normalises P - l for "
        "the lens point l. It was tried with one camera in eight. *Reversed* rays point away from the scene, because P "
        "lies behind the lens; *no numbers* are infinite or NaN, because P lies at infinity.\n\n| cameras | tried | reversed | no numbers | worst pixels "
        "of the rest |\n| --- | --: | --: | --: | --: |\n"
    )
    for name in ("random", *rays.SETS):
        o = result[name]["obvious_pixels"]
        reversed_ = o["by_power"].get("30", 0)
        rest = max((int(power) for power in o["by_power"] if power != "30"), default=None)
        text += (
            f"| {TITLES[name]} | {o['count'] + result[name]['obvious_broken']:,} | {reversed_:,} | "
            f"{result[name]['obvious_broken']:,} | {'-' if rest is None else f'below 1e{rest + 1}'} |\n"
        )
    text += "\n![Share of rays by error in pixels, of the camera and of the obvious formula](numerics/pixels.svg)\n"
    sets = ("random", "tilt", "through_view", "aperture", "several")
    plot(
        "ulps.svg", "error, power of ten of a unit of the last place", range(-4, 4), [(TITLES[name], result[name]["ulps"]) for name in sets]
    )
    plot(
        "pixels.svg",
        "error, power of ten of a pixel of 100,000 across",
        range(-14, 6),
        [
            (f"{who}: {TITLES[name]}", result[name][spread])
            for name in ("random", "through_view", "several")
            for who, spread in (("camera", "pixels"), ("obvious", "obvious_pixels"))
        ],
    )
    return text


def plot(name, label, powers, spreads):
    lines = [
        "\n".join(f"{power} {spread['by_power'].get(str(power), 0) / max(1, spread['count'])}" for power in powers) for _, spread in spreads
    ]
    plots = ", ".join(f"'-' with linespoints lw 2 title '{title}'" for title, _ in spreads)
    script = (
        "set terminal svg size 720,480 dynamic background 'white'\nset output '" + str(results.RESULTS / name) + "'\n"
        "set logscale y\nset yrange [1e-7:2]\nset format y '10^{%T}'\n"
        f"set xlabel '{label}'\nset ylabel 'share of rays'\nset key outside below maxcols 1 Left reverse width -30\n"
        f"plot {plots}\n" + "\ne\n".join(lines) + "\ne\n"
    )
    subprocess.run(["gnuplot"], input=script, text=True, check=True)


def sampler_section(result):
    text = (
        "\n## Sampler\n\nThe table has the least t for which the first 2^m samples are a (t, m, 2)-net in base 2, for each "
        "projection; t = 0 means one sample in each elementary interval. Unit tests check each coordinate alone, all four "
        "together, aligned blocks up to the last index, and uniformity over discs, polygons and bokeh pictures by "
        "chi-square.\n\n"
    )
    powers = sorted(result["projections"][0]["t"], key=int)
    text += "| pair | " + " | ".join(f"2^{m}" for m in powers) + " |\n| --- |" + " --: |" * len(powers) + "\n"
    for row in result["projections"]:
        text += f"| {row['pair']} | " + " | ".join(str(row["t"][m]) for m in powers) + " |\n"
    text += (
        f"\nAmong 2^{result['log2_samples']} samples {sum(result['repeated'])} occur twice in a coordinate; around the "
        f"indices 2^20, 2^31 and the last one, {result['overflow_faults']} are out of range or equal to the next.\n\n"
        "The next table has the star discrepancy of the lens pair, times the number of samples (exact, for some "
        "pixels). The bound is Niederreiter's for a (0, m, 2)-net. Hammersley's points check the computation against "
        "Halton and Zaremba's formula.\n\n| samples | mean | worst | bound | random points | Hammersley | known |\n"
        "| --: | --: | --: | --: | --: | --: | --: |\n"
    )
    for row in result["discrepancy"]:
        text += (
            f"| {2 ** row['m']} | {row['mean']:.2f} | {row['worst']:.2f} | {row['bound']:.1f} | {row['random']:.1f} | "
            f"{row['hammersley']:.4f} | {row['hammersley_known']:.4f} |\n"
        )
    worst = max(row[where] for row in result["correlation"] for where in ("right", "below", "diagonal"))
    return text + (
        f"\nErrors of neighbouring pixels (right, below, diagonal; 1, 8, 64 samples; three integrands): the largest "
        f"of 27 correlations is {worst:.1f} times its standard error.\n"
    )


def pictures_section(result):
    furnace, mirror, moved, noise = (result[key] for key in ("furnace", "mirror", "moved", "noise"))
    text = (
        "\n## Properties of pictures\n\n| property | tried | found |\n| --- | --- | --- |\n"
        f"| constant surroundings stay constant, to 1e-4 | {furnace['cameras']} random cameras, under a sky and inside a "
        f"ball | off by {furnace['worst']:.1e} at most (16-bit files) |\n"
        f"| a mirrored scene in a mirrored camera is the picture turned over | {mirror['cameras']} cameras, "
        f"{mirror['pictures']} independent pictures of each side | largest |t| of a block {mirror['worst_z']:.1f}; with the "
        f"swing left as it was {mirror['wrong_swing_z']:.0f} |\n"
        f"| camera and world turned, scaled and moved together | {moved['cameras']} cameras | RMS difference at most "
        f"{moved['worst_rms']:.1e} |\n"
        f"| variance falls with samples | {noise['pictures']} independent pictures each | as samples to the power "
        f"{noise['slope']:.2f} (random samples: -1) |\n\n| samples | variance |\n| --: | --: |\n"
    )
    return text + "".join(f"| {row['samples']} | {row['variance']:.2e} |\n" for row in noise["rows"])


def faults_section(result):
    text = "\n## Faults\n\n"
    for name in ("SIGKILL", "SIGTERM"):
        row = result[name]
        text += (
            f"- {name} at {row['tries']} random moments, then `+C`: the same pixels {row['same']} times, a torn picture "
            f"{row['torn']} times; finished blocks kept {row['kept']} times.\n"
        )
    text += "\n| fault | exit code | first words | torn picture |\n| --- | --: | --- | --- |\n"
    for row in result["environment"]:
        text += f"| {row['name']} | {row['exit']} | {row['said']} | {'yes' if row['torn'] else 'no'} |\n"
    return text


def soak_section(result):
    text = (
        "\n## Memory over time\n\nBytes that the allocator has given and not got back, by its own count.\n\n"
        "| run | at the end | most at a time |\n| --- | --: | --: |\n"
    )
    for row in result["frames"]:
        text += f"| {row['frames']} frames of 16 by 12 | {row['kept']:,} | {row['most']:,} |\n"
    for row in result["rows"]:
        text += f"| one picture of {soak.WIDTH} by {row['rows']} | {row['kept']:,} | {row['most']:,} |\n"
    few, many = result["rows"]
    each = (many["most"] - few["most"]) / soak.WIDTH / (many["rows"] - few["rows"])
    return text + f"\nA pixel more takes {each:.1f} bytes while the picture is rendered; as stored it has {soak.PIXEL}.\n"


def scale_section(result):
    text = (
        "\n## Scale\n\nThe tables have CPU seconds and peak memory of the whole process. The power is that of time against"
        " size; 1 is linear. A\nfile has the size of the whole picture: with few rows, most of the time is spent on writing"
        " it, which does not depend on the\nrows.\n\n"
    )
    for key, title in (
        ("rows", f"rows of a picture {result['width']} by {result['width']}"),
        ("samples", "`blur_samples`, 64 by 48"),
        ("objects", "objects, 160 by 120"),
    ):
        text += f"| {title} | seconds | peak |\n| --: | --: | --: |\n"
        text += "".join(f"| {row[key]:,} | {row['processor_seconds']} | {row['peak_mib']} MiB |\n" for row in result[key])
        text += f"\nPower: {result['slopes'][key]:.2f}.\n\n"
    return text.rstrip("\n") + "\n"


def fuzz_section(result):
    grammar = result["grammar"]
    text = (
        f"\n## Fuzzing\n\n{grammar['blocks']:,} blocks of a grammar (`tests/fuzz/grammar.py`) go through POV-Ray's own parser, "
        f"500 in each process ({'built with ASan and UBSan' if grammar['sanitized'] else 'release build'}). Each must result in a lens "
        f"with finite rays or in one error. The program then renders the {grammar['pictures']:,} accepted blocks as frames "
        f"of 8 by 6 pixels, 250 in each process; each must be a picture of finite numbers. {len(grammar['bad'])} failed.\n\n| generated as: result | blocks |\n| --- | --: |\n"
    )
    text += "".join(f"| {key} | {n:,} |\n" for key, n in sorted(grammar["counts"].items())) + "\n"
    for name, title in (("solver", "the solver"), ("prescription", "the readers of prescriptions"), ("parser", "the block's parser")):
        if name in result:
            row = result[name]
            text += (
                f"libFuzzer on {title}: {row['runs']:,} runs in {row['seconds']:,} s, {row['coverage']} edges, {row['kept']} inputs kept; "
                f"{'nothing found' if row['exit'] == 0 else 'a finding'}.\n"
            )
    return text


def sanitizers_section(result):
    text = (
        "\n## Sanitizers\n\nThe whole program runs under sanitizers. A finding is ours if a frame of its stack lies in one of our "
        "files. Findings in\nupstream's code that are known by name are counted separately.\n\n"
        "| what | tool | commands | failed | findings in our files | in upstream's, known | in upstream's, others |\n"
        "| --- | --- | --: | --: | --: | --: | --: |\n"
    )
    for row in result["rows"]:
        text += (
            f"| {row['what']} | {row['tool']} | {row['runs']} | {row['failed']} | {row['ours']} | "
            f"{sum(row['known'].values()):,} | {row['others']} |\n"
        )
    text += "\nFindings known by name, from `tests/stress/suppressions`:\n\n| tool | name | reason |\n| --- | --- | --- |\n"
    for tool in ("ubsan", "tsan", "valgrind"):
        for name, reason in reports.suppressed(tool):
            text += f"| {tool} | `{name}` | {reason} |\n"
    return text


def shortly_section(result):
    return (
        f"\n## The short form\n\n`./check -L \"stress|fuzz\"`, once built: {result['tests']} tests in {result['seconds']} s on "
        f"{result['cores']} {'core' if result['cores'] == 1 else 'cores'}, {len(result['failed'])} failed.\n"
    )


SECTIONS = {
    "rays": rays_section,
    "sampler": sampler_section,
    "pictures": pictures_section,
    "fuzz": fuzz_section,
    "sanitizers": sanitizers_section,
    "faults": faults_section,
    "soak": soak_section,
    "scale": scale_section,
    "shortly": shortly_section,
}


def write():
    text, missing = HEAD, []
    for name, section in SECTIONS.items():
        result = results.load(name)
        if result is None:
            missing.append(name)
        else:
            text += section(result)
    if missing:
        text += f"\n## Not measured yet\n\n{', '.join(missing)}: `python3 -m tests.stress.run {' '.join(missing)}`.\n"
    (ROOT / "docs" / "numerics.md").write_text(text)

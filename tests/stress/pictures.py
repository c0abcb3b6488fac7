# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Constant surroundings, mirrors, moved worlds and noise.

A wider frame gives a film point other samples, and so independent pictures.
"""

import math
import pathlib
import random
import statistics
import tempfile

from tests.render import rendering
from tests.stress import results
from tools import povray_run

FURNACES, WIDTH, HEIGHT = 200, 48, 36
GLOW = "#default { finish { ambient 1 diffuse 0 } }\n"
BOX = (
    "box { <-2, 0, 1>, <-1, 1.6, 2> pigment { gradient y color_map { [0.5 rgb 0.9][0.5 rgb 0.1] } scale 0.4 } }\n"
    "sphere { <0.5, 0.7, 0.2>, 0.6 pigment { rgb <0.8, 0.2, 0.1> } }\n"
    "cylinder { <1.4, 0, 2>, <1.2, 1.8, 2.2>, 0.2 pigment { rgb <0.2, 0.9, 0.3> } }\n"
)
FLOOR = "plane { y, 0 pigment { checker rgb <0.9, 0.8, 0.7> rgb <0.1, 0.3, 0.5> } }\n"
SKY = "background { rgb <0.3, 0.5, 0.8> }\n"


def use(setup):
    rendering.SETTINGS.povray, rendering.SETTINGS.compare = str(setup.povray), str(setup.compare)


def random_lens(r):
    kind = r.randrange(4)
    if kind == 0:
        focus = f"tilt {r.uniform(-60, 60):.4f} swing {r.uniform(-60, 60):.4f} "
    elif kind == 1:
        focus = f"focus_tilt {r.uniform(-85, 85):.4f} focus_swing {r.uniform(-85, 85):.4f} "
    else:
        n = (r.uniform(-2, 2), r.uniform(-2, 2), 1.0)
        z = 10 ** r.uniform(-0.5, 3)
        if kind == 2:
            size = math.sqrt(sum(c * c for c in n))
            focus = f"focal_plane {{ <{n[0]:.6f}, {n[1]:.6f}, 1>, {z / size:.6f} }} "
        else:
            points = [(x, y, z - n[0] * x - n[1] * y) for x, y in ((0, 0), (z, 0), (0, z))]
            focus = "focal_points " + ", ".join(f"<{x:.6f}, {y:.6f}, {w:.6f}>" for x, y, w in points) + " "
    shape = r.choice(
        (
            "",
            "",
            f"blades {r.randint(3, 9)}, {r.uniform(-90, 90):.2f} ",
            f"blades {r.randint(3, 9)} blade_curvature {r.random():.3f} squeeze {r.uniform(0.2, 5):.2f} ",
        )
    )
    character = (
        ""
        if r.random() < 0.7
        else (
            f"edge_light {r.uniform(-0.9, 0.9):.2f} "
            f"distortion {r.uniform(0, 0.3):.3f} field_curvature {r.uniform(-0.5, 0.5):.3f} lateral_colour {r.uniform(-0.2, 0.2):.3f} axial_colour {r.uniform(-0.2, 0.2):.3f} "
        )
    )
    shift = f"shift <{r.uniform(-30, 30):.3f}, {r.uniform(-30, 30):.3f}> " if r.random() < 0.5 else ""
    return (
        f"{focus}{shape}{character}{shift}scene_unit {10 ** r.uniform(0, 4):.4f} film_width {r.uniform(5, 200):.3f}",
        10 ** r.uniform(-4, 1.3),
    )


def furnaces(setup, count, work):
    """Departure from constant light."""
    r = random.Random(4)
    cases = []
    for i in range(1, count + 1):
        lens, aperture = random_lens(r)
        cases.append(
            f"#case ({i}) camera {{ location 0 direction {r.uniform(0.4, 3):.4f}*z right x up 0.75*y "
            f"focal_point <0, 0, {10 ** r.uniform(0, 3):.5f}> aperture {aperture:.6g} "
            f"blur_samples 4, 16 tilt_lens {{ {lens} }} }}\n#break\n"
        )
    surroundings = "#if (Ball) sphere { 0, 1e5 hollow pigment { rgb 0.5 } } #else background { rgb 0.5 } #end\n"
    scene = rendering.HEAD + GLOW + "#switch (frame_number)\n" + "".join(cases) + "#end\n" + surroundings
    worst = 0.0
    for ball in (0, 1):
        folder = work / f"furnace{ball}"
        folder.mkdir(exist_ok=True)
        (folder / "scene.pov").write_text(scene)
        povray_run.run(
            povray_run.command(
                setup.povray,
                "scene.pov",
                "p.png",
                (12, 9),
                "+FN16",
                "File_Gamma=1.0",
                "+WT1",
                "+KFI1",
                f"+KFF{count}",
                f"Declare=Ball={ball}",
            ),
            folder,
            limit=None,
        ).succeeded()
        pictures = sorted(folder.glob("p*.png"))
        if len(pictures) != count:
            raise RuntimeError(f"furnace: {len(pictures)} pictures, not {count}")
        for path in pictures:
            values = rendering.read_picture(path, str(path)).values
            worst = max(worst, max(abs(v - 0.5) for v in values))
    return {"cameras": count, "pictures": 2 * count, "worst": worst}


def camera(lens, batch=0, aperture=0.3, samples="blur_samples 32 variance 0", tail="", location="<0.4, 1.5, -4>", look_at="<0, 0.5, 0.5>"):
    """The frame is `batch` pixels wider on each side."""
    wide, high = (WIDTH + 2 * batch) / WIDTH, (HEIGHT + 2 * batch) / HEIGHT
    return (
        f"camera {{ location {location} direction 1.3*z right {WIDTH / HEIGHT * wide!r}*x up {high!r}*y "
        f"look_at {look_at} aperture {aperture} {samples} "
        f"tilt_lens {{ film_width {36 * wide!r} {lens} }} {tail} }}\n"
    )


def picture(scene, batch=0):
    whole = rendering.render(scene, "+WT1", width=WIDTH + 2 * batch, height=HEIGHT + 2 * batch)
    return whole.crop(batch, batch, batch + WIDTH, batch + HEIGHT)


def independent(scene_of, count, jobs):
    return results.in_parallel(jobs, lambda k: picture(scene_of(9 * k + 1), 9 * k + 1).values, range(count))


def block_scores(left, right, flip):
    """Largest |z| of the mean difference over 8 by 8 pixels."""
    channels = len(left[0]) // (WIDTH * HEIGHT)

    def at(values, x, y):
        start = (y * WIDTH + (WIDTH - 1 - x if flip else x)) * channels
        return values[start : start + channels]

    def block(values, left_x, top, mirrored):
        total = 0.0
        for y in range(top, min(top + 8, HEIGHT)):
            for x in range(left_x, left_x + 8):
                start = (y * WIDTH + x) * channels
                total += sum(at(values, x, y) if mirrored else values[start : start + channels])
        return total

    worst = 0.0
    for top in range(0, HEIGHT, 8):
        for x in range(0, WIDTH, 8):
            a = [block(v, x, top, False) for v in left]
            b = [block(v, x, top, True) for v in right]
            error = math.sqrt((statistics.variance(a) + statistics.variance(b)) / len(a))
            if error > 0:
                worst = max(worst, abs(statistics.mean(a) - statistics.mean(b)) / error)
    return worst


def mirrors(setup, count, pictures):
    r = random.Random(8)
    worst, wrong = 0.0, None
    for _ in range(count):
        swing, tilt, shift, turn = r.uniform(3, 12), r.uniform(-12, 12), r.uniform(2, 6), r.uniform(10, 80)

        def scene(batch, sign, written=1.0, swing=swing, tilt=tilt, shift=shift, turn=turn):
            lens = f"swing {sign * written * swing} tilt {tilt} shift <{sign * shift}, 3> blades 5, {90 + sign * (turn - 90)}"
            world = f"union {{ {FLOOR}{BOX} scale <{sign}, 1, 1> }}\n"
            return GLOW + camera(lens, batch, location=f"<{sign * 0.4}, 1.5, -4>") + world + SKY

        left = independent(lambda batch, scene=scene: scene(batch, 1), pictures, setup.jobs)
        right = independent(lambda batch, scene=scene: scene(batch, -1), pictures, setup.jobs)
        worst = max(worst, block_scores(left, right, True))
        if wrong is None:  # an unmirrored swing must be detected
            wrong = block_scores(left, independent(lambda b, scene=scene: scene(b, -1, -1.0), pictures, setup.jobs), True)
    return {"cameras": count, "pictures": pictures, "worst_z": worst, "wrong_swing_z": wrong}


def moved_worlds(setup, count):
    r = random.Random(12)
    jobs = []
    for _ in range(count):
        lens = f"tilt {r.uniform(-9, 9)} swing {r.uniform(-9, 9)} shift <{r.uniform(-5, 5)}, {r.uniform(-5, 5)}> blades 6, 13"
        tail = (
            f"rotate <{r.uniform(0, 360)}, {r.uniform(0, 360)}, {r.uniform(0, 360)}> "
            f"scale {10 ** r.uniform(-3, 3)} translate <{r.uniform(-9, 9)}, {r.uniform(-9, 9)}, 3> "
        )
        jobs.append((lens, tail))

    def rms(job):
        lens, tail = job
        still = picture(GLOW + camera(lens) + f"union {{ {FLOOR}{BOX} }}\n" + SKY)
        moved = picture(GLOW + camera(lens, tail=tail) + f"union {{ {FLOOR}{BOX} {tail} }}\n" + SKY)
        return rendering.difference(still, moved)[0]

    found = results.in_parallel(setup.jobs, rms, jobs)
    return {"cameras": count, "worst_rms": max(found)}


def noise(setup, most, pictures):
    rows = []
    samples = 8
    while samples <= most:
        limits = f"blur_samples {samples} variance 0"
        values = independent(
            lambda b, limits=limits: GLOW + camera("tilt 6 swing 3", b, 0.5, limits) + FLOOR + BOX + SKY, pictures, setup.jobs
        )
        variance = statistics.fmean(statistics.variance(pixel) for pixel in zip(*values))
        rows.append({"samples": samples, "variance": variance})
        samples *= 4
    xs, ys = [math.log(row["samples"]) for row in rows], [math.log(row["variance"]) for row in rows]
    return {"rows": rows, "pictures": pictures, "slope": statistics.linear_regression(xs, ys).slope}


def measure(setup, cameras=FURNACES, few=12, pictures=6, samples=2048):
    use(setup)
    with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
        found = {"furnace": furnaces(setup, cameras, pathlib.Path(name))}
    found["mirror"] = mirrors(setup, few, pictures)
    found["moved"] = moved_worlds(setup, few)
    found["noise"] = noise(setup, samples, pictures)
    return found


def limit_of_scores(result):
    """The largest of `count` values |t| exceeds it once in 1000 runs (Sidak)."""
    mirror = result["mirror"]
    blocks = (WIDTH // 8) * math.ceil(HEIGHT / 8) * mirror["cameras"]
    share = 1 - (1 - 1e-3) ** (1 / blocks)
    return students_quantile(1 - share / 2, 2 * (mirror["pictures"] - 1))


def students_quantile(p, freedom):
    scale = math.exp(math.lgamma((freedom + 1) / 2) - math.lgamma(freedom / 2)) / math.sqrt(freedom * math.pi)

    def beyond(t, steps=4000):
        total = 0.0
        for i in range(steps):
            x = (i + 0.5) / steps
            total += (1 + (t / x) ** 2 / freedom) ** (-(freedom + 1) / 2) * t / (x * x)
        return scale * total / steps

    low, high = 0.1, 1e4
    for _ in range(60):
        middle = math.sqrt(low * high)
        low, high = (middle, high) if beyond(middle) > 1 - p else (low, middle)
    return high


def faults(result):
    found = []
    if not result["furnace"]["worst"] <= 1e-4:
        found.append(f"furnace: off by {result['furnace']['worst']}")
    limit = limit_of_scores(result)
    if not result["mirror"]["worst_z"] <= limit:
        found.append(f"mirror: z {result['mirror']['worst_z']}, allowed {limit}")
    if not result["mirror"]["wrong_swing_z"] > limit:
        found.append(f"mirror: a wrong swing was not found: z {result['mirror']['wrong_swing_z']}, limit {limit}")
    if not result["moved"]["worst_rms"] <= 2e-3:
        found.append(f"moved worlds: RMS {result['moved']['worst_rms']}")
    if not result["noise"]["slope"] <= -0.95:
        found.append(f"noise: variance falls with the power {result['noise']['slope']} of the samples")
    return found

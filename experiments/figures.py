# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Figs. 4, 5, 6 and 9: blur measured against a pinhole picture."""

import dataclasses

from experiments import box as box_scene
from experiments.laboratory import SCENES, Claim
from experiments.lens import Lens, View, add, length, sub, times
from experiments.sharpness import Region, beyond_grid, measure, regions

PINHOLE = 0.0001


def pictures(lab, names, size, pinhole, finer=1, declare=()):
    """`pinhole`: declarations for the first one's pinhole picture, as many times finer."""
    found = {}
    for name in names:
        found[name] = lab.render(SCENES / f"{name}.pov", f"{name}.exr", size, declare)
        print(f"        {lab.png(found[name])}", flush=True)
    found["pinhole"] = lab.render(SCENES / f"{names[0]}.pov", f"{names[0]}_pinhole.exr", [finer * side for side in size], pinhole)
    return found


ROW_START, ROW_STEP = (-0.85, 0, -0.6), (1.45, 0, 4.0)


def around(number, low, high, name):
    middle = add(ROW_START, times(number, ROW_STEP))
    return Region(name, add(middle, low), add(middle, high))


def dragons(lab):
    """Fig. 4. The floor beside the dragons is tested."""
    view = View((0.2, 2.7, -9.5), (0.55, 0.9, 2.2), *((256, 144) if lab.quick else (640, 360)), 0, 0, 1000)
    floor = [around(i, (1.5, 0, -0.6), (2.9, 0, 0.6), f"floor beside dragon {i + 1}") for i in range(4)]
    backs = [around(i, (-0.35, 0.5, -0.35), (0.35, 1.1, 0.35), "") for i in range(4)]
    focus = add(add(ROW_START, ROW_STEP), (0, 0.8, 0))
    planes = {"dragons_normal": (sub(view.look_at, view.location), focus), "dragons_tilted": ((ROW_STEP[2], 0, -ROW_STEP[0]), ROW_START)}
    shown = pictures(lab, list(planes), (view.width, view.height), [("Wide", PINHOLE)])
    found = {}
    for name, (normal, point) in planes.items():
        lens = Lens.of_angle(view, 41, 0.45, normal, point)
        _, claims = regions(lab, shown["pinhole"], shown[name], lens, floor)
        for claim in claims:
            yield dataclasses.replace(claim, text=f"{name[8:]}, {claim.text}")
        found[name] = measure(lab, shown["pinhole"], shown[name], [back.window(lens) for back in backs], 24)
    normal, tilted = found.values()
    yield Claim(
        "normal: the second dragon's blur in parts of the next sharpest one's", beyond_grid(normal[1]) / min(normal[0], *normal[2:]), 0.5
    )
    yield Claim(
        "tilted: the most blurred dragon in parts of the normal lens's most blurred one", beyond_grid(max(tilted)) / max(normal), 0.5
    )
    lab.table("dragons.csv", ["dragon", "normal, pixels", "tilted, pixels"], [[i + 1, *pair] for i, pair in enumerate(zip(normal, tilted))])


# relative to the distance: the grid's part in a blur of 4 pixels is 1/6 pixel, 0.2 to 0.5 cm at 60 cm
SHARP_LIMIT = 0.01
WIDE = 3.0  # pixels


def floor_line(count):
    return [add((-12.5, 0, -11), times(i / (count - 1), (-5.5, 0, 23))) for i in range(count)]


def side_line(count):
    return [box_scene.turned((-1.0, 0.9 + 4.6 * i / (count - 1), -6)) for i in range(count)]


def sharp_place(lab, sharp, blurred, lens, points, half):
    """Where the points' line meets the plane of sharp focus. Blur times depth is a straight line, since it is proportional to the distance
    from the plane."""
    windows = []
    for point in points:
        x, y = (round(c) for c in lens.pixel(point))
        windows.append([x - half, y - half, 2 * half, 2 * half])
    found = measure(lab, sharp, blurred, windows, 40)
    pairs = [(i / (len(points) - 1), d * lens.view.local(p)[2]) for i, (p, d) in enumerate(zip(points, found)) if d > WIDE]
    n, mean_x, mean_y = len(pairs), *(sum(column) / len(pairs) for column in zip(*pairs))
    slope = (sum(x * y for x, y in pairs) - n * mean_x * mean_y) / (sum(x * x for x, _ in pairs) - n * mean_x**2)
    at = mean_x - mean_y / slope
    return add(points[0], times(at, sub(points[-1], points[0]))), found


def box(lab):
    """Figs. 5 and 6. A quick form would have too small squares."""
    view = dataclasses.replace(box_scene.VIEW, width=360, height=240)
    size = (view.width, view.height)
    rows = []
    for letter, line, half in (("a", floor_line(33), 22), ("b", side_line(12), 11), ("c", floor_line(33), 22)):
        shown = pictures(lab, [f"box_{letter}"], size, [("Stop", 1e6), ("Variance", 1e-4)], finer=3)
        lens = box_scene.state(letter, view)
        place, found = sharp_place(lab, shown["pinhole"], shown[f"box_{letter}"], lens, line, half)
        local = view.local(place)
        off = (1 - sum(k * x for k, x in zip(lens.focus, local))) / length(lens.focus)
        yield Claim(
            f"({letter}): the sharpest place of the {'side' if letter == 'b' else 'floor'} " "is off the plane by",
            off / length(local),
            SHARP_LIMIT,
            "of its distance",
        )
        for point, diameter in zip(line, found):
            rows.append([letter, *point, lens.blur_diameter(point), diameter])
    lab.table("box.csv", ["state", "x", "y", "z", "closed form, pixels", "measured, pixels"], rows)


GREEN = (4, 0, -2)
LANDSCAPE = [
    Region("village green", (0, 0, -6), (8, 4, 2)),
    Region("keep", (28.5, 10, -6.5), (37.5, 24, -2)),
    Region("red balloon", (9, 44, -8), (23, 59, -2)),
    Region("windmill", (-34, 4, -44), (-28, 12, -38)),
    Region("field", (20, 0, -62), (28, 0.2, -54)),
    Region("blue balloon", (-72, 36, 84), (-60, 50, 96)),
]


def landscape(lab):
    """Fig. 9."""
    view = View((-10, 56, -116), (4, 3.4, -4), *((240, 180) if lab.quick else (640, 480)), 0, 0, 1000)
    planes = {
        "a": (8, sub(view.look_at, view.location), GREEN),
        "b": (8, (0, 1, 0), (0, 0, 0)),
        "c": (8, (0, 0, 1), GREEN),
        "d": (16, (0, 0, 1), GREEN),
    }
    if lab.quick:
        planes = {letter: planes[letter] for letter in "ac"}
    shown = pictures(
        lab,
        [f"landscape_{letter}" for letter in planes],
        (view.width, view.height),
        [("Wide", PINHOLE), ("Variance", 1e-4 if lab.quick else 5e-4)],
        finer=1 if lab.quick else 3,
        declare=[("Denoise", 0), ("Variance", 2e-5)],
    )
    found = {}
    for letter, (diameter, normal, point) in planes.items():
        lens = Lens.of_angle(view, 70, diameter, normal, point)
        found[letter], claims = regions(lab, shown["pinhole"], shown[f"landscape_{letter}"], lens, LANDSCAPE)
        for claim in claims:
            yield dataclasses.replace(claim, text=f"({letter}) {claim.text}")
    yield Claim("(c) red balloon: blur in parts of (a)'s", beyond_grid(found["c"]["red balloon"]) / found["a"]["red balloon"], 0.5)
    for name in () if lab.quick else ("windmill", "blue balloon"):
        yield Claim(f"(d) {name}: blur in parts of (c)'s", found["d"][name] / found["c"][name], 2.2, low=1.8)
    lab.table(
        "landscape.csv",
        ["region", *(f"({letter}), pixels" for letter in planes)],
        [[place.name, *(found[letter][place.name] for letter in planes)] for place in LANDSCAPE],
    )

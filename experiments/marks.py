# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Small bright discs, and second moments of their images."""

import math

from experiments.laboratory import OWN_SCENES
from experiments.lens import add, times

SIZE = 2.5  # radius of a disc in a pinhole's picture, pixels


def vector(v):
    return "<" + ", ".join(f"{x:.12g}" for x in v) + ">"


def world(view, point):
    moved = view.location
    for amount, axis in zip(point, view.axes()):
        moved = add(moved, times(amount, axis))
    return moved


def at_pixel(lens, x, y, depth):
    view, scale = lens.view, lens.pixels_per_slope()
    millimetre = view.width / view.film_width
    slope_x = (x - view.width / 2 + view.shift[0] * millimetre) / scale
    slope_y = (view.height / 2 - y + view.shift[1] * millimetre) / scale
    return world(view, (slope_x * depth, slope_y * depth, depth))


def radius_of(lens, point):
    return SIZE * lens.view.local(point)[2] / lens.pixels_per_slope()


def render(lab, name, lens, through, points, samples=1024):
    view, folder = lens.view, lab.work / name
    folder.mkdir(parents=True, exist_ok=True)
    marks = ",\n".join(f"  {{ {vector(p)}, {radius_of(lens, p):.12g}*x }}" for p in points)
    (folder / "marks.inc").write_text(
        "\n".join(
            [
                f"#declare Eye = {vector(view.location)};",
                f"#declare Target = {vector(view.look_at)};",
                f"#declare Through = {vector(through)};",
                f"#declare Film_Width = {view.film_width};",
                f"#declare Scene_Unit = {view.scene_unit};",
                f"#declare Focal_Length = {view.focal_length};",
                f"#declare F_Stop = {view.f_stop};",
                f"#declare Tilt = {lens.tilt():.12g};",
                f"#declare Shift = {vector(view.shift)};",
                f"#declare Samples = {samples};",
                f"#declare Marks = array[{len(points)}][2] {{\n{marks}\n}}",
                "",
            ]
        )
    )
    return lab.render(OWN_SCENES / "marks.pov", f"{name}/marks.exr", (view.width, view.height), options=[f"+L{folder}"])


def window(lens, point, reach):
    x, y = lens.pixel(point)
    left, top = math.floor(x - reach), math.floor(y - reach)
    return [left, top, math.ceil(x + reach) - left, math.ceil(y + reach) - top]


def measure(lab, picture, lens, points, reaches):
    found = lab.moments(picture, [window(lens, p, r) for p, r in zip(points, reaches)])
    return [(m["xx"], m["xy"], m["yy"]) for m in found]


def sharp_moments(x, y):
    """A hard edge falls on the grid by chance, by some per cent of the moments."""
    fine, reach = 32, math.ceil(SIZE) + 1
    sums = [0] * 6
    for row in range(math.floor(y) - reach, math.floor(y) + reach + 1):
        for column in range(math.floor(x) - reach, math.floor(x) + reach + 1):
            count = sum(
                (column + (i + 0.5) / fine - x) ** 2 + (row + (j + 0.5) / fine - y) ** 2 <= SIZE * SIZE
                for i in range(fine)
                for j in range(fine)
            )
            u, v = column + 0.5 - x, row + 0.5 - y
            for i, term in enumerate((1, u, v, u * u, u * v, v * v)):
                sums[i] += count * term
    n, u, v = sums[:3]
    return (sums[3] / n - (u / n) ** 2, sums[4] / n - u * v / n / n, sums[5] / n - (v / n) ** 2)


def expected(lens, point):
    blur = lens.blur_moments(point)
    if blur[0] + blur[2] < 0.1:
        return sharp_moments(*lens.pixel(point))
    disc = lens.disc_moments(point, radius_of(lens, point))
    return tuple(a + b + c for a, b, c in zip(blur, disc, (1 / 12, 0.0, 1 / 12)))

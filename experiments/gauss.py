# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""double_gauss.cpp's lens for `prescription`, also with a first element that moves to focus."""

import json

# radius, thickness, index behind, clear diameter; the stop is in the fifth thickness
ROWS = (
    (29.475, 3.76, 1.67, 25.2),
    (84.83, 0.12, 1, 25.2),
    (19.275, 4.025, 1.67, 23),
    (40.77, 3.275, 1.699, 23),
    (12.75, 10.205, 1, 18),
    (-14.495, 1.18, 1.603, 17),
    (40.77, 6.065, 1.658, 20),
    (-20.385, 0.19, 1, 20),
    (437.065, 3.22, 1.717, 20),
    (-39.73, 0, 1, 20),
)
BEFORE_STOP = 5  # surfaces
STOP_DIAMETER = 24
FIRST_ELEMENT = 2  # surfaces


def moved_rows(moved):
    return [
        (radius, thickness + moved * (number + 1 == FIRST_ELEMENT), index, diameter)
        for number, (radius, thickness, index, diameter) in enumerate(ROWS)
    ]


def matrix(rows):
    """height' = a height + b slope', slope' (times the index) = c height + d slope', first surface through last thickness."""
    index, a, b, c, d = 1.0, 1.0, 0.0, 0.0, 1.0
    for radius, thickness, behind, _ in rows:
        c, d = c - (behind - index) / radius * a, d - (behind - index) / radius * b
        index = behind
        a, b = a + thickness / index * c, b + thickness / index * d
    return a, b, c, d


def stop_place(moved=0.0):
    """Mm behind the fifth surface, image in the front principal point, as in glass_lens.cpp."""
    rows = moved_rows(moved)
    _, _, c, d = matrix(rows)
    principal = (d - 1) / c
    radius, _, index, diameter = rows[BEFORE_STOP - 1]
    a, b, c, d = matrix([*rows[: BEFORE_STOP - 1], (radius, 0.0, index, diameter)])
    return (principal * a - b) / (d - principal * c)


def focal_length(moved=0.0):
    return -1 / matrix(moved_rows(moved))[2]


def with_stop(before):
    radius, thickness, index, diameter = ROWS[BEFORE_STOP - 1]
    return [*ROWS[: BEFORE_STOP - 1], (radius, before, index, diameter), (0, thickness - before, 0, STOP_DIAMETER), *ROWS[BEFORE_STOP:]]


def write(folder):
    path = folder / "gauss.dat"
    path.write_text("".join(" ".join(map(str, row)) + "\n" for row in with_stop(stop_place())))
    return path


def write_moving(folder, moved, film_distance):
    """moving.json: focal length 50 with the first element half-way to its near limit. The film distance is that from the rear principal point.
    Returns the focal length at infinity."""
    scale = 50 / focal_length(moved)
    a, _, c, _ = matrix(ROWS)
    at_infinity = -a / c
    a, _, c, _ = matrix(moved_rows(moved))
    behind = film_distance / scale + (1 - a) / c  # H' lies (1 - a) / c behind the last surface
    film = [at_infinity, at_infinity + 2 * (behind - at_infinity)]
    a, b, c, d = matrix(moved_rows(2 * moved))
    near = -(b + film[1] * d) / (a + film[1] * c)
    surfaces = []
    for radius, thickness, index, diameter in with_stop(stop_place(moved)):
        if len(surfaces) + 1 == FIRST_ELEMENT:
            thickness = [thickness, thickness + 2 * moved]
        surfaces.append({"radius": radius, "thickness": thickness, "ior": index, "semi_aperture": diameter / 2})
    surfaces[-1]["thickness"] = film
    (folder / "moving.json").write_text(json.dumps({"object-distance": ["infinity", near], "surfaces": surfaces}))
    return scale * focal_length()

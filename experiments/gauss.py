# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The double Gauss of experiments/tools/glass_lens.cpp as a file for `prescription`."""

# The stop stands where that program puts it, so that the entrance pupil lies in the front principal point.
ROWS = ("29.475 3.76 1.67 25.2", "84.83 0.12 1 25.2", "19.275 4.025 1.67 23", "40.77 3.275 1.699 23", "12.75 {before} 1 18",
        "0 {behind} 0 24", "-14.495 1.18 1.603 17", "40.77 6.065 1.658 20", "-20.385 0.19 1 20", "437.065 3.22 1.717 20",
        "-39.73 0 1 20")
GAP = 10.205            # mm, between the surfaces on both sides of the stop


def stop_place():
    """Behind the fifth surface, mm, of the stop that the scene sees in the front principal point."""
    index, a, b, c, d = 1.0, 1.0, 0.0, 0.0, 1.0     # height' = a height + b slope', slope' (times the index) = c height + d slope'
    at_stop = None
    for number, row in enumerate(ROWS):
        radius, thickness, behind, _ = (float(x) for x in row.format(before=GAP, behind=0).split())
        if number == 5:
            continue
        c, d = c - (behind - index) / radius * a, d - (behind - index) / radius * b
        index = behind
        if number == 4:
            at_stop = (a, b, c, d)
        a, b = a + thickness / index * c, b + thickness / index * d
    principal = (d - 1) / c                         # behind the first surface
    a, b, c, d = at_stop
    return (principal * a - b) / (d - principal * c)


def write(folder):
    """Makes gauss.dat in a folder."""
    before, path = stop_place(), folder / "gauss.dat"
    path.write_text("\n".join(ROWS).format(before=before, behind=GAP - before) + "\n")
    return path

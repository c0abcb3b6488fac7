# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Tables of instructions and times."""

from benchmarks.front import geometric_mean
from benchmarks.tables import TITLES, Goal, table


def goals_instructions(rows):
    worst = max(row["more"] for row in rows)
    return [
        Goal.of_greatest(
            "Instructions of the patched program beyond those of the unpatched one, in scenes without `tilt_lens`",
            worst,
            0.001,
            "+0.1 %",
            f"{100*worst:+.1f} %",
        )
    ]


def section_instructions(rows):
    cells = [[row["case"], f"{row['unpatched']:,}", f"{row['patched']:,}", f"{100*row['more']:+.3f} %"] for row in rows]
    return [
        table(["scene", "instructions, unpatched", "instructions, patched", "more"], cells),
        *[goal.sentence() for goal in goals_instructions(rows)],
    ]


def goals_camera(rows):
    worst = max(row[name] for row in rows for name in ("share", "share_judged"))
    return [
        Goal.of_greatest(
            "Share of camera and sampler in the instructions of a ray that costs little", worst, 0.08, "8 %", f"{100*worst:.1f} %"
        )
    ]


def section_camera(rows):
    cells = [
        [
            TITLES[row["scene"]],
            f"{row['instructions']:,.0f}",
            f"{row['camera']:,.0f}",
            f"{100*row['share']:.1f} %",
            f"{100*row['share_judged']:.1f} %",
        ]
        for row in rows
    ]
    return [
        table(
            [
                "scene",
                "instructions of a ray, 64 rays in each pixel",
                "camera and sampler",
                "their share",
                "their share at variance 1/10000",
            ],
            cells,
        ),
        *[goal.sentence() for goal in goals_camera(rows)],
    ]


def goals_glass(rows):
    ideal = {row["scene"]: row["camera"] for row in rows if row["lens"] == "ideal"}
    times = [row["camera"] / ideal[row["scene"]] for row in rows if row["lens"] != "ideal"]
    return [
        Goal.of_greatest(
            "Camera and sampler with a lens of glass, against an ideal lens", max(times), 3, "3 times", f"{max(times):.1f} times"
        )
    ]


def section_glass(rows):
    cells = [
        [TITLES[row["scene"]], row["lens"], f"{row['instructions']:,.0f}", f"{row['camera']:,.0f}", f"{100*row['share']:.0f} %"]
        for row in rows
    ]
    return [
        table(["scene", "lens", "instructions of a ray, 16 rays in each pixel", "camera and sampler", "their share"], cells),
        *[goal.sentence() for goal in goals_glass(rows)],
    ]


def goals_samples(rows):
    ratios = [row["instructions"] / row["before"] for row in rows if row.get("before")]
    if not ratios:
        return []
    mean, most = geometric_mean(ratios), max(ratios)
    return [
        Goal("Instructions of a sample over those of the program of before, geometric mean", "at most 0.65", f"{mean:.2f}", mean <= 0.65),
        Goal.of_greatest("Instructions of a sample over those of the program of before, in each scene", most, 0.85, "0.85", f"{most:.2f}"),
        *goals_seconds([row["seconds"] for row in rows if row.get("seconds")]),
    ]


def goals_seconds(ratios):
    mean = geometric_mean(ratios)
    return (
        [
            Goal(
                "CPU seconds of the rays of a sample over those of the program of before, geometric mean",
                "at most 0.7",
                f"{mean:.2f}",
                mean <= 0.7,
            )
        ]
        if ratios
        else []
    )


def section_samples(rows):
    cells = [
        [
            TITLES[row["scene"]],
            f"{row['instructions']:,.0f}",
            f"{100*row['intersections']/row['instructions']:.0f} %",
            *([f"{row['before']:,.0f}", f"{row['instructions']/row['before']:.2f}"] if row.get("before") else ["-", "-"]),
            f"{row['seconds']:.2f}" if row.get("seconds") else "-",
        ]
        for row in rows
    ]
    return [
        table(["scene", "instructions of a sample", "of these in intersections", "before", "ratio", "ratio of CPU seconds"], cells),
        *[goal.sentence() for goal in goals_samples(rows)],
    ]


def section_loops(rows):
    return [table(["function", "ns for each call"], [[name, f"{ns:.1f}"] for name, ns in rows])]


def section_speedups(rows):
    def billions(count):
        return f"{count / 1e9:.2f}"

    def mean(values):
        return f"{geometric_mean(values):.2f}"

    cells = [
        [
            TITLES[row["scene"]],
            billions(row["without"]),
            billions(row["with"]),
            f"{row['without'] / row['with']:.2f}",
            f"{row['seconds']:.2f}",
        ]
        for row in rows
    ]
    last = ["geometric mean", "", "", mean(row["without"] / row["with"] for row in rows), mean(row["seconds"] for row in rows)]
    return [
        table(["scene", "10<sup>9</sup> instructions without speedups", "with them", "ratio", "ratio of CPU seconds"], [*cells, last]),
        "Whole runs, reading of the scene included: 96 by 54 pixels with eight samples each, one thread.",
    ]


def section_builds(rows):
    cells = [
        [TITLES[row["scene"]], f"{row['usual']:.3f}", f"{row['fast']:.3f}", f"{row['times']:.2f}", "yes" if row["same"] else "no"]
        for row in rows
    ]
    mean = geometric_mean(row["times"] for row in rows)
    return [
        table(["scene", "usual build, CPU s", "`cmake/build-fast`, CPU s", "ratio", "same error"], cells),
        f"The geometric mean of the ratios is {mean:.2f}.",
    ]


def section_growth(rows):
    cells = [
        [
            row["series"],
            f"{row['x']:g} {row['unit']}",
            row["program"],
            f"{row['cpu']:.3f}",
            f"{row['start_up']:.3f}",
            f"{row['seconds']:.3f}",
            f"{row['samples']:.0f}" if row["samples"] else "-",
        ]
        for row in rows
    ]
    names = dict.fromkeys(row["series"] for row in rows)
    return [
        table(["with", "at", "program", "CPU s", "of these start and parsing", "elapsed s", "samples per pixel"], cells),
        "\n".join(f"![cost against {name}](pictures/benchmarks/growth_{name.replace(' ', '_')}.svg)" for name in names),
    ]

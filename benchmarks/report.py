# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The results as Markdown tables, with their goals. A section makes paragraphs of a part's rows."""

from benchmarks import suite
from benchmarks.front import geometric_mean
from benchmarks.reconstruction import PICTURES, compare
from benchmarks.sampler_report import section_allocation, section_found_lamps, section_threads
from benchmarks.tables import TITLES, Goal, both_sections, plots_of, ratio_goals, ratio_section, table


def goals_stock(comparisons):
    return ratio_goals(comparisons, "stock focal blur", 8)


def section_stock(comparisons):
    return [*ratio_section(comparisons, goals_stock(comparisons)), plots_of(comparisons, False)]


def goals_tilted(comparisons):
    return ratio_goals(comparisons, "the accumulation buffer", 10)


def section_tilted(comparisons):
    return [*ratio_section(comparisons, goals_tilted(comparisons)), plots_of(comparisons, True)]


def goals_display(found):
    where = " in large pictures"
    return [
        *ratio_goals(found["untilted"], "stock focal blur", 8, 4, where),
        *ratio_goals(found["tilted"], "the accumulation buffer", 8, 4, where),
    ]


def section_display(found):
    width, height, columns, rows = found["part"]
    return [
        f"The part of {width} by {height} pixels in the middle of pictures of {columns} by {rows}.",
        *both_sections(found, goals_display(found), plots=True),
    ]


def overview_display(results):
    return overview({"stock": results["display"]["untilted"], "tilted": results["display"]["tilted"]})


def goals_lamps(found):
    dim = {"dim": found["untilted"].get("dim", [])}
    return ratio_goals(dim, "stock focal blur", 6, where=" with lamps that are not brighter than white")


def section_lamps(found):
    return both_sections(found, goals_lamps(found))


def section_cycles(found):
    return [
        f"{found['version']}, on the CPU. CPU seconds for a picture of {suite.SCENES[0].title}, at the error that Cycles reaches with"
        " so many samples in each pixel; Cycles takes its best setting for that error.",
        table(
            ["samples of Cycles", "RMSE", "Cycles, CPU s", "tilt_lens, CPU s", "ratio"],
            [
                [
                    f"{line['target']}",
                    f"{line['rmse']:.4f}",
                    f"{line['cycles']:.2f}",
                    f"{line['tilt_lens']:.2f}" if line["tilt_lens"] else "-",
                    f"{line['ratio']:.1f}" if line["ratio"] else "not reached",
                ]
                for line in found["lines"]
            ],
        ),
    ]


def goals_preview(rows):
    worst = max(row["cpu"] for row in rows)
    return [Goal("CPU seconds of the gallery's town at 1280 by 720 with `blur_samples 1`", "at most 3", f"{worst:.1f}", worst <= 3.0)]


def section_preview(rows):
    cells = [[TITLES[row["scene"]], f"{row['cpu']:.2f}", f"{row['cpu'] - row['rays']:.2f}", f"{row['rays']:.2f}"] for row in rows]
    return [
        table(["scene, 1280 by 720", "CPU s with `blur_samples 1`", "of these start and parsing", "rays and reconstruction"], cells),
        *[goal.sentence() for goal in goals_preview(rows)],
    ]


def section_reading(rows):
    cells = [[TITLES[row["scene"]], f"{row['stock']:.2f}", f"{row['ours']:.2f}", f"{row['stock']/row['ours']:.1f}"] for row in rows]
    mean = geometric_mean(row["stock"] / row["ours"] for row in rows)
    return [
        table(["scene", "the unpatched program, CPU s", "this program, CPU s", "ratio"], cells),
        f"The geometric mean of the ratios is {mean:.1f}.",
    ]


def denoise_ratios(rows):
    scenes = dict.fromkeys(row["scene"] for row in rows)
    return {scene: compare([row for row in rows if row["scene"] == scene]) for scene in scenes}


def goals_denoise(rows):
    found = denoise_ratios(rows)
    worst = min(ratio for ratios_of in found.values() for ratio in ratios_of.values())
    least = min(geometric_mean(ratios_of.values()) for ratios_of in found.values())
    what = "RMSE with `denoise off` over RMSE with `denoise on` after the same work"
    return [
        Goal(f"{what}, in each scene at each setting", "at least 1", f"{worst:.4f} at the least", worst >= 1.0),
        Goal(f"{what}, mean of each scene", "above 1", f"{least:.4f} at the least", least > 1.0),
    ]


def section_denoise(rows):
    found = denoise_ratios(rows)
    variances = list(dict.fromkeys(row["variance"] for row in rows))
    means = [geometric_mean(ratios_of[variance] for ratios_of in found.values()) for variance in variances]
    pairs = [(off, on) for off, on in zip(rows[::2], rows[1::2]) if off["variance"] == 1e-3]
    return [
        "RMSE with `denoise off` over RMSE with `denoise on` after the same work. The work is the number of instructions"
        " (callgrind) that `denoise off` takes with that `variance`, within the range of work that both settings cover;"
        " if there is none, that of one at its most work and of the other at its least."
        f" An error is that of {PICTURES} independent pictures.",
        table(
            ["scene", *[f"variance {variance:g}" for variance in variances], "geometric mean"],
            [
                [TITLES[scene], *[f"{ratio:.3f}" for ratio in ratios_of.values()], f"{geometric_mean(ratios_of.values()):.4f}"]
                for scene, ratios_of in found.items()
            ]
            + [["geometric mean", *[f"{mean:.3f}" for mean in means], f"{geometric_mean(means):.3f}"]],
        ),
        *[goal.sentence() for goal in goals_denoise(rows)],
        "Error at `variance 1/1000`, and the bias in it: the error that the mean of many such pictures keeps.",
        table(
            ["scene", "RMSE, `denoise off`", "bias", "RMSE, `denoise on`", "bias"],
            [[TITLES[off["scene"]], *[f"{row[name]:.4f}" for row in (off, on) for name in ("rmse", "bias")]] for off, on in pairs],
        ),
    ]


def goals_pan(lines):
    worst = max((line["times"] or float("inf") for line in lines), default=0)
    return [
        Goal(
            "CPU seconds of `tilt_lens` over those of `+A` in a picture without blur, at equal error",
            "at most 1.3",
            f"{worst:.2f} at the most",
            worst <= 1.3,
        )
    ]


def section_pan(lines):
    rows = [
        [
            TITLES[line["scene"]],
            f"`{line['target']}`",
            f"{line['rmse']:.4f}",
            f"{line['stock']:.3f}",
            f"{line['tilt_lens']:.3f}" if line["tilt_lens"] else "-",
            f"{line['times']:.2f}" if line["times"] else "not reached",
        ]
        for line in lines
    ]
    return [
        table(["scene", "error of", "RMSE", "pinhole, CPU s", "tilt_lens, CPU s", "ratio"], rows),
        *[goal.sentence() for goal in goals_pan(lines)],
    ]


def goals_tilt(rows):
    worst = max(row["instructions"] or row["times"] for row in rows)
    return [
        Goal(
            "Cost of a tilted picture over that of an untilted one with the same blur",
            "at most 1.05",
            f"{worst:.3f} at the most",
            worst <= 1.05,
        )
    ]


def section_tilt(rows):
    cells = [
        [
            row["setting"],
            f"{row['untilted']:.3f}",
            f"{row['tilted']:.3f}",
            f"{100*row['times'] - 100:+.1f} %",
            f"{100*row['instructions'] - 100:+.1f} %" if row["instructions"] else "-",
        ]
        for row in rows
    ]
    return [
        table(["setting", "untilted, CPU s", "tilted, CPU s", "more time", "more instructions"], cells),
        *[goal.sentence() for goal in goals_tilt(rows)],
    ]


def goals_instructions(rows):
    worst = max(row["more"] for row in rows)
    return [
        Goal(
            "Instructions of the patched program beyond those of the unpatched one, in scenes without `tilt_lens`",
            "at most +0.1 %",
            f"{100*worst:+.1f} % at the most",
            worst <= 0.001,
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
        Goal(
            "Share of camera and sampler in the instructions of a ray that costs little",
            "at most 8 %",
            f"{100*worst:.1f} % at the most",
            worst <= 0.08,
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
        Goal(
            "Camera and sampler with a lens of glass, against an ideal lens",
            "at most 3 times",
            f"{max(times):.1f} times at the most",
            max(times) <= 3,
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
        Goal(
            "Instructions of a sample over those of the program of before, in each scene",
            "at most 0.85",
            f"{most:.2f} at the most",
            most <= 0.85,
        ),
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


def verdict(row):
    """If the reference's error is not small against V, pixels that are off say nothing."""
    if row["share"] <= 1.2 and row["beyond"] <= 0.05:
        return "yes"
    if row["share"] <= 1.2 and row["reference_mse"] > 0.25 * row["variance"]:
        return f"MSE yes; pixels unknown, the reference's own MSE is {row['reference_mse']/row['variance']:.1f} V"
    return "**no**"


def held(rows, where=""):
    good = sum(verdict(row) == "yes" for row in rows)
    went_on = [row for row in rows if row["more"]]
    thrifty = sum(row["share_of_more"] >= 0.25 for row in went_on)
    return [
        Goal(
            f"Pictures with `variance V` whose MSE is at most 1.2 V and of whose pixels at most 5 % are off by more than"
            f" 2 sqrt(V){where}",
            f"all {len(rows)}",
            f"{good}",
            good == len(rows),
        ),
        Goal(
            f"Pictures in which the pixels with more than the least samples have an MSE of at least V/4, so that no rays"
            f" are wasted{where}",
            f"all {len(went_on)}",
            f"{thrifty}",
            thrifty == len(went_on),
        ),
        *told(rows, where),
    ]


def told(rows, where):
    ratios_of = [row["estimated"] / row["true"] for row in rows if row.get("true")]
    good = sum(0.8 <= ratio <= 1.2 for ratio in ratios_of)
    return (
        [
            Goal(
                f"Pictures whose estimated standard error is 0.8 to 1.2 times the true one{where}",
                f"all {len(ratios_of)}",
                f"{good}; {min(ratios_of):.2f} to {max(ratios_of):.2f}",
                good == len(ratios_of),
            )
        ]
        if ratios_of
        else []
    )


def goals_contract(rows):
    return held(rows)


def goals_crops(rows):
    return held(rows, ", parts of large pictures")


def contract_table(rows, goals_of):
    cells = [
        [
            TITLES[row["scene"]] + (", tilted" if row["tilted"] else ""),
            f"{row['variance']:g}",
            f"{row['share']:.2f}",
            f"{100*row['beyond']:.1f} %",
            f"{row['samples'] or 0:.0f}",
            verdict(row),
            f"{row['share_of_more']:.2f} of {100*row['more']:.0f} %" if row["more"] else "-",
            f"{row['estimated']/row['true']:.2f}" if row.get("true") else "-",
        ]
        for row in rows
    ]
    return [
        table(
            [
                "scene",
                "V",
                "MSE/V",
                "pixels off by more than 2 sqrt(V)",
                "samples per pixel",
                "holds",
                "MSE/V of the pixels with more than the least samples, and their share",
                "estimated over true standard error",
            ],
            cells,
        ),
        *[goal.sentence() for goal in goals_of],
    ]


def section_contract(rows):
    return contract_table(rows, goals_contract(rows))


def section_crops(rows):
    return contract_table(rows, goals_crops(rows))


def section_ablation(found):
    cells = []
    for row in found["rules"]:
        (ratio, scene), (error, scene_of_error), (beyond, scene_of_beyond) = row["ratio"], row["error"], row["beyond"]
        cells.append(
            [
                row["rule"] or "*(nothing)*",
                f"{row['section'] or ''}",
                f"`{row['settings']}`" if row["settings"] else "",
                *[f"{mean:.2f}" for mean in row["means"]],
                f"{ratio:.2f} {scene}" if row["settings"] else "",
                f"{error:.1f} {scene_of_error}",
                f"{100*beyond:.0f} % {scene_of_beyond}",
            ]
        )
    width, height = found["size"]
    return [
        table(
            [
                "without",
                "section",
                "settings",
                "work, `denoise off`",
                "work, `denoise on`",
                "worst scene",
                "greatest MSE/V",
                "most pixels beyond 2 sqrt(V)",
            ],
            cells,
        ),
        f"Pictures of {width} by {height} with {found['samples']} recorded samples of each pixel.",
    ]


SECTIONS = {
    "stock": ("Untilted: stock focal blur's CPU seconds over those of tilt_lens", section_stock),
    "tilted": ("Tilted: the accumulation buffer's CPU seconds over those of tilt_lens", section_tilted),
    "display": ("At the size that people look at", section_display),
    "lamps": ("Small lamps, brighter than white and not", section_lamps),
    "cycles": ("Cycles of Blender", section_cycles),
    "preview": ("The quickest picture", section_preview),
    "reading": ("What reading a scene costs", section_reading),
    "denoise": ("What the reconstruction brings", section_denoise),
    "pan": ("Pictures without blur, against a pinhole's anti-aliasing", section_pan),
    "tilt": ("What a tilt costs at equal blur", section_tilt),
    "instructions": ("Instructions of scenes without tilt_lens", section_instructions),
    "camera": ("What camera and sampler take of a ray", section_camera),
    "glass": ("What a lens of glass takes of a ray", section_glass),
    "samples": ("What a sample costs with all its rays", section_samples),
    "loops": ("Inner loops", section_loops),
    "growth": ("How cost grows", section_growth),
    "contract": ("Whether `variance V` is kept", section_contract),
    "crops": ("Whether `variance V` is kept in large pictures", section_crops),
    "builds": ("The program of `cmake/build-fast`", section_builds),
    "speedups": ("What the speedups are worth", section_speedups),
    "found_lamps": ("Lamps that must be found", section_found_lamps),
    "allocation": ("The allocation of rays, beside uniform sampling and perfect knowledge", section_allocation),
    "threads": ("One thread and several", section_threads),
    "ablation": ("What each rule of the sampler is worth", section_ablation),
}
GOALS = {
    "contract": goals_contract,
    "crops": goals_crops,
    "display": goals_display,
    "lamps": goals_lamps,
    "preview": goals_preview,
    "stock": goals_stock,
    "tilted": goals_tilted,
    "denoise": goals_denoise,
    "pan": goals_pan,
    "tilt": goals_tilt,
    "instructions": goals_instructions,
    "camera": goals_camera,
    "samples": goals_samples,
    "glass": goals_glass,
}


def section(part, rows):
    return "\n\n".join(SECTIONS[part][1](rows))


def text(results):
    return "\n\n".join(f"### {title}\n\n{section(part, results[part])}" for part, (title, _) in SECTIONS.items() if results.get(part))


def range_of(lines):
    found = [line["ratio"] for line in lines if line["ratio"]]
    return f"{geometric_mean(found):.1f} ({min(found):.1f} to {max(found):.1f})" if found else "-"


def overview(results):
    untilted, tilted = results["stock"], results["tilted"]
    rows = [[TITLES[scene], range_of(untilted[scene]), range_of(tilted[scene])] for scene in untilted if scene in tilted]
    together = [[line for lines in comparisons.values() for line in lines] for comparisons in (untilted, tilted)]
    rows.append(["all", *map(range_of, together)])
    return table(["scene", "untilted: stock focal blur over `tilt_lens`", "tilted: accumulation buffer over `tilt_lens`"], rows)


def goals(results):
    found = [goal for part, function in GOALS.items() if results.get(part) for goal in function(results[part])]
    return table(
        ["figure", "goal", "measured", "verdict"],
        [[goal.figure, goal.wanted, goal.measured, goal.verdict if goal.reached else f"**{goal.verdict}**"] for goal in found],
    )

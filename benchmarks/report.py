# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The results as Markdown tables, with their goals. A section makes paragraphs of a part's rows."""

from benchmarks import suite
from benchmarks.contract_report import goals_contract, goals_crops, section_ablation, section_contract, section_crops
from benchmarks.cost_report import (
    goals_camera,
    goals_glass,
    goals_instructions,
    goals_samples,
    section_builds,
    section_camera,
    section_glass,
    section_growth,
    section_instructions,
    section_loops,
    section_samples,
    section_speedups,
)
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
        Goal.of_greatest(
            "CPU seconds of `tilt_lens` over those of `+A` in a picture without blur, at equal error", worst, 1.3, "1.3", f"{worst:.2f}"
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
        Goal.of_greatest("Cost of a tilted picture over that of an untilted one with the same blur", worst, 1.05, "1.05", f"{worst:.3f}")
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

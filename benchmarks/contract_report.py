# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Tables of the contract on error, and of the ablation."""

from benchmarks import ablation
from benchmarks.tables import TITLES, Goal, table


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


def grown(row):
    """MSE/V of the pixels with more than the least samples, if all errors grew alike until 5 % of the pixels were off."""
    return row["share_of_more"] * row["room"]


def remarks(rows):
    noise = max(row["reference_mse"] / max(1e-12, row["share"] * row["variance"]) for row in rows)
    went_on = [row for row in rows if row["more"]]
    return (
        f"The reference's own MSE is at most {noise:.2f} of an MSE above. If errors grew until 5 % of the pixels were off, "
        f"{sum(grown(row) >= 0.5 for row in went_on)} of {len(went_on)} pictures would have at least V/2 in the pixels with more than the"
        " least samples."
    )


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
            f"{grown(row):.2f}" if row["more"] else "-",
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
                "the same if errors grew until 5 % of the pixels were off",
                "estimated over true standard error",
            ],
            cells,
        ),
        remarks(rows),
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
                *["-" if mean is None else f"{mean:.2f}" for mean in row["means"]],
                f"{ratio:.2f} {scene}" if row["settings"] else "",
                f"{error:.1f} {scene_of_error}",
                f"{100*beyond:.0f} % {scene_of_beyond}",
            ]
        )
    width, height = found["size"]
    part, large = (f"{columns} by {rows}" for columns, rows in (ablation.PART, ablation.LARGE))
    return [
        table(
            [
                "without",
                "section",
                "settings",
                "work, `denoise off`",
                "work, `denoise on`",
                "the same, parts of large pictures",
                "worst scene",
                "greatest MSE/V",
                "most pixels beyond 2 sqrt(V)",
            ],
            cells,
        ),
        f"Pictures of {width} by {height}, and parts of {part} of pictures of {large}, with {found['samples']} recorded samples of each pixel.",
    ]

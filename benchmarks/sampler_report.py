# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later

from benchmarks import allocation, found_lamps, threads
from benchmarks.front import geometric_mean
from benchmarks.tables import TITLES, Goal, table


def percent(share, digits=1):
    return f"{100*share:.{digits}f} %"


def lamps_told(rows):
    return [row["estimated"] / row["true"] for row in rows if row["true"]]


def goals_found_lamps(rows):
    works = [found_lamps.work(row) for row in rows]
    discs = [row["dark"] for row in rows if row["disc_pixels"]]
    kept, told = [row["kept"] for row in rows], lamps_told(rows)
    return [
        Goal.of_greatest(
            "MSE times rays over that of fixed sampling with as many rays, in each scene with lamps to be found",
            max(works),
            1.0,
            "1",
            f"{max(works):.2f}",
        ),
        Goal(
            "Light of lamps to be found that is kept, in each scene",
            "at least 95 %",
            f"{percent(min(kept))} at the least",
            min(kept) >= 0.95,
        ),
        Goal.of_greatest(
            "Pixels of their discs with less than 70 % of their light, in each scene", max(discs), 0.01, "1 %", percent(max(discs))
        ),
        Goal(
            "Reported standard error over the true one there",
            "0.8 to 1.4",
            f"{min(told):.2f} to {max(told):.2f}",
            0.8 <= min(told) and max(told) <= 1.4,
        ),
    ]


def section_found_lamps(rows):
    titles = {scene.name: scene.title for scene in found_lamps.SCENES}
    cells = [
        [
            titles[row["scene"]] + (f", radius {row['radius']}" if row["radius"] else ""),
            f"{row['samples']:.1f}",
            f"{row['mse']:.2g}",
            f"{found_lamps.work(row):.2f}",
            f"{percent(row['kept'])} ({percent(row['fixed_kept'])})",
            f"{percent(row['dark'])} ({percent(row['fixed_dark'])})" if row["disc_pixels"] else "-",
            f"{row['estimated']/row['true']:.2f}" if row["true"] else "-",
            f"{row['reference_mse']/min(row['mse'], row['fixed_mse']):.2f}",
        ]
        for row in rows
    ]
    cells.append(["geometric mean", "", "", f"{geometric_mean(map(found_lamps.work, rows)):.2f}", "", "", "", ""])
    width, height = rows[0]["size"]
    return [
        f"Pictures of {width} by {height} with the default settings, {len(found_lamps.SEEDS)} seeds. The work is MSE times rays, over that of"
        " fixed sampling with as many rays (the nearest multiple of four); in brackets is what fixed sampling has. The last column is"
        " the reference's own MSE over the lesser of both.",
        table(
            [
                "scene",
                "rays a pixel",
                "MSE",
                "work",
                "light kept",
                "dark pixels of discs",
                "reported over true standard error",
                "the reference's part",
            ],
            cells,
        ),
        *[goal.sentence() for goal in goals_found_lamps(rows)],
    ]


def goals_allocation(rows):
    large = [row for row in rows if tuple(row["whole"]) == allocation.LARGE]
    by_scene = [
        geometric_mean(row["over_uniform"] for row in large if row["scene"] == name)
        for name in dict.fromkeys(row["scene"] for row in large)
    ]
    mean, worst = geometric_mean(by_scene), max(by_scene)
    what = "MSE over that of uniform sampling with as many rays, parts of pictures of 1000 by 750"
    return [
        Goal(f"{what}, geometric mean", "at most 0.85", f"{mean:.2f}", mean <= 0.85),
        Goal.of_greatest(f"{what}, in each scene", worst, 1.0, "1", f"{worst:.2f}"),
    ]


def section_allocation(rows):
    sizes = dict.fromkeys(tuple(row["whole"]) for row in rows)
    cells = []
    for size in sizes:
        of_size = [row for row in rows if tuple(row["whole"]) == size]
        groups = {TITLES[name]: [row for row in of_size if row["scene"] == name] for name in dict.fromkeys(row["scene"] for row in of_size)}
        for title, found in [*groups.items(), ("geometric mean", of_size)]:
            uniform, ideal = (geometric_mean(row[name] for row in found) for name in ("over_uniform", "over_ideal"))
            rays = [row["samples"] for row in found]
            cells.append(
                [
                    title,
                    f"{size[0]} by {size[1]}",
                    f"{min(rays):.0f} to {max(rays):.0f}",
                    f"{uniform:.2f}",
                    f"{uniform/ideal:.2f}",
                    f"{ideal:.2f}",
                    f"{max(row['reference_mse']/row['mse'] for row in found):.2f}",
                ]
            )
    return [
        f"Groups have {allocation.GROUP} by {allocation.GROUP} pixels; {allocation.PICTURES} pictures of each setting. Half of them choose the"
        " ideal numbers, so chance makes them worse than they could be. The last column is the reference's own MSE over the least MSE of a row.",
        table(
            [
                "scene",
                "picture",
                "rays a pixel",
                "MSE over that of uniform sampling",
                "the same, ideal",
                "MSE over the ideal",
                "the reference's part",
            ],
            cells,
        ),
        *[goal.sentence() for goal in goals_allocation(rows)],
    ]


def goals_threads(rows):
    traced, goals = rows["traced"], []
    for count, wanted in ((2, 0.97), (16, 0.95)):
        found = [threads.efficiency(traced, row) for row in traced if row["threads"] == count]
        if found:
            what = f"Speed of {count} threads over {count} times that of one, in each scene"
            goals.append(Goal.of_least(what, min(found), wanted, f"{min(found):.2f}"))
    for count, wanted in ((16, 0.95), (64, 0.9)):
        found = [row["busy"] for row in rows["slept"] if row["threads"] == count]
        if found:
            what = f"Share of the time that {count} threads are busy, if they sleep instead of tracing, in each scene"
            goals.append(Goal.of_least(what, min(found), wanted, f"{min(found):.3f}"))
    return goals


def section_threads(rows):
    width, height = rows["traced"][0]["size"]
    cells = [
        [
            TITLES[row["scene"]],
            f"{row['threads']}",
            f"{row['wall']:.2f}",
            f"{row['cpu']:.2f}",
            f"{threads.efficiency(rows['traced'], row):.2f}",
            percent(row["waited"]),
            f"{row['run']:.2f}",
            percent(row["idle"]),
        ]
        for row in rows["traced"]
    ]
    names = dict.fromkeys(row["scene"] for row in rows["slept"])
    busy = [[TITLES[name], *[f"{row['busy']:.3f}" for row in rows["slept"] if row["scene"] == name]] for name in names]
    return [
        f"Pictures of {width} by {height}, medians of {threads.REPETITIONS}.",
        table(
            [
                "scene",
                "threads",
                "tracing, s",
                "tracing, CPU s",
                "speed over that of one thread and their number",
                "share that each thread waited",
                "whole run, s",
                "of it processors idle",
            ],
            cells,
        ),
        "More threads than this machine has processors: share of the time that they are busy, if they sleep instead of tracing. "
        f"Pictures of {threads.SIZE[0]} by {threads.SIZE[1]}; each pixel takes about as many samples as it took in the real picture.",
        table(["scene", *[f"{count} threads" for count in threads.SLEEPERS]], busy),
        *[goal.sentence() for goal in goals_threads(rows)],
    ]

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Random and extreme cameras, compared with 50 digits."""

from tests.stress import results

RANDOM, SHARD, EXTREME = 10_000_000, 100_000, 20_000
SETS = (
    "corners",
    "tilt",
    "parallel",
    "through_view",
    "behind",
    "far_focus",
    "far_camera",
    "farther_camera",
    "scale",
    "unit",
    "aperture",
    "film",
    "narrow",
    "odd_numbers",
    "several",
)
SPREADS = (
    "ulps",
    "well_posed",
    "pixels",
    "narrow_pixels",
    "narrow_rounded",
    "narrow_roundings",
    "reach_pixels",
    "origin",
    "obvious_pixels",
)
COUNTS = ("cameras", "refused", "rays", "broken", "reach_film", "obvious_broken")


def merge(tallies):
    total = {name: sum(t[name] for t in tallies) for name in COUNTS}
    for name in SPREADS:
        powers = {}
        for t in tallies:
            for power, count in t[name]["by_power"].items():
                powers[power] = powers.get(power, 0) + count
        worst = [t[name]["worst"] for t in tallies]
        total[name] = {"count": sum(t[name]["count"] for t in tallies), "by_power": powers, "worst": None if None in worst else max(worst)}
    total["refusals"] = {}
    for t in tallies:
        for words, count in t["refusals"].items():
            total["refusals"][words.strip()] = total["refusals"].get(words.strip(), 0) + count
    return total


def measure(setup, cameras=RANDOM, extreme=EXTREME, shard=SHARD):
    work, tool = setup.work("rays"), setup.tool("stress_rays")
    jobs = [("random", min(shard, cameras), 1000 + i) for i in range(max(1, cameras // shard))]
    jobs += [(name, extreme, 1) for name in SETS]

    def run(job):
        name, count, seed = job
        return results.once(
            work,
            f"{name}-{count}-{seed}",
            [tool],
            lambda: results.output([tool, name, count, seed]),
            lambda tally: faults({name: merge([tally])}),
        )

    tallies = results.in_parallel(setup.jobs, run, jobs)
    result = {"random": merge([t for j, t in zip(jobs, tallies) if j[0] == "random"])}
    for job, tally in zip(jobs, tallies):
        if job[0] != "random":
            result[job[0]] = merge([tally])
    return result


def faults(result):
    found = []
    for name, tally in result.items():
        if tally["broken"]:
            found.append(f"{name}: {tally['broken']} rays are not finite or have no direction")
        if not tally["well_posed"]["worst"] <= 4.0:
            found.append(f"{name}: {tally['well_posed']['worst']} ulp in a well-posed camera")
        if tally["pixels"]["worst"] is None or not tally["pixels"]["worst"] <= 1e-6:
            found.append(f"{name}: {tally['pixels']['worst']} pixels")
        if tally["narrow_roundings"]["worst"] is None or not tally["narrow_roundings"]["worst"] <= 4.0:
            found.append(f"{name}: a narrow picture's ray off by {tally['narrow_roundings']['worst']} roundings")
        if name == "behind" and not tally["obvious_pixels"]["by_power"].get("30"):
            found.append("behind: the reversed rays of the obvious formula are not seen")
        if name == "random" and tally["refused"]:
            found.append(f"{name}: {tally['refused']} cameras refused")
    return found

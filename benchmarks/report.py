# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The results as tables in Markdown and as CSV."""

import csv
import pathlib
import re

from benchmarks import suite
from benchmarks.front import geometric_mean
from benchmarks.reconstruction import PICTURES, compare

COLUMNS = ("program", "scene", "tilted", "setting", "cpu", "start_up", "runs", "rmse", "mean", "samples",
           "samples_99", "samples_most")
BEGIN, END = "<!-- begin of what benchmarks/run wrote -->", "<!-- end of what benchmarks/run wrote -->"
TITLES = {scene.name: scene.title for scene in suite.SCENES} | {"wall": "a textured wall"}


def write_csv(path, rows, columns=None):
    columns = columns or list(rows[0])
    with path.open("w", newline="") as out:
        writer = csv.DictWriter(out, columns, extrasaction="ignore", lineterminator="\n")
        writer.writeheader()
        for row in rows:
            writer.writerow({name: f"{value:.6g}" if isinstance(value, float) else value
                             for name, value in row.items() if name in columns})


def table(header, rows):
    lines = ["| " + " | ".join(header) + " |", "| " + " | ".join(["---"] * len(header)) + " |"]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows])


def ratio_cell(line):
    if line["ratio"] is None:
        return f"not reached ({line['rmse']:.4f})"
    least = "at least " if line.get("at_least") else ""
    return f"{least}{line['ratio']:.1f} ({line['rmse']:.4f})"


def ratios(comparisons):
    """A table of scenes by errors and its last line, the geometric mean of each column."""
    targets = sorted({line["target"] for lines in comparisons.values() for line in lines})
    rows = [[TITLES[scene], *[ratio_cell(line) for line in lines]] for scene, lines in comparisons.items()]
    means = [geometric_mean(line["ratio"] for lines in comparisons.values() for line in lines
                            if line["target"] == target and line["ratio"]) for target in targets]
    rows.append(["geometric mean", *[f"{mean:.1f}" if mean else "-" for mean in means]])
    return table(["scene", *[f"as stock with {target}" for target in targets]], rows)


def summary(comparisons, wanted):
    """The geometric mean of all and the worst, in words."""
    lines = [(line["ratio"], scene, line) for scene, found in comparisons.items() for line in found if line["ratio"]]
    missing = sum(line["ratio"] is None for found in comparisons.values() for line in found)
    if not lines:
        return "Nothing was compared."
    mean, worst = geometric_mean(ratio for ratio, _, _ in lines), min(lines, key=lambda entry: entry[0])
    verdict = "reached" if mean >= wanted else "missed"
    text = (f"Geometric mean of all **{mean:.1f}** (aimed at: {wanted}; {verdict}); worst **{worst[0]:.2f}** "
            f"({TITLES[worst[1]]}, at an RMSE of {worst[2]['rmse']:.4f}).")
    return text + (f" {missing} errors were not reached by any setting tried." if missing else "")


def section_stock(results):
    return ["### Untilted: stock focal blur's CPU seconds over ours", "", ratios(results["stock"]), "",
            summary(results["stock"], 8), ""]


def section_tilted(results):
    return ["### Tilted: the accumulation buffer's CPU seconds over ours", "", ratios(results["tilted"]), "",
            summary(results["tilted"], 10), ""]


def section_denoise(results):
    rows = results["denoise"]
    scenes = list(dict.fromkeys(row["scene"] for row in rows))
    ratios_of = {scene: compare([row for row in rows if row["scene"] == scene]) for scene in scenes}
    variances = list(dict.fromkeys(row["variance"] for row in rows))
    means = [geometric_mean(ratios_of[scene][variance] for scene in scenes) for variance in variances]
    worst = min(ratio for found in ratios_of.values() for ratio in found.values())
    of_scene = {scene: geometric_mean(ratios_of[scene].values()) for scene in scenes}
    least = min(of_scene.values())
    pairs = [(off, on) for off, on in zip(rows[::2], rows[1::2]) if off["variance"] == 1e-3]
    return ["### Reconstruction: RMSE with `denoise off` over that with `denoise on` after the same work", "",
            "Work is instructions (callgrind): as many as `denoise off` takes with that `variance`, where both have settings"
            f" that take more and such that take less. Errors are of {PICTURES} independent pictures.", "",
            table(["scene", *[f"variance {variance:g}" for variance in variances], "geometric mean"],
                  [[TITLES[scene], *[f"{ratio:.3f}" for ratio in ratios_of[scene].values()], f"{of_scene[scene]:.4f}"]
                   for scene in scenes]
                  + [["geometric mean", *[f"{mean:.3f}" for mean in means], f"{geometric_mean(means):.3f}"]]), "",
            f"Aimed at: nowhere below 1; worst {worst:.4f}, {'reached' if worst >= 1.0 else 'missed'}. And above 1 on the mean of"
            f" every scene; least {least:.4f}, {'reached' if least > 1.0 else 'missed'}.", "",
            "What remains however many such pictures are averaged, `variance 1/1000`:", "",
            table(["scene", "RMSE, `denoise off`", "of it bias", "RMSE, `denoise on`", "of it bias"],
                  [[TITLES[off["scene"]], *[f"{row[name]:.4f}" for row in (off, on) for name in ("rmse", "bias")]]
                   for off, on in pairs]), ""]


def section_pan(results):
    rows = [[TITLES[line["scene"]], f"`{line['target']}`", f"{line['rmse']:.4f}", f"{line['stock']:.3f}",
             f"{line['tilt_lens']:.3f}" if line["tilt_lens"] else "-",
             f"{line['times']:.2f}" if line["times"] else "not reached"] for line in results["pan"]]
    worst = max((line["times"] or float("inf") for line in results["pan"]), default=0)
    return ["### All sharp: tilt_lens against a pinhole's anti-aliasing", "",
            table(["scene", "error of", "RMSE", "pinhole, s", "tilt_lens, s", "times"], rows), "",
            f"Aimed at: at most 1.3 times; worst {worst:.2f}, {'reached' if worst <= 1.3 else 'missed'}.", ""]


def section_tilt(results):
    rows = [[row["setting"], f"{row['untilted']:.3f}", f"{row['tilted']:.3f}", f"{100*row['times'] - 100:+.1f} %",
             f"{100*row['instructions'] - 100:+.1f} %" if row["instructions"] else "-"] for row in results["tilt"]]
    worst = max(row["instructions"] or row["times"] for row in results["tilt"])
    return ["### What a tilt costs, at equal blur", "",
            table(["setting", "untilted, s", "tilted, s", "more", "more instructions"], rows), "",
            f"Aimed at: within 5 %; {'reached' if worst <= 1.05 else 'missed'}.", ""]


def section_instructions(results):
    rows = [[row["case"], f"{row['unpatched']:,}", f"{row['patched']:,}", f"{100*row['more']:+.3f} %"]
            for row in results["instructions"]]
    worst = max(row["more"] for row in results["instructions"])
    return ["### Scenes without tilt_lens: instructions (callgrind)", "",
            table(["scene", "unpatched build", "patched build", "more"], rows), "",
            f"Aimed at: at most +0.1 %; {'reached' if worst <= 0.001 else 'missed'}.", ""]


def section_camera(results):
    rows = [[TITLES[row["scene"]], f"{row['instructions']:,.0f}", f"{row['camera']:,.0f}",
             f"{100*row['share']:.1f} %", f"{100*row['share_judged']:.1f} %"] for row in results["camera"]]
    worst = max(row[name] for row in results["camera"] for name in ("share", "share_judged"))
    return ["### What camera and sampler take of a ray: instructions (callgrind)", "",
            table(["scene", "instructions a ray, 64 rays everywhere", "of it camera and sampler", "share",
                   "share, variance 1/10000"], rows), "",
            f"Aimed at: at most 3 %; worst {100*worst:.1f} %, {'reached' if worst <= 0.03 else 'missed'}.", ""]


def section_loops(results):
    return ["### Inner loops", "", table(["what", "ns a call"], [[name, f"{ns:.1f}"] for name, ns in results["loops"]]), ""]


def section_builds(results):
    rows = [[TITLES[row["scene"]], f"{row['usual']:.3f}", f"{row['fast']:.3f}", f"{row['times']:.2f}",
             "yes" if row["same"] else "no"] for row in results["builds"]]
    mean = geometric_mean(row["times"] for row in results["builds"])
    return ["### The program of `cmake/build-fast`: CPU seconds for the same rays", "",
            table(["scene", "usual, s", "fast, s", "times", "same error"], rows), "",
            f"Geometric mean **{mean:.2f}**.", ""]


def section_growth(results):
    rows = [[row["series"], f"{row['x']:g} {row['unit']}", row["program"], f"{row['cpu']:.3f}",
             f"{row['start_up']:.3f}", f"{row['seconds']:.3f}", f"{row['samples']:.0f}" if row["samples"] else "-"]
            for row in results["growth"]]
    return ["### How cost grows", "", table(
        ["with", "at", "program", "CPU s", "of it start and parsing", "seconds by the clock", "samples a pixel"], rows), ""]


def verdict(row):
    """Whether the variance asked for was got. The reference's own error is taken off a mean, but a pixel that is
    off may be off by the reference: where that is not small against V, their number says nothing."""
    if row["share"] <= 1.2 and row["beyond"] <= 0.05:
        return "yes"
    if row["share"] <= 1.2 and row["reference_mse"] > 0.25*row["variance"]:
        return f"MSE yes; pixels unknown, the reference's own MSE is {row['reference_mse']/row['variance']:.1f} V"
    return "**no**"


def section_contract(results):
    rows = [[TITLES[row["scene"]] + (", tilted" if row["tilted"] else ""), f"{row['variance']:g}",
             f"{row['share']:.2f}", f"{100*row['beyond']:.1f} %", f"{row['samples'] or 0:.0f}", verdict(row),
             f"{row['share_of_more']:.2f} of {100*row['more']:.0f} %" if row["more"] else "-"]
            for row in results["contract"]]
    held = sum(verdict(row) == "yes" for row in results["contract"])
    went_on = [row for row in results["contract"] if row["more"]]
    thrifty = sum(row["share_of_more"] >= 0.25 for row in went_on)
    return ["### Is `variance V` honoured", "",
            table(["scene", "V", "MSE/V", "pixels off by more than 2 sqrt(V)", "samples a pixel", "holds",
                   "MSE/V of pixels with more than the least samples"], rows), "",
            f"Aimed at: MSE at most 1.2 V, at most 5 % of the pixels; holds in {held} of {len(rows)} cases. And that no ray is"
            " wasted: at least V/4 over the pixels that took more than the least number of samples; so in"
            f" {thrifty} of {len(went_on)}.", ""]


SECTIONS = [("stock", section_stock), ("tilted", section_tilted), ("denoise", section_denoise), ("pan", section_pan),
            ("tilt", section_tilt), ("instructions", section_instructions), ("camera", section_camera), ("loops", section_loops),
            ("growth", section_growth), ("contract", section_contract), ("builds", section_builds)]


def machine():
    found = re.search(r"^model name\s*:\s*(.+)$", pathlib.Path("/proc/cpuinfo").read_text(), re.M)
    return found.group(1) if found else "an unnamed processor"


def section_plots(names):
    """All runs of each scene, the fronts as lines; growth."""
    return ["### Plots", "", "Points are runs, lines join the best of each way. All numbers are in "
            "[runs.csv](pictures/benchmarks/runs.csv).", "",
            *[f"![{name.removesuffix('.svg').replace('_', ' ')}](pictures/benchmarks/{name})" for name in names], ""]


def text(results, quick, plots=()):
    head = [f"Made by `benchmarks/run{' --quick' if quick else ''}` on {machine()}, with {results['version']}.", ""]
    lines = [line for name, section in SECTIONS if results.get(name) for line in section(results)]
    return "\n".join(head + lines + (section_plots(plots) if plots else []))


def update_document(path, made):
    """Puts the text between the two marks."""
    before, rest = path.read_text().split(BEGIN)
    path.write_text(f"{before}{BEGIN}\n\n{made}\n{END}{rest.split(END)[1]}")

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Tables, goals, and ratios of CPU seconds at equal error."""

import csv
import dataclasses
import pathlib
import re

from benchmarks import suite
from benchmarks.front import geometric_mean

COLUMNS = ("program", "scene", "tilted", "setting", "cpu", "start_up", "runs", "rmse", "mean", "samples", "samples_99", "samples_most")
TITLES = {scene.name: scene.title for scene in suite.SCENES} | suite.DISPLAY | {"wall": "a textured wall"}


@dataclasses.dataclass(frozen=True)
class Goal:
    figure: str
    wanted: str
    measured: str
    reached: bool

    @property
    def verdict(self):
        return "reached" if self.reached else "missed"

    @classmethod
    def of_greatest(cls, figure, greatest, limit, wanted, measured):
        return cls(figure, f"at most {wanted}", f"{measured} at the most", greatest <= limit)

    @classmethod
    def of_least(cls, figure, least, limit, measured):
        return cls(figure, f"at least {limit}", f"{measured} at the least", least >= limit)

    def sentence(self):
        return f"Goal: {self.figure}: {self.wanted}. Measured: {self.measured} ({self.verdict})."


def write_csv(path, rows):
    with path.open("w", newline="") as out:
        writer = csv.DictWriter(out, COLUMNS, extrasaction="ignore", lineterminator="\n")
        writer.writeheader()
        for row in rows:
            writer.writerow({name: f"{value:.6g}" if isinstance(value, float) else value for name, value in row.items() if name in COLUMNS})


def machine():
    found = re.search(r"^model name\s*:\s*(.+)$", pathlib.Path("/proc/cpuinfo").read_text(), re.M)
    return found.group(1) if found else "an unnamed processor"


def table(header, rows):
    lines = ["| " + " | ".join(header) + " |", "| " + " | ".join(["---"] * len(header)) + " |"]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows])


def ratio_cell(line):
    if line["ratio"] is None:
        return f"not reached ({line['rmse']:.4f})"
    least = "at least " if line.get("at_least") else ""
    return f"{least}{line['ratio']:.1f} ({line['rmse']:.4f})"


def ratios(comparisons):
    targets = sorted({line["target"] for lines in comparisons.values() for line in lines})
    cells = [{line["target"]: ratio_cell(line) for line in lines} for lines in comparisons.values()]
    rows = [
        [TITLES[scene], *[found.get(target, "not compared") for target in targets], f"{max(line['noise'] for line in lines):.2f}"]
        for (scene, lines), found in zip(comparisons.items(), cells)
    ]
    means = [
        geometric_mean(line["ratio"] for lines in comparisons.values() for line in lines if line["target"] == target and line["ratio"])
        for target in targets
    ]
    rows.append(["geometric mean", *[f"{mean:.1f}" if mean else "-" for mean in means], ""])
    return table(["scene", *[f"error of stock with {target} samples" for target in targets], "the reference's part"], rows)


def found_ratios(comparisons):
    return [(line["ratio"], scene, line) for scene, found in comparisons.items() for line in found if line["ratio"]]


def ratio_goals(comparisons, other, wanted, least=None, where=""):
    found = [ratio for ratio, _, _ in found_ratios(comparisons)]
    if not found:
        return []
    what = f"CPU seconds of {other} over those of `tilt_lens` at equal error{where}"
    mean = geometric_mean(found)
    goals_of = [Goal(f"{what}, geometric mean", f"at least {wanted}", f"{mean:.1f}", mean >= wanted)]
    if least:
        missing = sum(not line["ratio"] for lines in comparisons.values() for line in lines)
        goals_of.append(
            Goal(
                f"{what}, in each scene at each error",
                f"at least {least}",
                f"{min(found):.2f} at the least" + (f", and {missing} errors not reached" if missing else ""),
                min(found) >= least and not missing,
            )
        )
    return goals_of


def ratio_section(comparisons, goals):
    found = found_ratios(comparisons)
    missing = sum(line["ratio"] is None for lines in comparisons.values() for line in lines)
    paragraphs = [ratios(comparisons), *[goal.sentence() for goal in goals]]
    if found:
        least, scene, line = min(found, key=lambda entry: entry[0])
        paragraphs.append(f"The least ratio is {least:.2f} ({TITLES[scene]}, at an RMSE of {line['rmse']:.4f}).")
    return paragraphs + ([f"{missing} errors were not reached with any setting tried."] if missing else [])


def plots_of(comparisons, tilted):
    return "\n".join(
        f"![{TITLES[scene]}{', tilted' if tilted else ''}: error against CPU time]"
        f"(pictures/benchmarks/{scene}{'_tilted' if tilted else ''}.svg)"
        for scene in comparisons
    )


def both_sections(found, goals_of, plots=False):
    paragraphs = []
    for tilted, (name, words) in enumerate(
        (
            ("untilted", "Untilted, CPU seconds of stock focal blur over those of `tilt_lens`:"),
            ("tilted", "Tilted, CPU seconds of the accumulation buffer over those of `tilt_lens`:"),
        )
    ):
        paragraphs += [words, *ratio_section(found[name], []), *([plots_of(found[name], tilted)] if plots else [])]
    return paragraphs + [goal.sentence() for goal in goals_of]

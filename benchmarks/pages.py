# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Keeps the results in docs/benchmarks, and shows them in the pages.

A part, such as `stock`, stands between the lines `<!-- benchmark: stock -->` and `<!-- end of benchmark -->` of exactly one page in docs/.
A new part needs a measuring module, its call in benchmark.py, a section in report.py, and a place in a page."""

import json
import re

from benchmarks import report, tables
from tools.repository import ROOT

DOCS = ROOT / "docs"
WIDTH = 360  # characters of a line of kept results: one row of a table
PLACE = re.compile(r"(?P<begin><!-- benchmark: (?P<name>\w+) -->\n).*?(?P<end><!-- end of benchmark -->)", re.DOTALL)
SUMMARIES = {
    "overview": (("stock", "tilted"), report.overview),
    "large": (("display",), report.overview_display),
    "goals": (tuple(report.GOALS), report.goals),
}


def compact(value, indent=""):
    line = json.dumps(value)
    if len(indent + line) <= WIDTH or not isinstance(value, (dict, list, tuple)):
        return line
    deeper = indent + " "
    if isinstance(value, dict):
        items, (begin, end) = [f"{json.dumps(key)}: {compact(item, deeper)}" for key, item in value.items()], "{}"
    else:
        items, (begin, end) = [compact(item, deeper) for item in value], "[]"
    return f"{begin}\n{deeper}" + f",\n{deeper}".join(items) + f"\n{indent}{end}"


def save(part, rows, program, docs=DOCS):
    folder = docs / "benchmarks"
    folder.mkdir(parents=True, exist_ok=True)
    kept = {"program": program, "machine": tables.machine(), "rows": rows}
    (folder / f"{part}.json").write_text(compact(kept) + "\n")


def load(docs=DOCS):
    return {path.stem: json.loads(path.read_text()) for path in sorted((docs / "benchmarks").glob("*.json"))}


def origin(parts):
    made = dict.fromkeys(f"{part['program']}, on {part['machine']}" for part in parts)
    return f"Measured with {'; and with '.join(made)}."


def block(name, kept):
    parts, write = SUMMARIES.get(name, ((name,), lambda rows: report.section(name, rows[name])))
    found = {part: kept[part] for part in parts if part in kept}
    if not found:
        return "\nNot measured yet.\n\n"
    made = write({part: stored["rows"] for part, stored in found.items()})
    return f"\n{made}\n\n{origin(found.values())}\n\n"


def faults(docs=DOCS):
    """Unknown parts, and parts not shown in exactly one place."""
    known = [*report.SECTIONS, *SUMMARIES]
    shown = [match["name"] for page in sorted(docs.glob("*.md")) for match in PLACE.finditer(page.read_text())]
    wrong = [f"a page has a place for {name}, which is no part of the benchmark" for name in shown if name not in known]
    return wrong + [f"{name} is shown in {shown.count(name)} places of the pages, not in one" for name in known if shown.count(name) != 1]


def written(page, kept):
    return PLACE.sub(lambda match: match["begin"] + block(match["name"], kept) + match["end"], page.read_text())


def update(docs=DOCS):
    wrong = faults(docs)
    if wrong:
        raise ValueError("\n".join(wrong))
    kept = load(docs)
    for page in sorted(docs.glob("*.md")):
        made = written(page, kept)
        if made != page.read_text():
            page.write_text(made)

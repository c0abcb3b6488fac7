# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Run time against error: CPU seconds of each way to a picture with a blurred lens, at equal error."""

import argparse
import pathlib
import shutil
import subprocess
import sys

from benchmarks import (
    ablation,
    accumulation,
    allocation,
    builds,
    camera_share,
    comparison,
    contract,
    cycles,
    found_lamps,
    glass_cost,
    growth,
    instructions,
    pages,
    pan_focus,
    plots,
    post,
    preview,
    reading,
    reconstruction,
    report,
    sample_cost,
    speedups,
    suite,
    tables,
    threads,
    tilt_cost,
    tilted,
    versus_stock,
)
from benchmarks.lab import Failed, Lab
from tools.repository import BUILD

PARTS = (
    "stock",
    "tilted",
    "display",
    "lamps",
    "cycles",
    "preview",
    "reading",
    "denoise",
    "pan",
    "tilt",
    "instructions",
    "samples",
    "glass",
    "loops",
    "growth",
    "contract",
    "crops",
    "builds",
    "speedups",
    "ablation",
    "found_lamps",
    "allocation",
    "threads",
)
NAMES = [*[scene.name for scene in suite.SCENES], *found_lamps.NAMES, *suite.DISPLAY]
# also shown in short form, at this size
SHORT = {
    "stock",
    "tilted",
    "contract",
    "display",
    "lamps",
    "cycles",
    "preview",
    "crops",
    "speedups",
    "ablation",
    "found_lamps",
    "allocation",
    "threads",
}


def chosen(text, names, what, parser):
    wanted = text.split(",")
    unknown = sorted(set(wanted) - set(names))
    if unknown:
        parser.error(f"no such {what}: {', '.join(unknown)} (there are {', '.join(names)})")
    return wanted


def arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--quick", action="store_true", help="fewer settings: some CPU minutes")
    parser.add_argument("--full", dest="quick", action="store_false", help="all settings (default)")
    parser.add_argument(
        "--scenes", help=f"of {', '.join(NAMES)}; all if not given, with --quick of the last nine only " + ",".join(suite.QUICK_DISPLAY)
    )
    parser.add_argument("--parts", help=f"of {', '.join(PARTS)}; all if not given, with --quick only stock,tilted")
    parser.add_argument("--ours", type=pathlib.Path, default=BUILD / "bin" / "povray", help="the patched program")
    parser.add_argument("--stock", type=pathlib.Path, default="/usr/bin/povray", help="the unpatched program")
    parser.add_argument(
        "--unpatched",
        type=pathlib.Path,
        default=BUILD / "stock" / "bin" / "povray",
        help="the same source built as ours, without the patches (for part instructions)",
    )
    parser.add_argument(
        "--fast",
        type=pathlib.Path,
        default=BUILD / "fast" / "bin" / "povray",
        help="the patched program as cmake/build-fast makes it (for part builds)",
    )
    parser.add_argument(
        "--without-speedups",
        type=pathlib.Path,
        default=BUILD / "without-speedups" / "bin" / "povray",
        help="the patched program of the preset without-speedups (for part speedups)",
    )
    parser.add_argument("--before", type=pathlib.Path, help="the patched program of before a change (for part samples)")
    parser.add_argument("--tools", type=pathlib.Path, default=BUILD / "tests" / "benchmarks" / "tools")
    parser.add_argument("--work", type=pathlib.Path, default=BUILD / "benchmarks")
    parser.add_argument("--fresh", action="store_true", help="measure again what an earlier run has measured (references are kept)")
    parser.add_argument(
        "--update-docs", action="store_true", help="keep the results in docs/benchmarks and show them in the pages of docs/"
    )
    parser.add_argument("--pages", action="store_true", help="measure nothing; write the pages from docs/benchmarks")
    args = parser.parse_args()
    usual = args.scenes is None
    args.scenes = NAMES if usual else chosen(args.scenes, NAMES, "scene", parser)
    args.display = [name for name in suite.DISPLAY if name in (suite.QUICK_DISPLAY if usual and args.quick else args.scenes)]
    args.parts = chosen(args.parts or ("stock,tilted" if args.quick else ",".join(PARTS)), PARTS, "part", parser)
    if args.update_docs and args.quick and not {*args.parts} <= SHORT:
        parser.error(f"--update-docs takes --quick only with --parts {','.join(sorted(SHORT))}")
    if args.update_docs and not usual and args.parts != ["display"]:
        parser.error("--update-docs takes all scenes, not --scenes, except with --parts display, whose tables name their scenes")
    if "display" in args.parts and not args.display:
        parser.error(f"part display needs one of the scenes {', '.join(suite.DISPLAY)}")
    if args.pages:
        return args
    programs = [
        args.ours,
        args.stock,
        *[args.unpatched] * ("instructions" in args.parts),
        *[args.fast] * ("builds" in args.parts),
        *[args.without_speedups] * ("speedups" in args.parts),
        *[args.before] * bool(args.before),
    ]
    for path in programs:
        if not path.is_file():
            parser.error(f"no such program: {path}")
    return args


def measure_scenes(lab, args, results, runs):
    for scene in (versus_stock.with_fine_reference(lab, scene) for scene in suite.SCENES if scene.name in args.scenes):
        untilted = versus_stock.measure(lab, scene)
        lines = versus_stock.compare(scene, untilted)
        for line in lines:
            lab.say(f"  as stock with {line['target']}: {tables.ratio_cell(line)}")
        if "stock" in args.parts:
            runs += untilted + accumulation.measure(lab, scene, 0) + post.measure(lab, scene, 0)
            results.setdefault("stock", {})[scene.name] = lines
        errors = {line["target"]: line["rmse"] for line in lines}
        if "tilted" in args.parts:
            records = tilted.measure(lab, scene, errors)
            runs += records
            results.setdefault("tilted", {})[scene.name] = tilted.compare(records, errors)


def measure(lab, args):
    done = subprocess.run([lab.ours, "--version"], capture_output=True, text=True, check=False)
    version = next((line.strip() for line in (done.stdout + done.stderr).splitlines() if "patch series" in line), "?")
    version += f", program {lab.hashes[lab.ours][:12]}"  # the same patches may be built with other sources
    results, runs = {}, []
    if {"stock", "tilted"} & set(args.parts):
        measure_scenes(lab, args, results, runs)
    scenes = [scene for scene in suite.SCENES if scene.name in args.scenes]
    if "display" in args.parts:
        results["display"], of_display = comparison.display(lab, args.display)
        runs += of_display
    if "lamps" in args.parts:
        results["lamps"], of_lamps = comparison.compare(lab, [scene for scene in scenes if scene.name in suite.LAMPS])
        runs += [] if {"stock", "tilted"} & set(args.parts) else of_lamps
    if "cycles" in args.parts:
        found = cycles.measure(lab)
        if found:
            results["cycles"] = found
    if "preview" in args.parts:
        results["preview"] = preview.measure(lab)
    if "reading" in args.parts:
        results["reading"] = reading.measure(lab)
    if "denoise" in args.parts:
        results["denoise"] = [row for scene in scenes for row in reconstruction.measure(lab, scene)]
    if "pan" in args.parts:
        sharp = [pan_focus.measure(lab, scene) for scene in scenes if scene.name in pan_focus.SCENES]
        results["pan"] = [line for records in sharp for line in pan_focus.compare(records)]
        runs += [{**record, "scene": record["scene"] + ", sharp"} for records in sharp for record in records]
    if "tilt" in args.parts:
        results["tilt"] = tilt_cost.measure(lab)
    if "instructions" in args.parts:
        results["instructions"] = instructions.measure(lab, args.unpatched.resolve())
        results["camera"] = camera_share.measure(lab)
    if "glass" in args.parts:
        results["glass"] = glass_cost.measure(lab)
    if "samples" in args.parts:
        results["samples"] = sample_cost.measure(lab, args.before and args.before.resolve())
    if "loops" in args.parts:
        results["loops"] = instructions.inner_loops(lab)
    if "growth" in args.parts:
        results["growth"] = growth.measure(lab)
    if "contract" in args.parts:
        results["contract"] = [row for scene in scenes for tilt in (0, 1) for row in contract.measure(lab, scene, tilt)]
    if "crops" in args.parts:
        results["crops"] = [row for scene in scenes for tilt in (0, 1) for row in contract.measure(lab, scene, tilt, contract.CROP)]
    if "builds" in args.parts:
        results["builds"] = builds.measure(lab, scenes, args.fast.resolve())
    if "speedups" in args.parts:
        results["speedups"] = speedups.measure(lab, args.without_speedups.resolve())
    if "ablation" in args.parts:
        results["ablation"] = ablation.measure(lab)
    if "found_lamps" in args.parts:
        results["found_lamps"] = found_lamps.measure(lab, args.scenes)
    if "allocation" in args.parts:
        results["allocation"] = allocation.measure(lab, args.scenes)
    if "threads" in args.parts:
        results["threads"] = threads.measure(lab, args.scenes)
    return version, results, runs


def draw(folder, results, runs):
    for name in sorted({record["scene"] for record in runs} & set(NAMES)):
        for tilt, title in ((0, tables.TITLES[name]), (1, tables.TITLES[name] + ", tilted")):
            records = [record for record in runs if record["scene"] == name and record.get("tilted", 0) == tilt]
            if records:
                plots.errors(folder / f"{name}{'_tilted' if tilt else ''}.svg", title, records)
    for name in dict.fromkeys(row["series"] for row in results.get("growth", [])):
        rows = [row for row in results["growth"] if row["series"] == name]
        plots.growth(folder / f"growth_{name.replace(' ', '_')}.svg", name, rows)
    if runs:
        tables.write_csv(folder / "runs.csv", runs)


def update_docs(folder, program, results):
    for part, rows in results.items():
        pages.save(part, rows, program)
    for path in folder.glob("*.svg"):
        shutil.copy(path, pages.DOCS / "pictures" / "benchmarks" / path.name)
    if {"stock", "tilted"} <= set(results):
        shutil.copy(folder / "runs.csv", pages.DOCS / "benchmarks" / "runs.csv")
    pages.update()


def main():
    args = arguments()
    if args.pages:
        pages.update()
        return 0
    work = args.work.resolve()
    if args.fresh:
        (work / "runs.jsonl").unlink(missing_ok=True)
    lab = Lab(args.ours.resolve(), args.stock.resolve(), args.tools.resolve(), work, args.quick)
    try:
        program, results, runs = measure(lab, args)
        folder = work / "results"
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir()
        draw(folder, results, runs)
    except Failed as trouble:
        print(trouble, file=sys.stderr)
        return 1
    made = report.text(results)
    (folder / "tables.md").write_text(made + "\n")
    print(made)
    if args.update_docs:
        update_docs(folder, program, results)
    return 0


if __name__ == "__main__":
    sys.exit(main())

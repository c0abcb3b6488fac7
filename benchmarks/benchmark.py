#!/usr/bin/env python3
# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Run time against error: CPU seconds of each way to a picture with a blurred lens, at equal error."""

import argparse
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import suite  # noqa: E402
import versus_stock  # noqa: E402
from front import geometric_mean  # noqa: E402
from lab import HERE, Failed, Lab  # noqa: E402


def arguments():
    build = HERE.parent / "build"
    names = [scene.name for scene in suite.SCENES]
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--quick", action="store_true", help="fewer settings, a few minutes")
    parser.add_argument("--full", dest="quick", action="store_false", help="all settings (default)")
    parser.add_argument("--scenes", default=",".join(names), help="of " + ", ".join(names))
    parser.add_argument("--ours", type=pathlib.Path, default=build / "bin" / "povray")
    parser.add_argument("--stock", type=pathlib.Path, default="/usr/bin/povray", help="the unpatched program")
    parser.add_argument("--tools", type=pathlib.Path, default=build / "tests" / "benchmarks" / "tools")
    parser.add_argument("--work", type=pathlib.Path, default=build / "benchmarks")
    parser.add_argument("--fresh", action="store_true",
                        help="measure again what an earlier run has measured (references are kept)")
    args = parser.parse_args()
    unknown = set(args.scenes.split(",")) - set(names)
    if unknown:
        parser.error(f"no such scene: {', '.join(sorted(unknown))} (there are {', '.join(names)})")
    for path in (args.ours, args.stock):
        if not path.is_file():
            parser.error(f"no such program: {path}")
    return args


def main():
    args = arguments()
    work = args.work.resolve()
    if args.fresh:
        (work / "runs.jsonl").unlink(missing_ok=True)
    lab = Lab(args.ours.resolve(), args.stock.resolve(), args.tools.resolve(), work, args.quick)
    ratios = []
    try:
        for scene in [scene for scene in suite.SCENES if scene.name in args.scenes.split(",")]:
            records = versus_stock.measure(lab, scene)
            for record in sorted(records, key=lambda record: (record["program"], record["cpu"])):
                lab.say("    {program:9} {setting:18} {cpu:8.3f} s  RMSE {rmse:.5f}".format(**record)
                        + f"  mean {record['mean']:+.5f}  samples {record.get('samples', 0):.0f}")
            for line in versus_stock.compare(records):
                ratio = "missed" if line["ratio"] is None else f"{line['ratio']:.2f}"
                ours = "      -" if line["tilt_lens"] is None else f"{line['tilt_lens']:7.3f}"
                lab.say(f"  {scene.name:10} as stock {line['target']:5}: RMSE {line['rmse']:.5f}  stock "
                        f"{line['stock']:7.3f} s  tilt_lens {ours} s  ratio {ratio}")
                if line["ratio"]:
                    ratios.append(line["ratio"])
    except Failed as trouble:
        print(trouble, file=sys.stderr)
        return 1
    lab.say(f"geometric mean {geometric_mean(ratios):.2f}, worst {min(ratios):.2f}")
    return 0


if __name__ == "__main__":
    sys.exit(main())

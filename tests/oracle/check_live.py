# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Some frames of the oracle agree with the stored one; those with the tilt's sign reversed do not."""

import argparse
import json
import pathlib
import shutil
import subprocess
import sys

from tests.tools import manifest, pictures

CASE = "tilt"
# 128 pinholes have an RMSE of about 0.012, the wrong sign 0.06
LIMITS = {"kind": "limits", "rmse_max": 0.025, "mean_max": 0.002}
BATCHES, SAMPLES, PROCESSES, SEED = 8, 16, 16, 1001


def live(args, case, name):
    output = args.work / (name + ".exr")
    subprocess.run(
        [
            args.oracle,
            "render",
            str(case),
            str(output),
            "--povray",
            args.stock,
            "--work",
            str(args.work / name),
            "--batches",
            str(BATCHES),
            "--samples",
            str(SAMPLES),
            "--processes",
            str(PROCESSES),
            "--seed",
            str(SEED),
        ],
        check=True,
    )
    return output


def outcome(args, picture):
    stored = manifest.FOLDER / "oracle" / (CASE + ".exr")
    try:
        figures = pictures.compare(args.compare, picture, stored, LIMITS)
        print(f"RMSE {figures['rmse']:.5f}, signed mean {figures['mean']:+.6f}")
    except pictures.Trouble as trouble:
        print(f"{trouble.outcome}: {trouble}")
        return trouble.outcome
    return "same"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    for option in ("--oracle", "--compare", "--stock"):
        parser.add_argument(option, required=True)
    parser.add_argument("--work", required=True, type=pathlib.Path)
    args = parser.parse_args()
    shutil.rmtree(args.work, ignore_errors=True)
    args.work.mkdir(parents=True)

    case = manifest.ORACLE_CASES / (CASE + ".json")
    right = outcome(args, live(args, case, "right"))

    description = json.loads(case.read_text())
    description["camera"]["focus"]["tilt"] *= -1
    shutil.copyfile(case.parent / description["scene"], args.work / description["scene"])
    reversed_case = args.work / "reversed.json"
    reversed_case.write_text(json.dumps(description))
    wrong = outcome(args, live(args, reversed_case, "reversed_tilt"))
    return 0 if (right, wrong) == ("same", "different") else 1


if __name__ == "__main__":
    sys.exit(main())

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Reference pictures and their entries agree."""

import argparse
import pathlib
import sys

from tests.tools import manifest


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--compare", required=True, help="the comparison program")
    parser.add_argument("--references", type=pathlib.Path, default=manifest.FOLDER)
    args = parser.parse_args()
    records = manifest.load(args.references)
    found = manifest.complaints(records, args.references, manifest.entries(), args.compare)
    for line in found:
        print(line, file=sys.stderr)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())

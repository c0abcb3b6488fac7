#!/usr/bin/env python3
# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Runs a Python program of this repository by the name of its module, from any folder:

    ./run_module.py tests.stress.run rays

Python looks for packages in the folder of the program that it starts, which is this one, so all scripts import
each other by their place in the repository (tools.batch.plan, tests.render.rendering). In this folder
"python3 -m tests.stress.run rays" does the same.
"""

import runpy
import sys


def main():
    if len(sys.argv) < 2 or sys.argv[1] in ("-h", "--help"):
        sys.exit(__doc__)
    del sys.argv[0]
    runpy.run_module(sys.argv[0], run_name="__main__", alter_sys=True)


if __name__ == "__main__":
    main()

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The repository's place, and command lines of its Python programs."""

import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
BUILD = ROOT / "build"
LAUNCHER = ROOT / "run_module.py"


def module_command(module, *words):
    return [sys.executable, "-B", str(LAUNCHER), module, *map(str, words)]

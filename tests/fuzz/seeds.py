# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""First inputs of libFuzzer: files, and cameras with fields in the order of solver_fuzz's StatementFrom()."""

import shutil
import struct

from tools.repository import ROOT


def camera(flags, numbers, blades=0):
    return struct.pack("<BI3d", flags, 12345, 0.4, 1.5, -4.0) + struct.pack(f"<{len(numbers)}d", *numbers) + struct.pack("<h", blades)


def seeds():
    made = []
    for family in range(4):
        for focal_length in (False, True):
            for f_stop in (False, True):
                flags = family | 4 * focal_length | 8 * f_stop
                head = ([50.0] if focal_length else []) + [2.8 if f_stop else 0.1]
                turns = [6.0, -3.0]
                # planeNormal or first point; focalPoint or second; third; distance, shift
                rest = [0.1, 1.0, 0.3, 1.0, 0.5, 3.0, 0.2, 0.1, 9.0, 0.4, 2.0, -1.0]
                made.append(camera(flags, head + turns + rest, 7))
    made.append(
        struct.pack("<BI12d", 128, 1, 0.4, 1.5, -4, 0, 0, 1.6, 1.6, 0, 0, 0, 1.2, 0)
        + struct.pack("<15d", 0.1, 6, -3, 0.1, 1, 0.3, 1, 0.5, 3, 0.2, 0.1, 9, 0.4, 2, -1)
    )
    return made


def write(folder):
    folder.mkdir(parents=True, exist_ok=True)
    for i, data in enumerate(seeds()):
        (folder / f"seed{i:02}").write_bytes(data)


def write_lenses(folder):
    folder.mkdir(parents=True, exist_ok=True)
    lenses = ROOT / "scenes" / "include" / "lenses"
    for path in sorted([*lenses.glob("*.dat"), *lenses.glob("*.json")]):
        shutil.copy(path, folder / path.name)

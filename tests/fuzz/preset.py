# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""clang takes the options of the preset fuzz: preset.py SOURCE DOWNLOADS."""

import pathlib
import subprocess
import sys
import tempfile

WANTED = ("backend/shape/discs.cpp.o", "povray_own.dir/Unity/unity_0_cxx.cxx.o", "fuzz/CMakeFiles/parser_fuzz.dir/parser_fuzz.cpp.o")


def run(*command):
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"{' '.join(command)}\n{done.stdout[-4000:]}")
    return done.stdout


def main():
    source, downloads = sys.argv[1:]
    with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
        run("cmake", "--preset", "fuzz", "-S", source, "-B", name, f"-DTILT_LENS_DOWNLOADS={downloads}")
        targets = [line.split(":")[0] for line in run("ninja", "-C", name, "-t", "targets", "all").splitlines()]
        for wanted in WANTED:
            found = [target for target in targets if target.endswith(wanted)]
            if len(found) != 1:
                sys.exit(f"{len(found)} targets end in {wanted}")
            run("ninja", "-C", name, "-j1", found[0])
    print(pathlib.Path(source, "CMakePresets.json"), "fuzz: compiles")


if __name__ == "__main__":
    main()

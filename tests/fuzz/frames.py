# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Frames of accepted blocks have finite values."""

import pathlib
import re
import subprocess
import tempfile

from tools import povray_run

BATCH = 250
SCENE = """#version 3.7; global_settings { assumed_gamma 1 }
#include concat("block", str(frame_number, 1, 0), ".inc")
sphere { 0, 1 pigment { rgb <0.8, 0.3, 0.1> } }
plane { y, -1 pigment { checker rgb 0.9, rgb 0.2 } }
light_source { <4, 8, -6>, rgb 1 }
background { rgb <0.3, 0.5, 0.8> }
"""
CAMERA = "camera {{ location <0.4, 1.5, -4> look_at <0, 0.5, 0.5> angle 45 aperture 0.3 blur_samples 2, 16\n" "tilt_lens {{{}}} }}\n"


def _animate(povray, folder, first, last):
    # a single frame would be no animation
    command = povray_run.command(
        povray, "scene.pov", "frame.exr", (8, 6), "+FE", "+WT1", "+KFI1", f"+KFF{last + 1}", f"+SF{first}", f"+EF{last}", "-C"
    )
    done = povray_run.run(command, folder, povray_run.environment(**povray_run.WITHOUT_LEAKS))
    if done.code == 0:
        return ""
    said = done.said.strip().splitlines()
    telling = [line for line in said if "ERROR" in line or "rror:" in line] or said[-1:]
    return f"exit code {done.code}: {' '.join(telling[:2])[:300]}"


def _not_finite(pictures):
    found = set()
    said = subprocess.run(["oiiotool", "--stats", *map(str, pictures)], capture_output=True, text=True, check=True).stdout
    counts = re.findall(r"(?:Nan|Inf)Count: ([\d ]+)", said)
    if len(counts) != 2 * len(pictures):
        raise RuntimeError(f"oiiotool told of {len(counts)} counts for {len(pictures)} pictures:\n{said[:500]}")
    for i, count in enumerate(counts):
        if any(int(number) for number in count.split()):
            found.add(pictures[i // 2])
    return found


def _render_batch(povray, texts):
    wrong = []
    with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
        folder = pathlib.Path(name)
        (folder / "scene.pov").write_text(SCENE)
        for number, text in enumerate(texts, 1):
            (folder / f"block{number}.inc").write_text(CAMERA.format(text))
        digits, first = len(str(len(texts) + 1)), 1
        picture = lambda number: folder / f"frame{number:0{digits}}.exr"  # noqa: E731
        while first <= len(texts):
            words = _animate(povray, folder, first, len(texts))
            failed = next((n for n in range(first, len(texts) + 1) if not picture(n).is_file()), len(texts) + 1)
            if failed <= len(texts) or words:
                wrong.append((texts[min(failed, len(texts)) - 1], words or "no picture"))
            first = failed + 1
        made = [number for number in range(1, len(texts) + 1) if picture(number).is_file()]
        bad = _not_finite([picture(number) for number in made])
        wrong += [(texts[number - 1], "the picture holds a number that is not finite") for number in made if picture(number) in bad]
    return wrong


def render(povray, texts):
    wrong = []
    for start in range(0, len(texts), BATCH):
        wrong += _render_batch(povray, texts[start : start + BATCH])
    return [{"text": text, "answer": words} for text, words in wrong]

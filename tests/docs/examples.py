# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Renders each example of a page at a small size, and the scenes of its ./render commands."""

import argparse
import pathlib
import re
import shlex
import sys
import tempfile

from tools import povray_run
from tools.docs import gallery, pages
from tools.repository import ROOT

SIZE = (32, 18)
VIEW = "right x*image_width/image_height location <0, 1.6, -6> look_at <0, 0.8, 2>"
CAMERA_WORDS = re.compile(r"\b(location|look_at)\b|Tilt_Lens_(Real_)?Upright")
WORLD = """
light_source { <-20, 40, -30>, rgb 1 }
plane { y, 0 pigment { checker rgb 0.8, rgb 0.3 } }
sphere { <0, 1, 2>, 1 pigment { rgb x } }
"""


def scene_of(example):
    text = example.block.text
    if example.kind == "whole":
        return text
    includes = "\n".join(re.findall(r"^\s*(#include .*)$", text, re.MULTILINE))
    text = re.sub(r"^\s*#include .*$", "", text, flags=re.MULTILINE)
    if "Tilt_Lens_" in text:
        includes += '\n#include "tilt_lens.inc"'
    view = "right x*image_width/image_height" if CAMERA_WORDS.search(text) else VIEW
    if example.kind == "tilt_lens items":
        text = f"camera {{ {VIEW} tilt_lens {{\n{text}\n}} }}"
    elif example.kind == "camera items":
        declared = "\n".join(re.findall(r"^\s*#declare .*;.*$", text, re.MULTILINE))
        text = re.sub(r"^\s*#declare .*;.*$", "", text, flags=re.MULTILINE)
        text = f"{declared}\ncamera {{ {view}\n{text}\n}}"
    return f"#version 3.7;\nglobal_settings {{ assumed_gamma 1 }}\n{includes}\n{text}\n{WORLD}"


def run(povray, folder, scene, options=(), library=()):
    command = povray_run.command(povray, scene, "picture.png", SIZE, *options, library=[povray_run.INCLUDE, *library])
    done = povray_run.run(command, folder, povray_run.user_environment())
    return done.code, done.said


def plain(text):
    return re.sub(r"\s+", " ", text)


def wrong_with(example, code, said, picture):
    fails = bool(example.expected["fails"])
    if code is None:
        yield f"it did not end within {povray_run.PATIENCE} s"
    elif fails != (code != 0):
        yield f"exit code {code}"
    elif fails == picture:
        yield "there is a picture" if picture else "there is no picture"
    heard = plain(said)
    for verb in ("says", "warns", "fails"):
        for text in example.expected[verb]:
            if plain(text) not in heard:
                yield f"the program does not say: {text}"
    warnings = len(re.findall(r"\bWarning: ", heard))
    if warnings != len(example.expected["warns"]):
        yield f"{warnings} warnings, {len(example.expected['warns'])} expected"


def check_example(povray, example, folder, index):
    name = example.name or f"example_{index}.pov"
    (folder / name).write_text(scene_of(example))
    (folder / "picture.png").unlink(missing_ok=True)
    code, said = run(povray, folder, name)
    wrong = list(wrong_with(example, code, said, (folder / "picture.png").exists()))
    tail = said[said.find("[Parsing") :][:1500]
    return [f"{example.block.place()}: {text}\n--- {name}\n{(folder / name).read_text()}--- messages\n{tail}" for text in wrong]


def check_output(povray, block, folder):
    words = shlex.split(block.marker[1])
    name, options = words[0], words[1:]
    if not (folder / name).exists() and not (ROOT / name).exists():
        return [f"{block.place()}: the output is of {name}, which is neither an example of the page nor a scene"]
    path = name if (folder / name).exists() else ROOT / name
    # one pixel suffices for messages before the render
    part = [] if "Samples per pixel" in block.text else ["+SC1", "+EC1", "+SR1", "+ER1"]
    code, said = run(povray, folder, path, [*options, *part])
    if code != 0:
        return [f"{block.place()}: {name} ends with exit code {code}\n{said[-1500:]}"]
    heard, at = [line.rstrip() for line in said.split("\n")], 0
    for line in block.text.rstrip("\n").split("\n"):
        if line.strip() == "...":
            continue
        if line.rstrip() not in heard[at:]:
            return [
                f"{block.place()}: the program does not say '{line}'\n"
                + "\n".join(text for text in heard if ".." in text and "Stream" not in text)
            ]
        at = heard.index(line.rstrip(), at) + 1
    return []


def rendered_command(command, names):
    try:
        words = shlex.split(command)
    except ValueError:
        return None
    if words[:1] != ["./render"] or len(words) < 2:
        return None
    scenes = [word for word in words[1:] if word.endswith(".pov") and not word.startswith(("+", "-"))]
    if len(scenes) != 1 or scenes[0] in ("SCENE.pov", "my_scene.pov") or scenes[0] in names:
        return None
    return scenes[0], [word for word in words[1:] if word != scenes[0] and not re.match(r"[+-][WHOF]", word)]


def check_command(povray, place, command, names, folder):
    wanted = rendered_command(command, names)
    if wanted is None:
        return []
    scene, options = ROOT / wanted[0], wanted[1]
    if any(word.startswith("+L") and not (ROOT / word[2:]).is_dir() for word in options):
        return []
    if not scene.is_file():
        return [f"{place}: {command}: there is no scene {wanted[0]}"]
    if scene.parent == gallery.SCENES and not options:
        return []  # tested by the gallery
    code, said = run(povray, folder, scene, options, [scene.parent])
    return [] if code == 0 else [f"{place}: {command}: exit code {code}\n{said[-1500:]}"]


def check_page(povray, path):
    name, text = str(path.relative_to(ROOT)), path.read_text()
    blocks = pages.blocks_of(name, text)
    examples = pages.examples_of(blocks)
    outputs = [block for block in blocks if block.marker and block.marker[0] == "output of"]
    names = [example.name for example in examples]
    wrong = []
    with tempfile.TemporaryDirectory(prefix="tilt_lens.") as folder_name:
        folder = pathlib.Path(folder_name)
        for index, example in enumerate(examples):
            if example.kind != "not rendered":
                wrong += check_example(povray, example, folder, index)
        for block in outputs:
            wrong += check_output(povray, block, folder)
        commands = {command: number for number, command in pages.commands_of(name, text)}
        for command, number in commands.items():
            wrong += check_command(povray, f"{name}:{number}", command, names, folder)
    return wrong, len(examples), len(outputs), len(commands)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("page", type=pathlib.Path, nargs="+")
    parser.add_argument("--povray", type=pathlib.Path, required=True)
    args = parser.parse_args()
    failed = False
    for page in args.page:
        try:
            wrong, examples, outputs, commands = check_page(str(args.povray.resolve()), page.resolve())
        except pages.BadPage as error:
            wrong, examples, outputs, commands = [str(error)], 0, 0, 0
        for text in wrong:
            print(f"FAILED {text}\n")
        print(f"{page.name}: {examples} examples, {outputs} outputs, {commands} commands, {len(wrong)} wrong")
        failed = failed or bool(wrong)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())

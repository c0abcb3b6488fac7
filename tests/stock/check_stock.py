# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Compares the pixels of one scene without tilt_lens, rendered by the unpatched program and by the fork.

Files contain dates, so 16-bit decoded pixels are compared. Both use one thread, on which radiosity and area lights depend."""

import argparse
import hashlib
import pathlib
import shutil
import subprocess
import sys

from tools import povray_run


def arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("scene", help="path below the folder of examples")
    parser.add_argument("width", type=int)
    parser.add_argument("height", type=int)
    parser.add_argument("options", nargs="*", help="further options of POV-Ray, after --")
    parser.add_argument("--stock", required=True, help="the unpatched program")
    parser.add_argument("--fork", required=True)
    parser.add_argument("--compare", required=True, help="the comparison program")
    parser.add_argument("--examples", required=True, type=pathlib.Path)
    parser.add_argument("--includes", required=True, type=pathlib.Path)
    parser.add_argument("--work", required=True, type=pathlib.Path)
    return parser.parse_args()


def render(program, args, folder):
    if folder.exists():
        shutil.rmtree(folder)
    folder.mkdir(parents=True)
    scene = args.examples / args.scene
    for neighbour in scene.parent.iterdir():
        if neighbour.is_file():
            shutil.copyfile(neighbour, folder / neighbour.name)
    picture = folder / "picture.png"
    # unknown to the unpatched program; needed for a scene that writes in the build folder
    unrestricted = ["--unrestricted"] if folder.name == "fork" else []
    command = povray_run.command(
        program,
        scene.name,
        picture.name,
        (args.width, args.height),
        *unrestricted,
        "+FN16",
        "-V",
        "-GA",
        "+WT1",
        *args.options,
        library=[args.includes],
    )
    done = povray_run.run(command, folder, limit=None)
    if done.code != 0 or not picture.is_file():
        raise SystemExit(f"{program} made no picture of {args.scene}:\n{done.told()}")
    return picture


def pixels(compare, picture):
    head, data = povray_run.pixels(compare, picture).split(b"\n", 1)
    return head.decode(), hashlib.sha256(data).hexdigest()


def main():
    args = arguments()
    if not (args.examples / args.scene).is_file():
        print(f"there is no {args.examples / args.scene}: is povray-examples installed?", file=sys.stderr)
        return 1
    stock, fork = shutil.which(args.stock), shutil.which(args.fork)
    if stock is None or fork is None:
        print(f"no such program: {args.stock if stock is None else args.fork}", file=sys.stderr)
        return 1
    work = args.work.absolute()
    pictures = [render(program, args, work / name) for program, name in ((stock, "stock"), (fork, "fork"))]
    of_stock, of_fork = (pixels(args.compare, picture) for picture in pictures)
    if of_stock == of_fork:
        print(f"{args.scene}: the same pixels, SHA-256 {of_fork[1]}")
        return 0
    print(f"{args.scene}: the pixels differ: stock {of_stock}, fork {of_fork}", file=sys.stderr)
    figures = subprocess.run([args.compare, "exact", str(pictures[1]), str(pictures[0])], capture_output=True, text=True, check=False)
    print(figures.stdout, file=sys.stderr)
    return 1


if __name__ == "__main__":
    sys.exit(main())

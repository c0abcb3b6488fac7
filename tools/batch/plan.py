# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Plans a batch from a command line.

A band is a range of a picture's rows. A unit is one band of one picture, rendered, kept and repeated as a whole. A task is a sequence of
units."""

import decimal
import itertools
import os
import re

from tools.batch.key import Links
from tools.batch.pov_options import PovOptions
from tools.batch.store import BatchError, sha256

BLOCK = 32  # rows of POV-Ray's blocks, on whose boundaries stock anti-aliasing depends
TALL = 256  # rows of a band: each edge costs 15 to 20 rows in a blurred picture
POVINC = "povinc"  # link to the folder in POVINC, which POV-Ray searches before those of +L
MOST_VALUES = 100000
SECONDS_A_TASK = 5.0  # least worth of a task, ten times the cost of a start
DEFAULT_INI = ("./povray.ini", "~/.povray/3.7/povray.ini", "{prefix}/etc/povray/3.7/povray.ini", "~/.povrayrc")


def safe_name(path, fallback):
    name = os.path.basename(path)
    return name if re.fullmatch(r"[A-Za-z0-9_][A-Za-z0-9_.+-]*\.[A-Za-z0-9]+", name) else fallback


def chosen(text, last):
    found = set()
    for part in text.split(","):
        match = re.fullmatch(r"(\d+)(?:-(\d+))?", part.strip())
        first, end = (int(match.group(1)), int(match.group(2) or match.group(1))) if match else (0, 0)
        if not 1 <= first <= end <= last:
            raise BatchError(f"--only: {part!r}: expected frames from 1 to {last}, as in 5-8,12.")
        found.update(range(first - 1, end))
    return sorted(found)


def values(text):
    """Values of --set: numbers, FROM:TO:STEP, and texts with their quotation marks, separated by commas."""
    found = []
    for part in re.split(r',(?=(?:[^"]*"[^"]*")*[^"]*$)', text):
        if '"' in part:
            if not re.fullmatch(r'"[^"\'\\/\x00-\x1f]{1,80}"', part):
                raise BatchError(
                    f"--set: {part!r}: expected a text of 1 to 80 characters in double quotation marks, without any "
                    "of them, ', \\, / and line breaks inside."
                )
            found.append(part)
            continue
        try:
            numbers = [decimal.Decimal(piece) for piece in part.split(":")]
        except decimal.InvalidOperation:
            raise BatchError(
                f'--set: {part!r} is not a number; expected VALUE, FROM:TO:STEP, "TEXT", or several with commas ' "between."
            ) from None
        if len(numbers) == 1 and numbers[0].is_finite():
            found.append(numbers[0])
            continue
        if len(numbers) != 3 or not all(n.is_finite() for n in numbers) or numbers[2] == 0:
            raise BatchError(f"--set: {part!r}: expected VALUE or FROM:TO:STEP with a step that is not zero.")
        first, last, step = numbers
        count = int((last - first) / step) + 1 if (last - first) / step >= 0 else 0
        if count == 0:
            raise BatchError(f"--set: {part!r} has 0 values; with this step, TO must lie on the other side of FROM.")
        if count > MOST_VALUES:
            raise BatchError(f"--set: {part!r} has {count} values; {MOST_VALUES} at most. Take a larger step.")
        found += [first + step * i for i in range(count)]
    if len(set(found)) != len(found):
        raise BatchError(f"--set: {text!r} has a value twice.")
    return [n if isinstance(n, str) else f"{n.normalize():f}" if n else "0" for n in found]


def parse_sets(words):
    sets = []
    for word in words:
        match = re.fullmatch(r"([A-Za-z_][A-Za-z0-9_]*)=(.+)", word)
        if not match:
            raise BatchError(f"--set {word!r}: expected NAME=VALUES, for example Tilt=-8:8:2 or Aperture=0.1,0.2.")
        if match.group(1) in (name for name, _ in sets):
            raise BatchError(f"--set: {match.group(1)} is given twice; put all of its values behind one, with commas.")
        sets.append((match.group(1), values(match.group(2))))
    return sets


def pictures(kind, stem, extension, frames=1, sets=()):
    if kind == "film":
        digits = max(4, len(str(frames)))
        return [
            {"name": f"{stem}{n:0{digits}d}.{extension}", "options": [], "frame": n, "label": f"frame {n}"} for n in range(1, frames + 1)
        ]
    if kind == "sweep":
        made = []
        for choice in itertools.product(*(found for _, found in sets)):
            words = [f"{name}={value}" for (name, _), value in zip(sets, choice)]
            pairs = [word.replace('"', "") for word in words]
            made.append(
                {
                    "name": f"{stem}_{'_'.join(pairs)}.{extension}",
                    "frame": 1,
                    "options": [f"Declare='{word}'" if '"' in word else f"Declare={word}" for word in words],
                    "label": ", ".join(pairs),
                }
            )
        return made
    return [{"name": f"{stem}.{extension}", "options": [], "frame": 1, "label": stem}]


def cut_bands(height, count):
    """[first, last] rows, from 1. Cuts lie between POV-Ray's blocks unless bands are more. The first band has two rows, since +SR1 +ER1 means
    all rows."""
    step = BLOCK if count <= -(-height // BLOCK) else 1
    blocks = -(-height // step)
    count = max(1, min(count, blocks if step > 1 else height - 1))
    ends = [min(height, blocks * (i + 1) // count * step) for i in range(count)]
    if count > 1 and ends[0] == 1:
        ends[:-1] = [max(end, i + 2) for i, end in enumerate(ends[:-1])]
    starts = [1, *(end + 1 for end in ends[:-1])]
    return [[a, b] for a, b in zip(starts, ends)]


def unit_name(number, bands):
    return f"{number // bands:05d}.{number % bands:04d}"


def read_ini(path):
    """Refuses commands, which would run once per band."""
    with open(path, encoding="utf-8", errors="surrogateescape") as stream:
        text = stream.read()
    command = re.search(r"^\s*(\w+_(?:Scene|Frame)_Command|\w+_Command)\s*=", text, re.IGNORECASE | re.MULTILINE)
    if command:
        raise BatchError(
            f"{path!r} sets {command.group(1)}: it would run once for each band. Take it out, and run the " "command after the batch."
        )
    return text


def main_ini(program, folder):
    prefix = os.path.dirname(os.path.dirname(os.path.realpath(program)))
    named = os.environ.get("POVINI")
    candidates = [named] if named else []
    candidates += [os.path.expanduser(name.format(prefix=prefix)) for name in DEFAULT_INI]
    candidates = [os.path.normpath(os.path.join(folder, name)) for name in candidates]
    for i, path in enumerate(candidates):
        if os.path.isfile(path):
            return path, candidates[:i]
    return None, candidates


class Inputs:
    """The scene, and the folders in which POV-Ray looks for its files."""

    def __init__(self, scene, folder, words, program, repository):
        self.scene = os.path.join(folder, scene)
        if not (os.path.isfile(self.scene) and os.access(self.scene, os.R_OK)):
            raise BatchError(f"there is no readable scene file {scene!r}.")
        self.folder, self.options = folder, PovOptions(words)
        self.file = safe_name(self.scene, "scene.pov")
        include = os.path.join(repository, "scenes", "include")
        targets = {"here": folder, "include": include, "scene": os.path.dirname(self.scene), self.file: self.scene}
        self.searched = ["include", "scene"]
        named = list(self.options.named_files(folder))
        self.libraries = named[: len(self.options.libraries)]
        self.povinc = os.path.join(folder, os.environ["POVINC"]) if os.environ.get("POVINC") else None
        if self.povinc:
            targets[POVINC] = self.povinc
        for i, library in enumerate(self.libraries):
            targets[f"library{i}"] = library
            self.searched.append(f"library{i}")
        self.words = list(self.options.words)
        self.files, self.missing = {}, []
        for i, ini in enumerate(named[len(self.libraries) :]):
            self.add_ini(i, ini, targets)
        self.ini, self.missing = main_ini(program, folder)
        self.links = Links(targets)

    def add_ini(self, i, ini, targets):
        if not os.path.isfile(ini):
            raise BatchError(f"there is no ini file {ini!r}.")
        read_ini(ini)
        targets[f"options{i}.ini"] = ini

    def write(self, work):
        self.links.make(work.inputs)
        text = f'Library_Path="{Links.UP}here"\n'
        if self.ini:
            text += re.sub(
                r'^(\s*Library_Path\s*=\s*"?)(?!["/])', rf"\g<1>{Links.UP}here/", read_ini(self.ini), flags=re.IGNORECASE | re.MULTILINE
            )
        path = work.inputs / "povray.ini"
        path.write_text(text, encoding="utf-8", errors="surrogateescape")

    def own_files(self):
        """Files of the key that POV-Ray does not list."""
        return {self.ini: sha256(self.ini)} if self.ini else {}

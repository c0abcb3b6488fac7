# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The key of a batch: all that its pixels depend on.

POV-Ray lists files that it reads or looks for in vain (TILT_LENS_FILE_LIST). The key hashes those of the first render, a unit's record
further ones. A part is reused only if no file has changed or appeared."""

import hashlib
import json
import os

from tools.batch.store import BatchError, sha256


class Links:
    """Links under inputs/ to the user's paths, which may contain any characters."""

    UP = "../../inputs/"  # as seen from a unit's folder

    def __init__(self, targets):
        self.targets = dict(targets)

    def make(self, folder):
        for name, target in self.targets.items():
            link = folder / name
            if link.is_symlink() and os.readlink(link) == target:
                continue
            if link.is_symlink() or link.exists():
                link.unlink()
            link.symlink_to(target)

    def real(self, name):
        """The user's path, with links unresolved. None for a file in the unit's folder."""
        if name.startswith(self.UP):
            link, _, rest = name[len(self.UP) :].partition("/")
            if link in self.targets:
                return self.targets[link] + ("/" + rest if rest else "")
            return None
        return name if os.path.isabs(name) else None


def listed_files(path, links):
    """(read, missing) as the user's paths."""
    try:
        entries = path.read_bytes().split(b"\0")
    except FileNotFoundError:
        raise BatchError(
            "the program does not list the files that it reads (TILT_LENS_FILE_LIST): it is not this " "project's povray."
        ) from None
    read, missing = set(), set()
    for entry in entries:
        if entry[:1] not in (b"+", b"-"):
            continue
        name = links.real(os.fsdecode(entry[1:]))
        if name is not None:
            (read if entry[:1] == b"+" else missing).add(name)
    return read, missing - read


def file_stamp(path):
    state = os.stat(path)
    return [state.st_size, state.st_mtime_ns, state.st_ino]


def change_stamps(paths):
    """{path: stamp, or None}. Includes the time of the entry's change, which cannot be set back."""
    stamps = {}
    for path in paths:
        try:
            stamps[path] = [*file_stamp(path), os.stat(path).st_ctime_ns]
        except OSError:
            stamps[path] = None
    return stamps


def changed_since(path, before, moment):
    """Compares with the stamp or, without one, with a moment (epoch seconds) by the file system's clock."""
    if path in before:
        return change_stamps([path]) != {path: before[path]}
    return os.stat(path).st_ctime_ns > (moment - 0.02) * 1e9


def hashes(paths):
    return {path: sha256(path) for path in sorted(paths)}


def key_hash(key):
    return hashlib.sha256(json.dumps(key, sort_keys=True).encode()).hexdigest()


def changed_files(files, missing):
    for path, old in sorted(files.items()):
        try:
            new = sha256(path)
        except OSError as error:
            yield f"file {path!r} cannot be read any more ({error.strerror})"
            continue
        if new != old:
            yield f"file {path!r} has changed"
    for path in sorted(missing):
        if os.path.exists(path):
            yield f"file {path!r} is there now, and would be found before the one that was used"


TEXTS = {
    "kind": "kind of batch",
    "scene": "scene",
    "folder": "current folder",
    "options": "options of POV-Ray",
    "version": "version of povray",
    "program": "program povray (its bytes; was it built anew?)",
    "pictures": "pictures (frames, or values of --set)",
    "bands": "bands",
    "extension": "kind of picture",
    "libraries": "folders of include files",
    "POVINC": "environment variable POVINC",
    "ini": "first ini file (environment variable POVINI, or the first that is found)",
}


def short(value):
    if value is None:
        return "not set"
    text = value if isinstance(value, str) else json.dumps(value)
    return text if len(text) <= 120 else f"{text[:100]}... ({len(text)} characters)"


def first_difference(these, those):
    other = [item for item in these if item not in those]
    first = other[0] if other else None
    told = f", among them {first['name'] if isinstance(first, dict) else first}" if first else ""
    return f"{len(these)}{told}"


def changed_settings(old, new):
    for name, text in TEXTS.items():
        if old.get(name) != new.get(name):
            was, now = old.get(name), new.get(name)
            if name in ("pictures", "bands"):
                was, now = first_difference(was, now), first_difference(now, was)
            yield f"{text}: was {short(was)}, is {short(now)}"

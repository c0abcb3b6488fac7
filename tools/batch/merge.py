# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Joins the bands of a picture and delivers it."""

import contextlib
import functools
import os
import pathlib
import shutil
import subprocess

from tools.batch import povray
from tools.batch.key import file_stamp
from tools.batch.plan import unit_name
from tools.batch.store import BatchError, little_room, read_json, sha256, sync_file, sync_folder, write_json


def oiiotool(folder, arguments):
    done = subprocess.run(
        povray.ending_with_parent(["oiiotool", *arguments]), cwd=folder, stdin=subprocess.DEVNULL, capture_output=True, check=False
    )
    if done.returncode != 0:
        said = (done.stderr + done.stdout).decode(errors="replace").strip().splitlines() or [f"nothing, exit code {done.returncode}"]
        room = "".join(f"\n{line}" for line in little_room(folder))
        raise BatchError(f"oiiotool failed in {str(folder)!r}. It said:\n  " + "\n  ".join(said[:6]) + room)


def band_records(work, key, picture):
    """Raises an error for a damaged band, which the next try renders again."""
    records = []
    for band in range(len(key["bands"])):
        name = unit_name(picture * len(key["bands"]) + band, len(key["bands"]))
        record = read_json(work.record("done", name))
        if record is None:
            raise BatchError(f"unit {name} is not done.")
        for told in record["files"].values():
            path = work.unit(name) / told["file"]
            if not path.is_file() or path.stat().st_size != told["bytes"] or sha256(path) != told["sha256"]:
                work.record("done", name).unlink()
                raise BatchError(f"{path.name} of unit {name} was damaged; it will be rendered again.")
        records.append((name, record))
    return records


def join(folder, bands, width, target):
    words = ["--no-autopremult", "--nosoftwareattrib"]
    for path, (first, last) in bands:
        words += [path, "--crop", f"{width}x{last - first + 1}+0+{first - 1}"]
    oiiotool(folder, [*words, "--paste:all=1:mergeroi=1", "+0+0", "-o", target.name])


def paste(work, key, records, rest, target):
    width, height = key["size"]
    paths = [f"{name}/{record['files'][rest]['file']}" for name, record in records]
    join(work.units, list(zip(paths, key["bands"])), width, target)
    found = povray.image_info(target)
    wanted = records[0][1]["files"][rest]
    if found["size"] != [width, height] or (found["channels"], found["form"]) != (wanted["channels"], wanted["form"]):
        raise BatchError(
            f"the merged {target.name} is {found}, expected {width} x {height}, {wanted['channels']} channels, " f"{wanted['form']}."
        )
    return found["pixels"]


def deliver(source, target):
    """Moves a file in one step, without a copy on the same file system."""
    target.parent.mkdir(parents=True, exist_ok=True)
    new = target.parent / f".new.{os.getpid()}.{source.name}"
    try:
        try:
            os.link(source, new)
        except OSError:
            shutil.copyfile(source, new)
            sync_file(new)
        os.replace(new, target)
    finally:
        with contextlib.suppress(FileNotFoundError):
            new.unlink()
    sync_folder(target.parent)


def merged_files(work, key, picture):
    records = band_records(work, key, picture)
    rests = set(records[0][1]["files"])
    for name, record in records:
        if set(record["files"]) != rests:
            raise BatchError(f"unit {name} has the files {sorted(record['files'])}, the first band {sorted(rests)}.")
    found = {}
    for rest in sorted(rests):
        if len(records) == 1:
            told = records[0][1]["files"][rest]
            found[rest] = (work.unit(records[0][0]) / told["file"], told["pixels"])
        else:
            target = work.units / f"{picture:05d}{rest}"
            found[rest] = (target, paste(work, key, records, rest, target))
            sync_file(target)
    return found


def merge_picture(work, description, picture):
    if is_merged(work, description, picture):
        return
    key = description["key"]
    stem = pathlib.Path(description["output"]) / key["pictures"][picture]["name"]
    told = {}
    for rest, (path, pixels) in merged_files(work, key, picture).items():
        target = stem.with_name(stem.name[: -len(key["extension"]) - 1] + rest)
        deliver(path, target)
        told[rest] = {"file": str(target), "bytes": target.stat().st_size, "sha256": sha256(target), "pixels": pixels}
    write_json(work.record("merged", f"{picture:05d}"), told)
    free_space(work, key, picture)


def free_space(work, key, picture):
    for band in range(len(key["bands"])):
        shutil.rmtree(work.unit(unit_name(picture * len(key["bands"]) + band, len(key["bands"]))), ignore_errors=True)
    for path in work.units.glob(f"{picture:05d}.*"):
        if path.is_file() and path.suffix != ".lock":
            path.unlink()


@functools.lru_cache(maxsize=None)
def hash_now(path, *_):
    return sha256(path)


def is_merged(work, description, picture):
    told = read_json(work.record("merged", f"{picture:05d}"))
    if not told:
        return False
    for entry in told.values():
        try:
            if (
                os.path.dirname(entry["file"]) != description["output"]
                or os.stat(entry["file"]).st_size != entry["bytes"]
                or hash_now(entry["file"], *file_stamp(entry["file"])) != entry["sha256"]
            ):
                return False
        except OSError:
            return False
    return True

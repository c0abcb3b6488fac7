# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Creates a batch's description, or resumes an unchanged one."""

import contextlib
import math
import os
import pathlib
import shutil
import sys

from tools.batch import key as keys, longer, merge, plan, povray, progress, slurm
from tools.batch.probe import Probe
from tools.batch.store import BatchError, UsageError, Work, output_lock, read_json, sha256, write_json
from tools.repository import ROOT

MESSAGE_LINES = 12


def say(text):
    print(text, file=sys.stderr)


class Request:
    def __init__(self, settings, words):
        self.settings = settings
        folder = os.getcwd()
        program = os.path.realpath(settings.povray)
        self.inputs = plan.Inputs(settings.scene, folder, words, program, str(ROOT))
        self.kind = settings.kind
        self.extension = self.picture_kind()
        self.threads = self.inputs.options.threads or 1
        stem = os.path.splitext(os.path.basename(self.inputs.scene))[0]
        self.sets = plan.parse_sets(settings.set) if self.kind == "sweep" else []
        self.frames = settings.frames if self.kind == "film" else 1
        only = self.settings.only if self.kind == "film" else None
        self.only = None if only is None else plan.chosen(only, self.frames)
        self.place(folder, stem)
        self.pictures = plan.pictures(self.kind, self.stem, self.extension, self.frames, self.sets)
        self.program = program

    def picture_kind(self):
        """From +F and the output's name, which must agree."""
        asked = self.inputs.options.kind
        named = None
        if self.kind == "still" and self.settings.output:
            named = os.path.splitext(self.settings.output)[1].lower().lstrip(".")
            if named not in ("png", "exr"):
                raise BatchError(f"--output {self.settings.output!r}: a still is a .png or an .exr file.")
        if asked and named and asked != named:
            raise BatchError(f"--output {self.settings.output!r} is not of the kind that the option +F asks for ({asked}).")
        return asked or named or "png"

    def place(self, folder, stem):
        default = {"still": f"{stem}.{self.extension}", "film": f"{stem}_film", "sweep": f"{stem}_sweep"}[self.kind]
        output = os.path.abspath(os.path.join(folder, self.settings.output or default))
        self.stem = stem
        if self.kind == "still":
            self.stem = os.path.splitext(os.path.basename(output))[0]
            self.output = os.path.dirname(output)
        else:
            self.output = output
        if output == os.path.dirname(output):
            raise BatchError(f"--output {self.settings.output!r} is the root of all folders; give a name.")
        if self.kind == "still" and os.path.isdir(output):
            raise BatchError(f"--output {self.settings.output!r} is a folder; a still is a file.")
        self.work = os.path.join(folder, self.settings.work or output + ".batch")

    def key(self):
        return {
            "format": 1,
            "kind": self.kind,
            "scene": self.inputs.scene,
            "folder": self.inputs.folder,
            "options": self.inputs.words,
            "libraries": self.inputs.libraries,
            "POVINC": self.inputs.povinc,
            "ini": self.inputs.ini,
            "extension": self.extension,
            "version": povray.version(self.program),
            "program": sha256(self.program),
            "pictures": self.pictures,
        }

    def changeable(self):
        return {
            "threads": self.threads,
            "retries": self.settings.retries,
            "limit": self.settings.limit,
            "only": self.only,
            "then": self.settings.then if self.settings.detach else None,
            "program": self.program,
            "output": self.output,
            "tasks": [],
            "on": self.settings.on,
        }

    def description(self):
        return {
            "key": self.key(),
            "input": keys.Links.UP + self.inputs.file,
            "searched": self.inputs.searched,
            "kind_option": "" if self.inputs.options.kind else {"png": "+FN", "exr": "+FE"}[self.extension],
            "frames": self.frames,
            "links": self.inputs.links.targets,
            "sets": self.sets,
            "sheet": f"{self.stem}_sheet.png",
            **self.changeable(),
        }


def understood(settings, words):
    try:
        return Request(settings, words)
    except BatchError as error:
        raise UsageError(str(error)) from None


def take_up(work, request, stored):
    """Returns None if the batch's key has changed."""
    old, new = stored["key"], request.key()
    if stored["hash"] != keys.key_hash(old):
        raise BatchError(f"{str(work.description)!r} is damaged. Start over with --anew.")
    new["bands"] = old["bands"] if not request.settings.bands else plan.cut_bands(old["size"][1], request.settings.bands)
    changes = [
        *longer.lengthen(work, request, stored, new),
        *keys.changed_settings(old, new),
        *keys.changed_files(old["files"], old["missing"]),
        *changed_by_units(work),
    ]
    if changes:
        more = [f"... and {len(changes) - MESSAGE_LINES} more"] if len(changes) > MESSAGE_LINES else []
        raise BatchError(
            "\n  ".join([f"the work folder {str(work.folder)!r} belongs to a batch that was another:", *changes[:MESSAGE_LINES], *more])
            + "\nUndo the change, give another --output or --work, or start over with --anew."
        )
    stored.update(request.changeable())
    stored["stamps"] = {path: keys.file_stamp(path) for path in old["files"]}
    return stored


def changed_by_units(work):
    known = {}
    for name in sorted(work.names("done")):
        record = read_json(work.record("done", name)) or {"read": {}, "missing": []}
        for path, digest in record["read"].items():
            if known.setdefault(path, digest) != digest:
                yield f"file {path!r} was not the same for all units"
        yield from keys.changed_files(record["read"], record["missing"])


def begin(work, request, engine):
    description = request.description()
    key = description["key"]
    work.make()
    request.inputs.write(work)
    probe = Probe(work, description, key["pictures"][0])
    key["size"] = probe.picture_size()
    estimate, bands = choose_bands(request, probe, key["size"], engine)
    key["bands"] = plan.cut_bands(key["size"][1], bands)
    key["files"] = keys.hashes(probe.read) | request.inputs.own_files()
    key["missing"] = sorted(probe.missing | set(request.inputs.missing))
    description["estimate"] = estimate
    description["hash"] = keys.key_hash(key)
    description["stamps"] = {path: keys.file_stamp(path) for path in key["files"]}
    write_json(work.description, description)
    return description


def output_can_be_written(folder):
    try:
        os.makedirs(folder, exist_ok=True)
    except OSError as error:
        raise BatchError(f"the output folder {folder!r} cannot be made: {error.strerror}.") from None
    if not os.access(folder, os.W_OK | os.X_OK):
        raise BatchError(f"the output folder {folder!r} cannot be written; give another with --output.")


def lock_of_output(kind, output, pictures):
    return pathlib.Path(output) / (f".{pictures[0]['name']}.lock" if kind == "still" else ".batch.lock")


def has_jobs(folder):
    try:
        return bool(slurm.active_jobs(Work(folder)))
    except BatchError:  # the controller does not answer
        return True


def leave_output(work, description):
    key, own = description["key"], str(work.folder)
    path = lock_of_output(key["kind"], description["output"], key["pictures"])
    if path.exists():
        with output_lock(path, own, lambda folder: folder != own):
            pass


@contextlib.contextmanager
def output_alone(work, request):
    """Only one batch may write the same pictures at a time."""
    output_can_be_written(request.output)
    path = lock_of_output(request.kind, request.output, request.pictures)
    with output_lock(path, work.folder, has_jobs) as other:
        if other is not None:
            raise BatchError(
                f"another batch writes to {request.output!r} at this time, with the work folder {other!r}. Wait for it, or "
                "give another --output."
            )
        yield


def choose_bands(request, probe, size, engine):
    """As requested, or enough for the workers while each band is worth its start."""
    asked, count = request.settings.bands, len(request.pictures)
    if asked == 1:
        return {"picture": 0.0, "start": 0.6}, 1
    estimate = probe.estimate(size)
    blocks = -(-size[1] // plan.BLOCK)
    worth = max(plan.SECONDS_A_TASK, 10 * estimate["start"])
    parallel = engine.workers(request.settings, request.threads)
    tall = max(math.ceil(parallel / count), size[1] // plan.TALL)
    bands = asked or max(1, min(math.ceil(4 * parallel / count), tall, int(estimate["picture"] / worth), blocks))
    say(
        f"about {progress.span(estimate['picture'] * count * request.threads)} of one core in all, and "
        f"{estimate['start']:.1f} s for each start of POV-Ray; {bands} band{'s' if bands > 1 else ''} a picture"
    )
    if bands > 1 and (probe.radiosity() or probe.seam(size, bands <= blocks)):
        why = "radiosity" if probe.radiosity() else "the rows that are rendered with them (jitter of an area light, for example)"
        if asked:
            raise BatchError(
                f"the pixels of this scene depend on {why}, so bands would not fit together. Use --bands 1; "
                "films and sweeps still go side by side, picture by picture."
            )
        say(f"The pixels of this scene depend on {why}: the picture is not cut into bands.")
        bands = 1
    return estimate, bands


def refuse_foreign(work):
    if work.folder.exists():
        foreign = sorted(set(os.listdir(work.folder)) - work.names_in_it())
        if foreign:
            raise BatchError(
                f"{str(work.folder)!r} is not the work folder of a batch (it holds {foreign[0]!r}); give another " "with --work."
            )


def open_batch(work, request, engine):
    stored = read_json(work.description)
    if stored is None or (request.settings.anew and request.only is None):
        work.clear()
        return begin(work, request, engine)
    stored = take_up(work, request, stored)
    work.make()
    request.inputs.write(work)
    if request.settings.anew:
        forget(work, stored, request.only)
    drop_lost(work, stored)
    return stored


def forget(work, description, pictures):
    bands = len(description["key"]["bands"])
    for picture in pictures:
        work.record("merged", f"{picture:05d}").unlink(missing_ok=True)
        for name in (plan.unit_name(picture * bands + band, bands) for band in range(bands)):
            work.record("done", name).unlink(missing_ok=True)
            shutil.rmtree(work.unit(name), ignore_errors=True)


def drop_lost(work, description):
    """Drops records whose files the user has moved or a disk has lost."""
    bands = len(description["key"]["bands"])
    for state in ("failed", "running"):
        for name in work.names(state):
            work.record(state, name).unlink(missing_ok=True)
    done = work.names("done")
    merged = work.names("merged")
    for picture in range(len(description["key"]["pictures"])):
        if f"{picture:05d}" in merged:
            if merge.is_merged(work, description, picture):
                continue
            work.record("merged", f"{picture:05d}").unlink()
        for name in (plan.unit_name(picture * bands + band, bands) for band in range(bands)):
            if name in done and not unit_is_there(work, name):
                work.record("done", name).unlink()


def unit_is_there(work, name):
    record = read_json(work.record("done", name))
    if record is None:
        return False
    paths = [(pathlib.Path(work.unit(name)) / told["file"], told["bytes"]) for told in record["files"].values()]
    return all(path.is_file() and path.stat().st_size == size for path, size in paths)

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Files of a batch, and how they are written so that no crash can spoil them.

In the work folder, besides those of docs/batch.md:

    lock       held by the front end
    inputs/    links to the scene and other folders, under names that POV-Ray can take
    probe/     the first small renders
"""

import contextlib
import fcntl
import hashlib
import json
import os
import pathlib
import shutil
import tempfile


class BatchError(Exception):
    """The user can mend it; the message has the remedy."""


class UsageError(BatchError):
    pass


def sha256(path):
    digest = hashlib.sha256()
    with open(path, "rb") as stream:
        for piece in iter(lambda: stream.read(1 << 20), b""):
            digest.update(piece)
    return digest.hexdigest()


def sync_folder(folder):
    """The folder's names then survive a power failure."""
    handle = os.open(folder, os.O_RDONLY)
    try:
        os.fsync(handle)
    finally:
        os.close(handle)


def sync_file(path):
    with open(path, "rb") as stream:
        os.fsync(stream.fileno())


def write_text(path, text):
    """Writes completely or not at all, even if the machine stops."""
    path = pathlib.Path(path)
    handle, name = tempfile.mkstemp(prefix=".new.", dir=path.parent)
    try:
        with open(handle, "w", encoding="utf-8", errors="surrogateescape") as stream:
            stream.write(text)
            stream.flush()
            os.fsync(stream.fileno())
            os.fchmod(stream.fileno(), 0o644)
        os.replace(name, path)
    except BaseException as error:
        if isinstance(error, OSError) and not error.filename:
            error.filename = str(path)
        with contextlib.suppress(OSError):
            os.unlink(name)
        raise
    sync_folder(path.parent)


def write_json(path, value):
    write_text(path, json.dumps(value, indent=1, ensure_ascii=True) + "\n")


def read_json(path):
    try:
        return json.loads(pathlib.Path(path).read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return None


@contextlib.contextmanager
def locked(path, wait=True):
    """Yields True if acquired. Child processes do not inherit the lock."""
    with open(path, "a", encoding="utf-8") as stream:
        try:
            fcntl.flock(stream, fcntl.LOCK_EX | (0 if wait else fcntl.LOCK_NB))
        except BlockingIOError:
            yield False
            return
        yield True


def little_room(folder):
    """Yields a complaint if the disk is full, which programs seldom report."""
    free = shutil.disk_usage(folder).free
    if free < 1 << 20:
        yield f"The disk is full: {free >> 10} KB are left for {str(folder)!r}. Make room first."


@contextlib.contextmanager
def output_lock(path, work, has_jobs):
    """A lock beside the pictures. Yields None, or the work folder of its owner.

    The file stays while `has_jobs`, because jobs write pictures without a waiting call."""
    while True:
        with open(path, "a+", encoding="utf-8", errors="surrogateescape") as stream:
            try:
                fcntl.flock(stream, fcntl.LOCK_EX | fcntl.LOCK_NB)
            except BlockingIOError:
                stream.seek(0)
                yield stream.read()
                return
            if not os.path.exists(path) or os.stat(path).st_ino != os.fstat(stream.fileno()).st_ino:
                continue  # the other batch has just removed it
            stream.seek(0)
            other = stream.read()
            if other not in ("", str(work)) and has_jobs(other):
                yield other
                return
            stream.truncate(0)
            stream.write(str(work))
            stream.flush()
            try:
                yield None
            finally:
                if not has_jobs(str(work)):
                    os.unlink(path)
            return


def boot():
    """Names this boot: a file written under another may be truncated."""
    try:
        return pathlib.Path("/proc/sys/kernel/random/boot_id").read_text(encoding="ascii").strip()
    except OSError:
        return os.uname().nodename


class Work:
    STATES = ("running", "done", "failed", "merged")

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        self.description = self.folder / "batch.json"
        self.lock = self.folder / "lock"
        self.inputs = self.folder / "inputs"
        self.units = self.folder / "units"
        self.logs = self.folder / "log"
        self.probe = self.folder / "probe"

    def make(self):
        for folder in (self.inputs, self.units, self.logs, *(self.folder / name for name in self.STATES)):
            folder.mkdir(parents=True, exist_ok=True)

    def names_in_it(self):
        return {
            "batch.json",
            "lock",
            "inputs",
            "units",
            "log",
            "probe",
            "summary.txt",
            "jobs.json",
            "task.sh",
            "finish.sh",
            "sheet",
            "sheet.json",
            "sheet.lock",
            *self.STATES,
        }

    def clear(self):
        for name in self.names_in_it() - {"lock"}:
            path = self.folder / name
            if path.is_dir() and not path.is_symlink():
                shutil.rmtree(path)
            else:
                path.unlink(missing_ok=True)

    def unit(self, name):
        return self.units / name

    def record(self, state, name):
        return self.folder / state / f"{name}.json"

    def names(self, state):
        try:
            entries = os.listdir(self.folder / state)
        except FileNotFoundError:
            return set()
        return {entry[:-5] for entry in entries if entry.endswith(".json") and not entry.startswith(".")}

    def log(self, task):
        return self.logs / f"task-{task:05d}.log"

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Pictures and logs of one call of ./focus, removed at its end or, after a kill, at the next start."""

import contextlib
import fcntl
import os
import pathlib
import shutil
import tempfile

PREFIX = "focus-"
LOCK = "in-use"


@contextlib.contextmanager
def folder():
    remove_left()
    made = pathlib.Path(tempfile.mkdtemp(prefix=PREFIX))
    try:
        with open(made / "new", "wb") as lock:
            fcntl.flock(lock, fcntl.LOCK_EX)
            os.rename(made / "new", made / LOCK)
            yield made
    finally:
        shutil.rmtree(made, ignore_errors=True)


def remove_left():
    """Removes only those of this user's ended calls."""
    with os.scandir(tempfile.gettempdir()) as entries:
        found = [entry.path for entry in entries if entry.name.startswith(PREFIX) and is_ours(entry)]
    for path in found:
        with contextlib.suppress(OSError), open(os.path.join(path, LOCK), "rb") as lock:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
            shutil.rmtree(path, ignore_errors=True)


def is_ours(entry):
    try:
        return entry.is_dir(follow_symlinks=False) and entry.stat(follow_symlinks=False).st_uid == os.geteuid()
    except OSError:
        return False

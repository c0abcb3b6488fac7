# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Gives a file other contents. Its owner, its rights and its links stay, and so does what somebody else has saved in it
meanwhile."""

import contextlib
import os
import shutil
import tempfile

from tools.focus.scene_text import EditError


@contextlib.contextmanager
def in_words(what):
    """@throws EditError  in place of an error of the system: what failed, and why"""
    try:
        yield
    except OSError as error:
        raise EditError(f"{what}: {error.strerror}") from error


def require_writable(path):
    """@throws EditError  where the file is protected against writing; root could write all the same"""
    with in_words("the scene's file cannot be written"):
        protected = not os.stat(path).st_mode & 0o222
    if protected or not os.access(path, os.W_OK):
        raise EditError(f"{os.path.basename(path)} is write-protected, or belongs to somebody else")


def require_same(found, expected):
    """@throws EditError  where a file holds something else than was read before"""
    if found != expected:
        raise EditError("the scene's file was changed meanwhile by somebody else")


def contents(path):
    """The bytes of a file."""
    with in_words(f"{os.path.basename(path)} cannot be read"), open(path, "rb") as stream:
        return stream.read()


def replace(path, before, after):
    """Writes new contents in place of those that were read before: in one step where the file's owner and its other
    names stay by that, and otherwise into the file itself.
    @throws EditError"""
    require_writable(path)
    with in_words("the scene's file cannot be written"):
        info = os.stat(path)
        if info.st_nlink > 1 or not replaced_in_one_step(path, info, before, after):
            write_into(path, before, after)


def replaced_in_one_step(path, info, before, after):
    """Puts a new file in the place of the old one; returns whether that can be done without another owner."""
    handle, new = tempfile.mkstemp(prefix=".focus-", dir=os.path.dirname(path))
    try:
        with open(handle, "wb") as stream:
            stream.write(after)
            stream.flush()
            os.fsync(handle)
        try:
            os.chown(new, info.st_uid, info.st_gid)
        except PermissionError:
            return False
        shutil.copystat(path, new)
        os.utime(new)
        require_same(contents(path), before)
        os.replace(new, path)
        return True
    finally:
        with contextlib.suppress(FileNotFoundError):
            os.unlink(new)


def write_into(path, before, after):
    """Writes into the file itself, once the disk has room for all of it."""
    with open(path, "r+b") as stream:
        require_same(stream.read(), before)
        try:
            os.posix_fallocate(stream.fileno(), 0, len(after))
        except OSError:
            stream.truncate(len(before))
            raise
        stream.seek(0)
        stream.write(after)
        stream.truncate()
        stream.flush()
        os.fsync(stream.fileno())

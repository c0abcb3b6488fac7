# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Replaces a file's contents, keeps owner, permissions and links, and refuses if it was changed meanwhile."""

import contextlib
import os
import shutil
import tempfile

from tools.focus.scene_text import EditError


@contextlib.contextmanager
def in_words(what):
    """@throws EditError in place of a system error"""
    try:
        yield
    except OSError as error:
        raise EditError(f"{what}: {error.strerror}") from error


def require_writable(path):
    """@throws EditError the file is write-protected, even for root"""
    with in_words("the scene's file cannot be written"):
        protected = not os.stat(path).st_mode & 0o222
    if protected or not os.access(path, os.W_OK):
        raise EditError(f"{os.path.basename(path)} is write-protected, or belongs to somebody else")


def require_same(found, expected):
    if found != expected:
        raise EditError("the scene's file was changed meanwhile by somebody else")


def contents(path):
    with in_words(f"{os.path.basename(path)} cannot be read"), open(path, "rb") as stream:
        return stream.read()


def replace(path, before, after):
    """Atomically if owner and other names stay, else by writing into the file. @throws EditError"""
    require_writable(path)
    with in_words("the scene's file cannot be written"):
        info = os.stat(path)
        if info.st_nlink > 1 or not replaced_in_one_step(path, info, before, after):
            write_into(path, before, after)


def replaced_in_one_step(path, info, before, after):
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
    """Reserves room on the disk before it overwrites anything."""
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

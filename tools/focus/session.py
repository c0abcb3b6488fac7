# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""One call of ./focus."""

import asyncio
import contextlib
import json
import os
import traceback

from tools.focus import scene_file, wrapper
from tools.focus.editor import Editor
from tools.focus.picture import TruePicture
from tools.focus.render import RenderError
from tools.focus.scene_preview import Preview
from tools.focus.scene_text import EditError
from tools.focus.tasks import started, stopped
from tools.focus.tiles import PICTURE, packed
from tools.focus.view import View

LOOK = 0.5  # seconds between looks at the scene's files


class Session:
    def __init__(self, settings, folder):
        self.settings, self.folder = settings, folder
        self.file = scene_file.SceneFile(settings.scene)
        self.views = set()
        self.number = 0
        self.previews = []  # shown by a page, or soon asked for again
        self.tasks = set()
        self.told = {}  # {kind: last message}, for pages that connect later
        self.picture = TruePicture(self)
        self.editor = Editor(self)

    async def tell(self, kind, **what):
        self.told[kind] = {"type": kind, **what}
        self.send(self.told[kind])

    def send(self, message):
        for view in self.views:
            view.send(message)

    async def send_picture_tile(self, number, left, top, values):
        self.send(packed(PICTURE, number, left, top, values))

    def connect(self, send):
        view = View(self, send)
        self.show(view)
        for kind in ("file", "picture"):
            if kind in self.told and self.told[kind].get("state") != "begun":
                view.send({**self.told[kind], "again": True})
        if self.picture.values is not None:
            view.send(packed(PICTURE, self.picture.number, 0, 0, self.picture.values))
        self.views.add(view)
        return view

    def disconnect(self, view):
        """Its preview stays until another is wanted: the page may return."""
        self.views.discard(view)
        view.preview.views.discard(view)

    def options(self, clock):
        words = [] if clock is None else [f"+K{clock!r}"]
        return [*self.settings.options.words, *wrapper.search(self.settings, self.folder), *words]

    def start_preview(self):
        self.begin(self.settings.options.clock, None, self.settings.options.size)

    def begin(self, clock, frame, size):
        self.number += 1
        preview = Preview(self, self.number, clock, frame, size)
        self.previews.append(preview)
        preview.task = started(preview.make())
        self.tasks.add(preview.task)
        preview.task.add_done_callback(self.tasks.discard)
        return preview

    def show(self, view, frame=None):
        """Other pages may show it already."""
        size = self.settings.options.size if frame is None else view.size
        key = (view.clock, frame, list(size))
        found = next((preview for preview in self.previews if preview.key == key and not preview.failed), None)
        if view.preview:
            view.preview.views.discard(view)
            self.drop_unused(found)
        preview = found or self.begin(view.clock, frame, size)
        preview.show_to(view)

    def drop_unused(self, wanted):
        options = self.settings.options
        first = (options.clock, None, list(options.size))
        for preview in self.previews.copy():
            if not preview.views and preview is not wanted and (preview.key != first or preview.failed):
                preview.task.cancel()
                self.previews.remove(preview)

    def renew_previews(self):
        former, self.previews = self.previews, []
        for preview in former:
            preview.task.cancel()
        for view in self.views:
            self.show(view)
        if not self.views:
            self.start_preview()

    def watch_files(self):
        """The clock may decide which files a scene reads."""
        self.file.watch(set().union(*(preview.files for preview in self.previews)))

    def described(self, error):
        """Prints a fault of this program as well."""
        if isinstance(error, OSError):  # such as a full disk
            error = RenderError(f"The picture cannot be made: {error.strerror}")
        elif isinstance(error, EditError):
            error = RenderError(str(error))
        elif not isinstance(error, RenderError):
            traceback.print_exception(error)
            error = RenderError(f"./focus has a fault: {error!r}")
        told = {"message": error.message, "file": error.file, "line": error.line, "text": None}
        if error.file and error.line:
            with contextlib.suppress(OSError, IndexError):
                lines = open(error.file, encoding="utf-8", errors="replace").read().splitlines()
                told["text"] = lines[error.line - 1]
            told["file"] = os.path.basename(os.path.realpath(error.file))
        return told

    async def watch(self):
        while True:
            await asyncio.sleep(LOOK)
            changed = self.file.changed()
            if changed:
                self.send({"type": "changed", "files": [os.path.basename(name) for name in changed]})
                self.renew_previews()

    async def end(self):
        for task in (*self.tasks, self.picture.task, self.editor.task):
            await stopped(task)


def as_text(message):
    """@throws ValueError for non-finite numbers"""
    return json.dumps(message, allow_nan=False)

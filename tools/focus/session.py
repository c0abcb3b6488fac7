# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The state of one call of ./focus: the preview, the true picture, the changes to the file."""

import asyncio
import contextlib
import json
import math
import os
import struct
import time
import traceback

import numpy

from tools.focus import scene_file, scene_text, wrapper
from tools.focus.editor import Editor
from tools.focus.picture import TruePicture
from tools.focus.render import Render, RenderError
from tools.focus.scene_text import EditError
from tools.focus.tasks import started, stopped

PREVIEW, PICTURE = 1, 2  # kind of a tile
LOOK = 0.5  # seconds between looks at the scene's files
REFINE = ["+A0.1", "+AM2", "+R2"]  # antialiasing in the second pass of the preview
REFINED_BELOW = 30  # seconds; a slower preview gets no second pass


def packed(kind, number, left, top, values):
    """A rectangle of values in the page's format: six whole numbers, then the values."""
    rows, columns = values.shape[:2]
    head = struct.pack("<6I", kind, number, left, top, columns, rows)
    return head + numpy.ascontiguousarray(values).tobytes()


class Session:
    """The scene, its renders, and their viewers."""

    def __init__(self, settings, folder):
        self.settings, self.folder = settings, folder
        self.file = scene_file.SceneFile(settings.scene)
        self.size = list(settings.options.size)
        self.clock = settings.options.clock
        self.send = None  # set by the server: takes a dict, or bytes
        self.number = 0  # of the preview
        self.frame = None  # the preview's requested camera; None: the scene's own
        self.values = None  # rows, columns, 4: red, green, blue, 1/depth
        self.covered = 0  # number of pixels received
        self.record = None  # the program's camera record
        self.record_stamp = None  # of the recorded file
        self.chosen = None  # index of the camera; None: the scene's own
        self.told = {}  # kind of message -> the last one, for pages that connect later
        self.preview_task = None
        self.picture = TruePicture(self)
        self.editor = Editor(self)

    # ---- to the page ----

    async def tell(self, kind, **what):
        """Sends a message, and keeps it for pages that connect later."""
        message = {"type": kind, **what}
        self.told[kind] = message
        await self.send(message)

    def everything(self):
        """All messages for a new page, in order."""
        for kind in ("error", "scene", "preview", "file", "picture"):
            if kind == "preview" and self.values is not None:
                height, width = self.values.shape[:2]
                yield {"type": "preview", "number": self.number, "frame": self.frame, "state": "begun", "size": [width, height]}
                yield packed(PREVIEW, self.number, 0, 0, self.values)
            if kind in self.told and self.told[kind].get("state") != "begun":
                yield {**self.told[kind], "again": True}
            if kind == "picture" and self.picture.values is not None:
                yield packed(PICTURE, self.picture.number, 0, 0, self.picture.values)

    async def send_picture_tile(self, number, left, top, values):
        """Sends a rectangle of the true picture."""
        await self.send(packed(PICTURE, number, left, top, values))

    # ---- the preview ----

    def options(self):
        """The user's options, with the page's clock."""
        clock = [] if self.clock is None else [f"+K{self.clock!r}"]
        return [*self.settings.options.words, *wrapper.search(self.settings, self.folder), *clock]

    def start_preview(self, frame=None):
        """Starts a preview of the scene's own camera, or of a frame."""
        self.preview_task = started(self.preview(frame, self.preview_task))

    async def preview(self, frame, previous):
        """Makes the preview, after stopping the previous one."""
        await stopped(previous)
        self.number += 1
        self.frame = frame
        begun = time.monotonic()
        try:
            await self.pass_over(frame, [])
            seconds = time.monotonic() - begun
            await self.tell("preview", number=self.number, frame=frame, state="done", seconds=seconds)
            if seconds < REFINED_BELOW:
                await self.pass_over(frame, REFINE, refining=True)
        except Exception as error:  # pylint: disable=broad-except
            await self.tell("error", **self.described(error))

    async def pass_over(self, frame, more, refining=False):
        """One run of the program for the preview."""
        scene = self.settings.scene
        if frame is not None:
            scene = wrapper.write(self.folder, self.settings.scene, frame, "")
        width, height = self.size
        if not refining:
            self.values = None
            await self.tell("preview", number=self.number, frame=frame, state="begun", size=[width, height])
            self.values, self.covered = numpy.zeros((height, width, 4), "<f4"), 0
        render = Render(self.settings.program, self.folder, f"preview{self.number}", background=refining)
        render.file_list = self.folder / "files"
        fitting = None
        stamp = scene_file.stamp(self.file.path)

        async def on_camera(record):
            nonlocal fitting
            if refining or frame is not None:
                return
            self.take_record(record, stamp)
            fitting = self.fitting_size(record["view"])
            if fitting:
                await render.stop()
                return
            await self.tell("error", message=None)
            await self.tell_scene()

        async def on_tile(tile):
            await self.take_preview_tile(tile, refining)

        words = render.words(scene, [*self.options(), "-A", *more, "+N"], (width, height))
        try:
            await render.run(words, True, on_tile, on_camera)
        finally:
            for path in (render.picture, render.picture.with_suffix(".layers.exr")):
                path.unlink(missing_ok=True)
        if fitting:
            self.size = fitting
            await self.pass_over(frame, more)
        elif not refining:
            self.file.watch(render.file_list, self.folder)

    async def take_preview_tile(self, tile, refining):
        """Stores a tile of the preview and sends it."""
        part = tile.colours if tile.layers is None else tile.layers["depth.Z"]
        rows, columns = part.shape[:2]
        place = self.values[tile.top : tile.top + rows, tile.left : tile.left + columns]
        if tile.layers is not None:  # precedes the tile's colours
            with numpy.errstate(divide="ignore"):
                place[:, :, 3] = 1 / part
            return
        # A lamp's edge keeps its first colours: an antialiased mean of lamp and background, taken for background, would spread over the
        # background's blur.
        smooth = numpy.maximum(part, place[:, :, :3]).max(2) <= 1 if refining else numpy.full((rows, columns), True)
        place[smooth, :3] = part[smooth]
        await self.send(packed(PREVIEW, self.number, tile.left, tile.top, place))
        if not refining:
            self.covered += rows * columns
            share = self.covered / (self.size[0] * self.size[1])
            await self.send({"type": "progress", "what": "preview", "share": share})

    def fitting_size(self, view):
        """The size for the camera's own proportions if the user gave none; None if it is the same."""
        ratio = math.dist(view["right"], [0] * 3) / math.dist(view["up"], [0] * 3)
        width, height = self.size
        if self.settings.options.size_given or not 0.1 < ratio < 10 or abs(ratio / (width / height) - 1) < 0.01:
            return None
        return [width, max(2, round(width / ratio))]

    # ---- the cameras ----

    def take_record(self, record, stamp):
        """Stores the camera record of the file with that stamp."""
        self.record, self.record_stamp = record, stamp
        if self.chosen is not None and self.chosen >= len(record["cameras"]):
            self.chosen = None

    def is_own(self, camera):
        """True if the camera statement is in the scene's own file."""
        return os.path.realpath(camera["file"]) == self.file.path

    def index_in_use(self):
        """Index of the camera statement that the scene is rendered with, or None."""
        keys = ("location", "direction", "right", "up", "block")
        view = self.record["view"]
        same = [i for i, c in enumerate(self.record["cameras"]) if all(c[key] == view[key] for key in keys)]
        return same[-1] if same else None

    def kept(self, camera):
        """Items of a camera's block that the page does not write, as text; none if the text cannot be parsed."""
        try:
            return scene_text.kept_at(self.file.text(), camera["line"]) or [] if self.is_own(camera) else []
        except EditError:
            return []

    def kept_in_picture(self):
        """Such items of the shown camera that the true picture has as well."""
        index = self.index_in_use() if self.chosen is None else self.chosen
        found = [self.kept(camera) for camera in self.record["cameras"][index : index + 1]] if index is not None else []
        return [item for items in found for item in items if item.split()[0] not in scene_text.AIDS]

    async def tell_scene(self):
        """Sends the scene and its cameras."""
        cameras = [{**camera, "own": self.is_own(camera), "kept": self.kept(camera)} for camera in self.record["cameras"]]
        await self.tell(
            "scene",
            name=os.path.basename(self.settings.scene),
            cameras=cameras,
            view=self.record["view"],
            used=self.index_in_use(),
            gamma=self.record["gamma"],
            clock=self.clock,
            clocks=self.settings.options.clocks,
            animated=self.file.uses_clock(),
            lenses=self.settings.lenses,
            size=self.size,
        )

    def described(self, error):
        """An error for the page, with its line. Prints a fault of this program as well."""
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
        """Watches the scene's files; a change starts a new preview."""
        while True:
            await asyncio.sleep(LOOK)
            changed = self.file.changed()
            if changed:
                await self.send({"type": "changed", "files": [os.path.basename(name) for name in changed]})
                self.start_preview()

    async def end(self):
        """Stops all runs."""
        for task in (self.preview_task, self.picture.task, self.editor.task):
            await stopped(task)


def as_text(message):
    """A message as JSON. @throws ValueError  for non-finite numbers"""
    return json.dumps(message, allow_nan=False)

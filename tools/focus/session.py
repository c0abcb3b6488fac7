# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""What one call of ./focus knows of its scene: the preview, the true picture, the changes to the file."""

import asyncio
import contextlib
import json
import math
import os
import struct
import time
import traceback

import numpy

from tools.focus import scene_file, wrapper
from tools.focus.povray import Render, RenderError

PREVIEW, PICTURE = 1, 2  # what a tile belongs to
LOOK = 0.5  # seconds between two looks at the scene's files
REFINE = ["+A0.1", "+AM2", "+R2"]  # of the second pass of the preview: smooth edges
REFINED_BELOW = 30  # seconds; a preview that took longer is not made twice


def display(colours, gamma):
    """Colours as a screen shows them, bytes with alpha."""
    colours = numpy.clip(numpy.nan_to_num(colours), 0, 1)
    if gamma is not None and gamma != "sRGB":
        light = colours ** float(gamma)
        colours = numpy.where(light <= 0.0031308, 12.92 * light, 1.055 * light ** (1 / 2.4) - 0.055)
    bytes_ = numpy.full((*colours.shape[:2], 4), 255, numpy.uint8)
    bytes_[:, :, :3] = numpy.rint(colours * 255)
    return bytes_


def told_of_fault(task):
    """Prints the fault that ended a task, which nobody waits for."""
    if not task.cancelled() and task.exception():
        traceback.print_exception(task.exception())


def packed(kind, number, left, top, values):
    """A rectangle of values as the page reads it: six whole numbers, then the values."""
    rows, columns = values.shape[:2]
    head = struct.pack("<6I", kind, number, left, top, columns, rows)
    return head + numpy.ascontiguousarray(values).tobytes()


class Session:
    """The scene, its renders, and who looks at them."""

    def __init__(self, settings, folder):
        self.settings, self.folder = settings, folder
        self.file = scene_file.SceneFile(settings.scene)
        self.size = list(settings.size)
        self.clock = None
        self.send = None  # set by the server: takes a dict, or bytes
        self.number = 0  # of the preview
        self.frame = None  # the camera that the preview was asked with, or None: the scene's own
        self.values = None  # rows, columns, 4: red, green, blue, 1/depth
        self.covered = 0  # pixels of it that are there
        self.record = None  # what the program told of the cameras
        self.record_stamp = None  # of the file that it told of
        self.chosen = None  # index of the camera, or None: the scene's own
        self.told = {}  # kind of message -> the last one, for a page that comes later
        self.preview_task = self.picture_task = None
        self.picture_number, self.picture_values, self.picture_file = 0, None, None

    # ---- to the page ----

    async def tell(self, kind, **what):
        """Sends a message, and keeps it for pages that come later."""
        message = {"type": kind, **what}
        self.told[kind] = message
        await self.send(message)

    def everything(self):
        """All that a new page has to know, in order."""
        for kind in ("error", "scene", "preview", "file", "picture"):
            if kind == "preview" and self.values is not None:
                height, width = self.values.shape[:2]
                yield {"type": "preview", "number": self.number, "frame": self.frame, "state": "begun", "size": [width, height]}
                yield packed(PREVIEW, self.number, 0, 0, self.values)
            if kind in self.told and self.told[kind].get("state") != "begun":
                yield {**self.told[kind], "again": True}
            if kind == "picture" and self.picture_values is not None:
                yield packed(PICTURE, self.picture_number, 0, 0, self.picture_values)

    # ---- the preview ----

    def options(self):
        """The user's options, with the clock of the page."""
        clock = [] if self.clock is None else [f"+K{self.clock!r}"]
        return [*self.settings.options, *wrapper.search(self.settings), *clock]

    def start_preview(self, frame=None):
        """Begins a preview: of the scene's own camera, or of a frame."""
        self.preview_task = asyncio.create_task(self.preview(frame, self.preview_task))
        self.preview_task.add_done_callback(told_of_fault)

    async def preview(self, frame, previous):
        """Makes the preview, after the one before it was stopped."""
        if previous and not previous.done():
            previous.cancel()
            with contextlib.suppress(asyncio.CancelledError):
                await previous
        self.number += 1
        self.frame = frame
        begun = time.monotonic()
        try:
            await self.pass_over(frame, [])
            seconds = time.monotonic() - begun
            await self.tell("preview", number=self.number, frame=frame, state="done", seconds=seconds)
            if seconds < REFINED_BELOW:
                await self.pass_over(frame, REFINE, refining=True)
        except (RenderError, OSError) as error:
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
        render = Render(self.settings.program, self.folder, f"preview{self.number}")
        render.file_list = self.folder / "files"
        fitting = None
        stamp = scene_file.stamp(self.file.path)

        async def on_camera(record):
            nonlocal fitting
            if refining or frame is not None:
                return
            self.record, self.record_stamp = record, stamp
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
        """Notes a tile of the preview and sends it."""
        part = tile.colours if tile.layers is None else tile.layers["depth.Z"]
        rows, columns = part.shape[:2]
        place = self.values[tile.top : tile.top + rows, tile.left : tile.left + columns]
        if tile.layers is not None:  # comes before the tile's colours
            with numpy.errstate(divide="ignore"):
                place[:, :, 3] = 1 / part
            return
        # A lamp's edge keeps its first colours: a mean of lamp and background, taken for background, would be spread
        # over the blur of the background.
        smooth = numpy.maximum(part, place[:, :, :3]).max(2) <= 1 if refining else numpy.full((rows, columns), True)
        place[smooth, :3] = part[smooth]
        await self.send(packed(PREVIEW, self.number, tile.left, tile.top, place))
        if not refining:
            self.covered += rows * columns
            share = self.covered / (self.size[0] * self.size[1])
            await self.send({"type": "progress", "what": "preview", "share": share})

    def fitting_size(self, view):
        """The size that suits the camera's own proportions where the user gave none, if it is another."""
        ratio = math.dist(view["right"], [0] * 3) / math.dist(view["up"], [0] * 3)
        width, height = self.size
        if self.settings.size_given or not 0.1 < ratio < 10 or abs(ratio / (width / height) - 1) < 0.01:
            return None
        return [width, max(2, round(width / ratio))]

    async def tell_scene(self):
        """Tells the page of the scene and its cameras."""
        main = os.path.realpath(self.settings.scene)
        cameras = [
            {**camera, "own": os.path.realpath(camera["file"]) == main} for camera in self.record["cameras"]
        ]
        await self.tell(
            "scene",
            name=os.path.basename(self.settings.scene),
            cameras=cameras,
            view=self.record["view"],
            gamma=self.record["gamma"],
            clock=self.clock,
            animated=self.file.uses_clock(),
            lenses=self.settings.lenses,
            size=self.size,
        )

    def described(self, error):
        """An error as the page shows it, with the line of the file."""
        if isinstance(error, OSError):  # such as a full disk
            error = RenderError(f"The picture cannot be made: {error.strerror}")
        told = {"message": error.message, "file": error.file, "line": error.line, "text": None}
        if error.file and error.line:
            with contextlib.suppress(OSError, IndexError):
                lines = open(error.file, encoding="utf-8", errors="replace").read().splitlines()
                told["text"] = lines[error.line - 1]
            told["file"] = os.path.basename(error.file)
        return told

    # ---- the true picture ----

    def start_picture(self, request):
        """Begins the true picture."""
        self.stop_picture()
        self.picture_number += 1
        self.picture_task = asyncio.create_task(self.picture(self.picture_number, request, self.picture_task))
        self.picture_task.add_done_callback(told_of_fault)

    def stop_picture(self):
        """Ends the true picture as far as it is."""
        if self.picture_task and not self.picture_task.done():
            self.picture_task.cancel()

    async def picture(self, number, request, previous):
        """Renders the scene with the page's camera."""
        if previous:
            with contextlib.suppress(asyncio.CancelledError):
                await previous
        width, height = request["size"]
        gamma = self.record["gamma"]
        self.picture_file = None
        self.picture_values = numpy.zeros((height, width, 4), numpy.uint8)
        begun = time.monotonic()

        async def state(name, covered, **more):
            share = covered / (width * height)
            seconds = time.monotonic() - begun
            await self.tell("picture", number=number, size=[width, height], state=name, share=share, seconds=seconds, **more)

        covered = 0

        async def on_tile(tile):
            nonlocal covered
            if tile.colours is None:
                return
            values = display(tile.colours, gamma)
            rows, columns = values.shape[:2]
            self.picture_values[tile.top : tile.top + rows, tile.left : tile.left + columns] = values
            covered += rows * columns
            await self.send(packed(PICTURE, number, tile.left, tile.top, values))
            await state("growing", covered)

        render = Render(self.settings.program, self.folder, "picture")
        scene = wrapper.write(self.folder, self.settings.scene, request["camera"], request["inside"], "picture_scene")
        await state("begun", 0)
        try:
            await render.run(render.words(scene, self.options(), (width, height)), False, on_tile)
            self.picture_file = render.picture
            await state("done", width * height)
        except (RenderError, OSError) as error:
            await state("failed", covered, **self.described(error))
        except asyncio.CancelledError:
            await state("stopped", covered)
            raise

    # ---- the file ----

    async def write(self, request):
        """Puts the block into the scene's file, if the program then finds the same lens in it."""
        try:
            await self.renew_record()
            camera = self.camera_to_change()
            text = self.file.with_block(camera["line"], request["block"], request["items"])
            await self.check(text, request["expect"])
            kept = self.file.replace(text)
        except (scene_file.Doubt, RenderError, OSError) as error:
            reason = error.message if isinstance(error, RenderError) else str(error)
            await self.tell("file", state="refused", reason=reason)
            return
        await self.tell("file", state="written", kept=kept)

    async def look_at(self, path, name):
        """What the program tells of the cameras of a file, by one pixel of it."""

        async def nothing(_):
            return

        render = Render(self.settings.program, self.folder, name)
        words = render.words(path, [*self.options(), "-A"], self.size)
        await render.run([*words, "+SR1", "+ER1", "+SC1", "+EC1"], True, nothing)
        return render.camera()

    async def renew_record(self):
        """Sees to it that the lines of the cameras are those of the file as it is."""
        if self.record_stamp != scene_file.stamp(self.file.path):
            stamp = scene_file.stamp(self.file.path)
            self.record, self.record_stamp = await self.look_at(self.settings.scene, "renewed"), stamp

    def camera_to_change(self):
        """The camera statement that the page shows."""
        cameras, view = self.record["cameras"], self.record["view"]
        keys = ("location", "direction", "right", "up", "block")
        index = self.chosen
        if index is None:
            same = [i for i, c in enumerate(cameras) if all(c[key] == view[key] for key in keys)]
            if not same:
                raise scene_file.Doubt("no camera statement of the scene is the one in use")
            index = same[-1]
        camera = cameras[index]
        if os.path.realpath(camera["file"]) != os.path.realpath(self.settings.scene):
            raise scene_file.Doubt(f"the camera stands in another file, {os.path.basename(camera['file'])}")
        if camera["block"] and abs(camera["block"]["scale"] - 1) > 1e-9:
            raise scene_file.Doubt("the camera is scaled")
        return camera

    async def check(self, text, expected):
        """@throws Doubt  unless the program finds the wanted lens in the changed text"""
        path = self.folder / "changed.pov"
        path.write_bytes(self.file.encoded(text))
        found = await self.look_at(path, "changed")
        camera = found["view"] if self.chosen is None else found["cameras"][self.chosen]
        wrong = scene_file.differences(camera, expected)
        if wrong:
            raise scene_file.Doubt("the changed scene would have another " + ", ".join(wrong))

    async def undo(self):
        """Takes the last change of the file back."""
        try:
            self.file.undo()
        except (scene_file.Doubt, OSError) as error:
            await self.tell("file", state="refused", reason=str(error))
            return
        await self.tell("file", state="undone")

    async def watch(self):
        """Looks at the scene's files for ever; a change begins a new preview."""
        while True:
            await asyncio.sleep(LOOK)
            changed = self.file.changed()
            if changed:
                await self.send({"type": "changed", "files": [os.path.basename(name) for name in changed]})
                self.start_preview()

    async def end(self):
        """Stops all that runs."""
        for task in (self.preview_task, self.picture_task):
            if task:
                task.cancel()
                with contextlib.suppress(asyncio.CancelledError, Exception):
                    await task


def as_text(message):
    """A message as JSON; what is not finite has no place in it."""
    return json.dumps(message, allow_nan=False)

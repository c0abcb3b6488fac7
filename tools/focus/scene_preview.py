# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The scene as a pinhole sees it, with distances, sent to its pages while it grows."""

import math
import os
import time

import numpy

from tools.focus import wrapper
from tools.focus.record import Record
from tools.focus.render import Render
from tools.focus.tiles import PREVIEW, packed

REFINE = ["+A0.1", "+AM2", "+R2"]  # antialiasing in the second pass
REFINED_BELOW = 30  # seconds; a slower preview gets no second pass


class Preview:
    """For all pages at one clock. `frame`: requested camera; None: the scene's."""

    def __init__(self, session, number, clock, frame, size):
        self.session, self.number, self.clock, self.frame = session, number, clock, frame
        self.key = (clock, frame, list(size))
        self.size = list(size)
        self.views = set()
        self.values = None  # rows, columns, 4: red, green, blue, 1/depth
        self.covered = 0
        self.record = None
        self.files = set(session.file.stamps)
        self.told = {}  # {kind: last message}, for pages that come later
        self.task = None

    @property
    def failed(self):
        """Another try may succeed."""
        return bool(self.told.get("error", {}).get("message"))

    def tell(self, kind, **what):
        self.told[kind] = {"type": kind, **what}
        self.send(self.told[kind])

    def send(self, message):
        for view in self.views:
            view.send(message)

    def show_to(self, view):
        self.views.add(view)
        view.preview = self
        if self.record:
            view.take(self.record, self.size)
        for kind in ("error", "scene"):
            if kind in self.told:
                view.send(self.told[kind])
        if self.values is not None:
            view.send({"type": "preview", **self.head(), "state": "begun", "size": self.size})
            view.send(packed(PREVIEW, self.number, 0, 0, self.values))
            if self.told["preview"]["state"] == "done":
                view.send(self.told["preview"])
        if "refined" in self.told:
            view.send(self.told["refined"])

    def head(self):
        return {"number": self.number, "frame": self.frame}

    async def make(self):
        begun = time.monotonic()
        try:
            await self.pass_over([])
            seconds = time.monotonic() - begun
            self.tell("preview", **self.head(), state="done", seconds=seconds)
            if seconds < REFINED_BELOW:
                await self.pass_over(REFINE, refining=True)
            self.tell("refined", number=self.number)
        except Exception as error:  # pylint: disable=broad-except
            self.tell("error", **self.session.described(error))

    async def pass_over(self, more, refining=False):
        session, frame, name = self.session, self.frame, f"preview{self.number}"
        scene = session.settings.scene
        if frame is not None:
            scene = wrapper.write(session.folder, scene, frame, "", f"{name}_scene")
        if not refining:
            self.begin()
        render = Render(session.settings.program, session.folder, name, background=refining)
        render.file_list = session.folder / f"{name}.files"
        stamp, again = session.file.stamp(), None  # again: the size, if the pass must be repeated

        async def on_camera(found):
            nonlocal again
            if refining or frame is not None:
                return
            changed = session.file.stamp() != stamp
            again = self.fitting_size(found["view"]) or (self.size if changed else None)
            if again:
                await render.stop()
                return
            self.take_record(Record(found, session.file, stamp))

        async def on_tile(tile):
            self.take_tile(tile, refining)

        words = render.words(scene, [*session.options(self.clock), "-A", *more, "+N"], self.size)
        try:
            await render.run(words, True, on_tile, on_camera)
            if not refining and not again:
                self.files = session.file.files_read(render.file_list, session.folder)
                session.watch_files()
        finally:
            for path in (render.picture, render.picture.with_suffix(".layers.exr"), render.file_list):
                path.unlink(missing_ok=True)
        if again:
            self.size = again
            await self.pass_over(more)

    def begin(self):
        width, height = self.size
        self.tell("preview", **self.head(), state="begun", size=self.size)
        self.values, self.covered = numpy.zeros((height, width, 4), "<f4"), 0

    def take_record(self, record):
        self.record = record
        for view in self.views:
            view.take(record, self.size)
        self.tell("error", message=None)
        session = self.session
        self.tell(
            "scene",
            name=os.path.basename(session.settings.scene),
            stamp=record.stamp,
            cameras=[{**camera, "own": record.is_own(camera), "kept": record.kept(camera)} for camera in record.cameras],
            view=record.view,
            used=record.index_in_use(),
            gamma=record.gamma,
            clock=self.clock,
            clocks=session.settings.options.clocks,
            animated=session.file.uses_clock(),
            lenses=session.settings.lenses,
            size=self.size,
        )

    def take_tile(self, tile, refining):
        part = tile.colours if tile.layers is None else tile.layers["depth.Z"]
        rows, columns = part.shape[:2]
        place = self.values[tile.top : tile.top + rows, tile.left : tile.left + columns]
        if tile.layers is not None:  # precedes the tile's colours
            with numpy.errstate(divide="ignore"):
                place[:, :, 3] = 1 / part
            return
        # A lamp's edge keeps its first colours: a mean of lamp and background would spread over the background's blur.
        smooth = numpy.maximum(part, place[:, :, :3]).max(2) <= 1 if refining else numpy.full((rows, columns), True)
        place[smooth, :3] = part[smooth]
        self.send(packed(PREVIEW, self.number, tile.left, tile.top, place))
        if not refining:
            self.covered += rows * columns
            self.send({"type": "progress", "what": "preview", "share": self.covered / (self.size[0] * self.size[1])})

    def fitting_size(self, view):
        """The camera's own proportions; None if unchanged."""
        ratio = math.dist(view["right"], [0] * 3) / math.dist(view["up"], [0] * 3)
        width, height = self.size
        if self.session.settings.options.size_given or not 0.1 < ratio < 10 or abs(ratio / (width / height) - 1) < 0.01:
            return None
        return [width, max(2, round(width / ratio))]

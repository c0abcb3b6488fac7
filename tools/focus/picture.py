# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The true picture, sent to the page while it grows."""

import asyncio
import time

import numpy

from tools.focus import wrapper
from tools.focus.render import Render
from tools.focus.tasks import ended, started


def display(colours, gamma):
    colours = numpy.clip(numpy.nan_to_num(colours), 0, 1)
    if gamma is not None and gamma != "sRGB":
        light = colours ** float(gamma)
        colours = numpy.where(light <= 0.0031308, 12.92 * light, 1.055 * light ** (1 / 2.4) - 0.055)
    bytes_ = numpy.full((*colours.shape[:2], 4), 255, numpy.uint8)
    bytes_[:, :, :3] = numpy.rint(colours * 255)
    return bytes_


class TruePicture:
    """`number` counts requests; `values` (rows, columns, 4) are the pixels so far."""

    def __init__(self, session):
        self.session = session
        self.number, self.values, self.file, self.task = 0, None, None, None

    def start(self, request, view):
        self.stop()
        self.number += 1
        request["lens"]["clock"] = view.clock
        self.task = started(self.render(self.number, request, view.options(), view.record.gamma, self.task))

    def stop(self):
        if self.task and not self.task.done():
            self.task.cancel()

    async def render(self, number, request, options, gamma, previous):
        await ended(previous)
        session, (width, height) = self.session, request["size"]
        self.file = self.values = None
        begun = time.monotonic()
        covered = 0

        async def state(name, **more):
            share, seconds = covered / (width * height), time.monotonic() - begun
            told = {"number": number, "size": [width, height], "lens": request["lens"], "state": name, "share": share, "seconds": seconds}
            await session.tell("picture", **told, **more)

        async def on_tile(tile):
            nonlocal covered
            if tile.colours is None:
                return
            values = display(tile.colours, gamma)
            rows, columns = values.shape[:2]
            self.values[tile.top : tile.top + rows, tile.left : tile.left + columns] = values
            covered += rows * columns
            await session.send_picture_tile(number, tile.left, tile.top, values)
            await state("growing")

        render = Render(session.settings.program, session.folder, "picture", background=True)
        await state("begun")
        try:
            self.values = numpy.zeros((height, width, 4), numpy.uint8)
            scene = wrapper.write(session.folder, session.settings.scene, request["camera"], request["inside"], "picture_scene")
            await render.run(render.words(scene, options, (width, height)), False, on_tile)
            self.file, covered = render.picture, width * height
            await state("done")
        except Exception as error:  # pylint: disable=broad-except
            await state("failed", **session.described(error))
        except asyncio.CancelledError:
            await state("stopped")
            raise

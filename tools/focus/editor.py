# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Puts the page's block into the scene's file, only where the program then finds the page's lens in it."""

import os

from tools.focus import scene_file, scene_text
from tools.focus.povray import Render
from tools.focus.scene_text import EditError
from tools.focus.tasks import ended, started


class Editor:
    """Writes and undoes for one session."""

    def __init__(self, session):
        self.session = session
        self.task = None  # the last of them; each begins when the one before it is over

    def start(self, request):
        """Puts the block into the scene's file."""
        self.begin(lambda: self.write(request), "refused", self.tell_all)

    def start_undo(self):
        """Takes the last change of the file back."""
        self.begin(self.undo, "refused", self.tell_all)

    def start_trial(self, request, tell):
        """Finds out whether the block would do in the scene's file; `tell` takes the answer."""
        self.begin(lambda: self.tried(request), "untried", tell)

    async def tell_all(self, told):
        """Tells all pages what has become of the file."""
        await self.session.tell("file", **told)

    def begin(self, work, failed, tell):
        """Begins something when the one before it is over."""
        self.task = started(self.answered(work, failed, tell, self.task))

    async def answered(self, work, failed, tell, previous):
        """Does it, and tells what has become of it."""
        await ended(previous)
        try:
            told = await work()
        except Exception as error:  # pylint: disable=broad-except
            told = {"state": failed, "reason": self.session.described(error)["message"]}
        await tell(told)

    async def change(self, request):
        """The contents of the scene's file as they are, and with the block, in which the program has found the page's lens."""
        session = self.session
        await self.renew_record()
        camera = self.camera_to_change()
        before = session.file.bytes()
        text = session.file.decoded(before)
        if camera["block"] and scene_text.kept_at(text, camera["line"]) is None:
            raise EditError("the camera's tilt_lens block comes from a macro or another file")
        after = session.file.encoded(scene_text.with_block(text, camera["line"], request["block"], request["items"]))
        await self.check(after, request["expect"])
        return before, after

    async def write(self, request):
        """Changes the file; returns the answer to the page."""
        return {"state": "written", "kept": self.session.file.replace(*await self.change(request))}

    async def tried(self, request):
        """Changes nothing; returns the answer to the page."""
        await self.change(request)
        return {"state": "tried"}

    async def undo(self):
        """Puts the file back as it was; returns the answer to the page."""
        self.session.file.undo()
        return {"state": "undone"}

    async def look_at(self, path, name):
        """What the program tells of the cameras of a file, by one pixel of it."""

        async def nothing(_):
            return

        session = self.session
        render = Render(session.settings.program, session.folder, name)
        words = render.words(path, [*session.options(), "-A"], session.size)
        await render.run([*words, "+SR1", "+ER1", "+SC1", "+EC1"], True, nothing)
        return render.camera()

    async def renew_record(self):
        """Sees to it that the lines of the cameras are those of the file as it is."""
        session = self.session
        stamp = scene_file.stamp(session.file.path)
        if session.record_stamp != stamp:
            session.take_record(await self.look_at(session.settings.scene, "renewed"), stamp)

    def camera_to_change(self):
        """The camera statement that the page shows.
        @throws EditError  where there is none that can be changed"""
        session = self.session
        cameras, index = session.record["cameras"], session.chosen
        if index is None:
            index = session.index_in_use()
        if index is None:
            raise EditError("no camera statement of the scene is the one in use")
        camera = cameras[index]
        if not session.is_own(camera):
            raise EditError(f"the camera stands in another file, {os.path.basename(camera['file'])}")
        return camera

    async def check(self, data, expected):
        """@throws EditError  unless the program finds the wanted lens in the changed scene"""
        session = self.session
        path = session.folder / "changed.pov"
        path.write_bytes(data)
        found = await self.look_at(path, "changed")
        camera = found["view"] if session.chosen is None else found["cameras"][session.chosen]
        wrong = scene_file.differences(camera, expected)
        if wrong:
            raise EditError("the changed scene would have another " + ", ".join(wrong))

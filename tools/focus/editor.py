# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Writes the page's block into the scene's file, after checking that the program then finds the page's lens in it."""

import os

from tools.focus import scene_file, scene_text
from tools.focus.render import Render, RenderError
from tools.focus.scene_text import EditError
from tools.focus.tasks import ended, started


class Editor:
    """Writes and undoes for one session."""

    def __init__(self, session):
        self.session = session
        self.added = 0  # cameras that the last change added before the one with the lens
        self.task = None  # the last task; tasks run one after the other

    def start(self, request):
        """Writes the block into the scene's file."""
        self.begin(lambda: self.write(request), "refused", self.tell_all)

    def start_undo(self):
        """Undoes the last change of the file."""
        self.begin(self.undo, "refused", self.tell_all)

    def start_trial(self, request, tell):
        """Checks whether the block would do in the scene's file; `tell` receives the answer."""
        self.begin(lambda: self.tried(request), "untried", tell)

    def start_pull(self, request, tell):
        """Writes a focus pull, or checks whether it would do; `tell` receives the answer to the latter."""
        if request["write"]:
            self.begin(lambda: self.pulled(request), "refused", lambda told: self.tell_all({**told, "pull": True}))
        else:
            self.begin(lambda: self.pulled(request), "untried", lambda told: tell({**told, "pull": True}))

    async def tell_all(self, told):
        """Tells all pages the result."""
        await self.session.tell("file", **told)

    def begin(self, work, failed, tell):
        """Starts a task after the one before."""
        self.task = started(self.answered(work, failed, tell, self.task))

    async def answered(self, work, failed, tell, previous):
        """Runs a task and tells the result."""
        await ended(previous)
        try:
            told = await work()
        except Exception as error:  # pylint: disable=broad-except
            told = {"state": failed, "reason": self.session.described(error)["message"]}
        await tell(told)

    async def change(self, request):
        """The file's contents, the contents with the block, which the program has checked, and the number of cameras added before the one
        with the lens."""
        session = self.session
        await self.renew_record()
        index = self.index_to_change()
        camera, before = session.record["cameras"][index], session.file.bytes()
        text, behind = session.file.decoded(before), request["behind"]
        reason = None
        for added, changed, expected in (
            (0, lambda: self.in_camera(camera, text, request), request["expect"]),
            (1, lambda: scene_text.behind_camera(text, camera["line"], behind["block"]), behind["expect"]),
        ):
            try:
                after = session.file.encoded(changed())
                await self.check(after, camera, added, expected)
                return before, after, added
            except (EditError, RenderError) as error:
                reason = reason or error
        raise reason

    @staticmethod
    def in_camera(camera, text, request):
        """The scene's text with the block in the camera, in place of the old block."""
        if camera["block"] and scene_text.kept_at(text, camera["line"]) is None:
            raise EditError("the camera's tilt_lens block comes from a macro or another file")
        return scene_text.with_block(text, camera["line"], request["block"], request["items"])

    async def write(self, request):
        """Changes the file; returns the answer for the page."""
        return self.replaced(*await self.change(request))

    def replaced(self, before, after, added):
        """Replaces the file's contents; returns the answer for the page."""
        kept = self.session.file.replace(before, after)
        self.choose(added)
        return {"state": "written", "kept": kept, "chosen": self.session.chosen}

    async def pulled(self, request):
        """Writes a focus pull if the program finds its lenses at some times; returns the answer for the page."""
        session = self.session
        await self.renew_record()
        camera, before = session.record["cameras"][self.index_to_change()], session.file.bytes()
        text = session.file.decoded(before)
        after = session.file.encoded(scene_text.with_head(self.in_camera(camera, text, request), text, camera["line"], request["head"]))
        for check in request["checks"]:
            await self.check(after, camera, 0, check["expect"], [f"+K{check['time']!r}"])
        return self.replaced(before, after, 0) if request["write"] else {"state": "tried"}

    async def tried(self, request):
        """Changes nothing; returns the answer for the page."""
        await self.change(request)
        return {"state": "tried"}

    async def undo(self):
        """Restores the file; returns the answer for the page."""
        self.session.file.undo()
        self.choose(-self.added)
        return {"state": "undone", "chosen": self.session.chosen}

    def choose(self, added):
        """Keeps the same camera chosen after cameras were added before it."""
        self.added = added
        if self.session.chosen is not None:
            self.session.chosen += added

    async def look_at(self, path, name, more=()):
        """The cameras of a file, by a render of one pixel with more options."""

        async def nothing(_):
            return

        session = self.session
        render = Render(session.settings.program, session.folder, name)
        words = render.words(path, [*session.options(), *more, "-A"], session.size)
        await render.run([*words, "+SR1", "+ER1", "+SC1", "+EC1"], True, nothing)
        return render.camera()

    async def renew_record(self):
        """Updates the cameras' lines to those of the file."""
        session = self.session
        stamp = scene_file.stamp(session.file.path)
        if session.record_stamp != stamp:
            session.take_record(await self.look_at(session.settings.scene, "renewed"), stamp)

    def index_to_change(self):
        """Index of the camera statement on the page.
        @throws EditError  it cannot be changed"""
        session = self.session
        cameras, index = session.record["cameras"], session.chosen
        if index is None:
            index = session.index_in_use()
        if index is None:
            raise EditError("no camera statement of the scene is the one in use")
        camera = cameras[index]
        if not session.is_own(camera):
            raise EditError(f"the camera stands in another file, {os.path.basename(camera['file'])}")
        return index

    async def check(self, data, old, added, expected, more=()):
        """@throws EditError  unless the program finds the wanted lens, and the items that the page keeps, in the changed scene"""
        session = self.session
        path = session.folder / "changed.pov"
        path.write_bytes(data)
        found = await self.look_at(path, "changed", more)
        camera = found["view"] if session.chosen is None else found["cameras"][session.chosen + added]
        lost = set(old["words"]) & {*scene_text.KEPT, *scene_text.REFUSED} - set(camera["words"])
        if lost:
            raise EditError("the changed scene would lose " + ", ".join(sorted(lost)))
        wrong = scene_file.differences(camera, expected)
        if wrong:
            raise EditError("the changed scene would have another " + ", ".join(wrong))

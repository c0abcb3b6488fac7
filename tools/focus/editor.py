# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Writes the page's block after the program has found the lens in it."""

import os

from tools.focus import scene_file, scene_text
from tools.focus.record import Record
from tools.focus.render import Render, RenderError
from tools.focus.scene_text import EditError
from tools.focus.tasks import ended, started


class Editor:
    def __init__(self, session):
        self.session = session
        self.added = self.index = 0  # cameras added by the last change, and the index of the one behind them
        self.task = None  # the last task; tasks run one after the other

    def start(self, request, view):
        self.begin(lambda: self.write(request, view), "refused", self.tell_all)

    def start_undo(self):
        self.begin(self.undo, "refused", self.tell_all)

    def start_trial(self, request, view):
        self.begin(lambda: self.tried(request, view), "untried", lambda told: self.tell(view, told))

    def start_pull(self, request, view):
        if request["write"]:
            self.begin(lambda: self.pulled(request, view), "refused", lambda told: self.tell_all({**told, "pull": True}))
        else:
            self.begin(lambda: self.pulled(request, view), "untried", lambda told: self.tell(view, {**told, "pull": True}))

    @staticmethod
    async def tell(view, told):
        view.send({"type": "file", **told})

    async def tell_all(self, told):
        self.session.told["file"] = {"type": "file", **told}
        for view in self.session.views:
            await self.tell(view, {**told, "chosen": view.chosen})

    def begin(self, work, failed, tell):
        self.task = started(self.answered(work, failed, tell, self.task))

    async def answered(self, work, failed, tell, previous):
        await ended(previous)
        try:
            told = await work()
        except Exception as error:  # pylint: disable=broad-except
            told = {"state": failed, "reason": self.session.described(error)["message"]}
        await tell(told)

    async def change(self, request, view):
        """Contents before and after, checked by the program, and the number of cameras added before this one."""
        session = self.session
        camera, before = await self.camera_to_change(view), session.file.bytes()
        text, behind = session.file.decoded(before), request["behind"]
        reason = None
        for added, changed, expected in (
            (0, lambda: self.in_camera(camera, text, request), request["expect"]),
            (1, lambda: scene_text.behind_camera(text, camera["line"], behind["block"]), behind["expect"]),
        ):
            try:
                after = session.file.encoded(changed())
                await self.check(view, after, camera, added, expected)
                return before, after, added
            except (EditError, RenderError) as error:
                reason = reason or error
        raise reason

    @staticmethod
    def in_camera(camera, text, request):
        if camera["block"] and scene_text.kept_at(text, camera["line"]) is None:
            raise EditError("the camera's tilt_lens block comes from a macro or another file")
        return scene_text.with_block(text, camera["line"], request["block"], request["items"])

    async def write(self, request, view):
        return self.replaced(view, *await self.change(request, view))

    def replaced(self, view, before, after, added):
        kept = self.session.file.replace(before, after)
        self.added, self.index = added, view.record.index_in_use() if view.chosen is None else view.chosen
        self.choose(added)
        return {"state": "written", "kept": kept, "stamp": self.session.file.stamp()}

    async def pulled(self, request, view):
        session = self.session
        camera, before = await self.camera_to_change(view), session.file.bytes()
        text = session.file.decoded(before)
        after = session.file.encoded(scene_text.with_head(self.in_camera(camera, text, request), text, camera["line"], request["head"]))
        for check in request["checks"]:
            await self.check(view, after, camera, 0, check["expect"], [f"+K{check['time']!r}"])
        return self.replaced(view, before, after, 0) if request["write"] else {"state": "tried"}

    async def tried(self, request, view):
        await self.change(request, view)
        return {"state": "tried"}

    async def undo(self):
        self.session.file.undo()
        self.choose(-self.added)
        self.added = -self.added
        return {"state": "undone", "stamp": self.session.file.stamp()}

    def choose(self, added):
        """Cameras may be added or removed before the chosen one."""
        for view in self.session.views:
            if view.chosen is not None and view.chosen >= self.index + max(0, -added):
                view.chosen += added

    async def look_at(self, view, path, name, more=()):
        """Renders one pixel."""

        async def nothing(_):
            return

        session = self.session
        render = Render(session.settings.program, session.folder, name)
        words = render.words(path, [*view.options(), *more, "-A"], view.size)
        await render.run([*words, "+SR1", "+ER1", "+SC1", "+EC1"], True, nothing)
        return render.camera()

    async def camera_to_change(self, view):
        """@throws EditError it cannot be changed"""
        session = self.session
        stamp = session.file.stamp()
        if view.record.stamp != stamp:
            view.take(Record(await self.look_at(view, session.settings.scene, "renewed"), session.file, stamp), view.size)
        record, index = view.record, view.chosen
        if index is None:
            index = record.index_in_use()
        if index is None:
            raise EditError("no camera statement of the scene is the one in use")
        camera = record.cameras[index]
        if not record.is_own(camera):
            raise EditError(f"the camera stands in another file, {os.path.basename(camera['file'])}")
        return camera

    async def check(self, view, data, old, added, expected, more=()):
        """@throws EditError the program does not find the lens and the kept items"""
        session = self.session
        path = session.folder / "changed.pov"
        path.write_bytes(data)
        found = await self.look_at(view, path, "changed", more)
        camera = found["view"] if view.chosen is None else found["cameras"][view.chosen + added]
        lost = set(old["words"]) & {*scene_text.KEPT, *scene_text.REFUSED} - set(camera["words"])
        if lost:
            raise EditError("the changed scene would lose " + ", ".join(sorted(lost)))
        wrong = scene_file.differences(camera, expected)
        if wrong:
            raise EditError("the changed scene would have another " + ", ".join(wrong))

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The program's record of a scene's cameras."""

import os

from tools.focus import scene_text
from tools.focus.scene_text import EditError

SHOWN = ("location", "direction", "right", "up", "block")  # identify the camera in use


class Record:
    def __init__(self, found, file, stamp):
        self.found, self.file, self.stamp = found, file, stamp

    @property
    def view(self):
        return self.found["view"]

    @property
    def cameras(self):
        return self.found["cameras"]

    @property
    def gamma(self):
        return self.found["gamma"]

    def is_own(self, camera):
        return os.path.realpath(camera["file"]) == self.file.path

    def index_in_use(self):
        """None if no camera statement is in use."""
        same = [i for i, camera in enumerate(self.cameras) if all(camera[key] == self.view[key] for key in SHOWN)]
        return same[-1] if same else None

    def kept(self, camera):
        """Empty if the text cannot be parsed."""
        try:
            return scene_text.kept_at(self.file.text(), camera["line"]) or [] if self.is_own(camera) else []
        except EditError:
            return []

    def kept_in_picture(self, index):
        """Without an index, the camera in use."""
        index = self.index_in_use() if index is None else index
        found = self.kept(self.cameras[index]) if index is not None else []
        return [item for item in found if item.split()[0] not in scene_text.NOT_IN_PICTURE]

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Each page has its own clock, camera and frame."""

from tools.focus.messages import need


class View:
    """`send` takes a dict or bytes."""

    def __init__(self, session, send):
        self.session, self.send = session, send
        options = session.settings.options
        self.clock, self.size = options.clock, list(options.size)
        self.chosen = None  # camera; None: the scene's own
        self.record = None
        self.preview = None

    def take(self, record, size):
        self.record, self.size = record, size
        if self.chosen is not None and self.chosen >= len(record.cameras):
            self.chosen = None

    def ask(self, message):
        chosen = message.get("chosen")
        if "clock" in message:
            self.clock = float(message["clock"])
        if chosen is not None:
            need(self.record and chosen < len(self.record.cameras))
            self.chosen = int(chosen)
        self.session.show(self, message.get("camera"))

    def options(self):
        return self.session.options(self.clock)

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""One page's choices: each page has a clock, a camera and a frame of its own."""

from tools.focus.messages import need


class View:
    """A page as the session knows it; `send` takes a dict or bytes."""

    def __init__(self, session, send):
        self.session, self.send = session, send
        options = session.settings.options
        self.clock, self.size = options.clock, list(options.size)
        self.chosen = None  # index of the camera; None: the scene's own
        self.record = None  # of the scene at this clock
        self.preview = None

    def take(self, record, size):
        """Takes the scene's cameras, and the preview's size."""
        self.record, self.size = record, size
        if self.chosen is not None and self.chosen >= len(record.cameras):
            self.chosen = None

    def ask(self, message):
        """Shows the preview of a page's request: another camera, clock, or frame."""
        chosen = message.get("chosen")
        if "clock" in message:
            self.clock = float(message["clock"])
        if chosen is not None:
            need(self.record and chosen < len(self.record.cameras))
            self.chosen = int(chosen)
        self.session.show(self, message.get("camera"))

    def options(self):
        """The options of a render for this page."""
        return self.session.options(self.clock)

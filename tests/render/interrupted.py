# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""A render that is killed or interrupted, and then continued with +C, has the same pixels."""

import pathlib
import re
import signal
import tempfile
import time

from tests.render import rendering, scenes

SLOW = scenes.camera(samples="blur_samples 600 variance 0 ") + scenes.WORLD
SIZE = {"width": 96, "height": 72}


class Interrupted(rendering.RenderTest):
    @classmethod
    def setUpClass(cls):
        cls.whole = rendering.render(SLOW, "+WT2", **SIZE)

    def interrupt(self, folder, stop):
        """Stops a render when a part of it is on the disk."""
        process = rendering.Job(SLOW, ("+WT1", "+BS8"), **SIZE).start(folder)
        try:
            end = time.monotonic() + 60
            state = None
            while process.poll() is None and time.monotonic() < end:
                state = next(iter(folder.glob("*.pov-state")), None)
                # a few finished blocks of 8 by 8 pixels
                if state and state.stat().st_size > 8000:
                    break
                time.sleep(0.01)
            self.assertIsNone(process.poll(), f"it ended before it could be stopped: {process.poll()}")
            self.assertIsNotNone(state, "no state file within 60 s")
            process.send_signal(stop)
            process.communicate(timeout=60)
        finally:
            if process.poll() is None:
                process.kill()
                process.communicate()
        self.assertNotEqual(process.returncode, 0)

    def check(self, stop):
        with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
            folder = pathlib.Path(name)
            self.interrupt(folder, stop)
            again = rendering.Job(SLOW, ("+WT2", "+BS8", "+C"), **SIZE)  # the state file counts tiles
            said = again.run(folder)
            self.assert_same(again.result(folder), self.whole, f"continued after {stop.name}")
        pixels = re.search(r"^Pixels: +(\d+)", said, re.MULTILINE)
        self.assertIsNotNone(pixels, said)
        self.assertLess(int(pixels[1]), SIZE["width"] * SIZE["height"], f"it began again from the start\n{said}")

    def test_killed(self):
        self.check(signal.SIGKILL)

    def test_interrupted(self):
        self.check(signal.SIGINT)


if __name__ == "__main__":
    rendering.main()

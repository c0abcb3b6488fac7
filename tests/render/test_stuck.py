# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Signals end the program while its parser waits."""

import os
import pathlib
import signal
import tempfile
import threading

from tests.render import rendering, scenes

WAITING = {
    "include": '#include "pipe.inc"\n' + scenes.TILTED,
    "prescription": 'camera { location -5*z look_at 0 tilt_lens { prescription "pipe.inc" } }\n',
    "loop": "#while (1) #end\n",
}
PATIENCE = 100  # seconds


class Stuck(rendering.RenderTest):
    def end(self, scene, number):
        with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
            os.mkfifo(pathlib.Path(name) / "pipe.inc")
            process = rendering.Job(scene).start(pathlib.Path(name))
            timer = threading.Timer(PATIENCE, process.kill)
            timer.start()
            said = b""
            while b"[Parsing...]" not in said:
                line = process.stdout.readline()
                if not line:
                    break
                said += line
            process.send_signal(number)
            said += process.communicate()[0]
            timer.cancel()
            return process.returncode, said.decode(errors="replace")

    def test_signals_end_it(self):
        for what, scene in WAITING.items():
            for number in (signal.SIGTERM, signal.SIGINT):
                with self.subTest(what=what, signal=number):
                    code, said = self.end(scene, number)
                    self.assertEqual(code, 2, said)
                    self.assertEqual("does not stop. The program ends without it" in said, what != "loop", said)


if __name__ == "__main__":
    rendering.main()

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Browser, port and calls of ./focus."""

import socket
import subprocess
import urllib.parse
import urllib.request

from tests.focus import harness
from tests.focus.harness import SCENE, SETTINGS, SMALL, PageTest
from tools import povray_run


class Command(harness.FocusTest):
    def stand_in(self):
        script, opened = self.folder / "browser", self.folder / "opened"
        script.write_text(f'#!/bin/sh\necho "$1" >> "{opened}"\n')
        script.chmod(0o755)
        return str(script), opened

    def test_opens_the_browser_with_a_display(self):
        browser, opened = self.stand_in()
        # webbrowser splits its words as a shell does
        variables = {"BROWSER": f"'{browser}' %s", "DISPLAY": ":99"}
        address = self.start(self.scene(), *SMALL, **variables)
        # the shell creates the file before it writes the line
        self.until("the browser", lambda: opened.exists() and opened.read_text().endswith("\n"))
        self.assertEqual(opened.read_text().strip(), address)
        self.end()
        opened.unlink()
        for words, more in ((("--no-browser",), variables), ((), {"BROWSER": variables["BROWSER"]})):
            address = self.start(self.scene(), *SMALL, *words, **more)
            with urllib.request.urlopen(address) as answer:  # the program continues after opening a browser
                self.assertEqual(answer.status, 200)
            self.end()
            self.assertFalse(opened.exists(), words)

    def test_listens_at_the_given_port(self):
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            port = free.getsockname()[1]
        address = self.start(self.scene(), *SMALL, "--port", str(port))
        self.assertEqual(urllib.parse.urlsplit(address).port, port)
        done = self.call(self.scene(), "--port", str(port))
        self.assertEqual(done.returncode, 1)
        self.assertEqual(done.stderr.strip(), f"focus: cannot listen on port {port}: Address already in use")

    def call(self, *words):
        command = [str(harness.ROOT / "focus"), *map(str, words), "--povray", SETTINGS.povray]
        return subprocess.run(
            command, cwd=self.folder, env=povray_run.user_environment(), capture_output=True, text=True, check=False, timeout=60
        )

    def test_wrong_calls_are_one_message(self):
        for words, said in (
            (["no such file.pov"], "there is no readable scene file"),
            ([self.scene(), "--port", "99999"], "expected a whole number from 0 to 65535"),
            ([self.scene(), "--idle", "0"], "more than 0"),
            ([self.scene(), "--unknown"], "unknown option --unknown"),
        ):
            done = self.call(*words)
            with self.subTest(said):
                self.assertNotEqual(done.returncode, 0)
                self.assertIn(said, done.stderr)
                self.assertNotIn("Traceback", done.stderr)


class Animation(PageTest):
    def test_the_clock_has_the_range_of_the_animation_and_one_frame_is_shown(self):
        scene = self.scene(SCENE + "sphere { <0, clock/10, -3>, 0.3 pigment { rgb x } }\n")
        self.open(scene, *SMALL, "+KFI1", "+KFF20", "+KI4", "+KF24")
        clock = "const c = document.getElementById('clock'); return [c.min, c.max, c.value].map(Number)"
        self.assertEqual(self.run(clock), [4, 24, 4])
        self.assertEqual(self.text("clock-value"), "4")
        at_start = self.refined_sum()
        self.choose("clock", 24)
        self.until("the moved scene", lambda: abs(self.run("return focusPage.previewSum()") - at_start) > 10)
        self.end()
        self.open(scene, *SMALL, "+K4")
        self.assertEqual(self.run(clock), [0, 4, 4])
        self.assertAlmostEqual(self.refined_sum(), at_start, delta=abs(at_start) * 0.002)


if __name__ == "__main__":
    harness.main()

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Tests that wait for processes."""

import time
import unittest

from tools.povray_run import PATIENCE


class WaitingTest(unittest.TestCase):
    def evidence(self):
        return ""

    def until(self, what, condition, seconds=PATIENCE):
        end = time.monotonic() + seconds
        while True:
            value = condition()
            if value:
                return value
            if time.monotonic() > end:
                self.fail(f"waited {seconds} s in vain for {what}\n{self.evidence()}")
            time.sleep(0.05)

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Tests that wait for other processes."""

import time
import unittest

from tools.povray_run import PATIENCE


class WaitingTest(unittest.TestCase):
    """A test that waits for conditions."""

    def evidence(self):
        """Text that helps to diagnose a missing event."""
        return ""

    def until(self, what, condition, seconds=PATIENCE):
        """Waits for a condition; returns its value."""
        end = time.monotonic() + seconds
        while True:
            value = condition()
            if value:
                return value
            if time.monotonic() > end:
                self.fail(f"waited {seconds} s in vain for {what}\n{self.evidence()}")
            time.sleep(0.05)

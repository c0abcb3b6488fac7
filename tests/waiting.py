# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Tests that wait for other processes."""

import time
import unittest

# Seconds until what must happen counts as not happening. Far more than anything takes: how long it takes depends on what else runs.
PATIENCE = 600


class WaitingTest(unittest.TestCase):
    """A test that can wait for something to become so."""

    def evidence(self):
        """What helps to see why something did not happen."""
        return ""

    def until(self, what, condition, seconds=PATIENCE):
        """Waits for something to become so; returns what it became."""
        end = time.monotonic() + seconds
        while True:
            value = condition()
            if value:
                return value
            if time.monotonic() > end:
                self.fail(f"waited {seconds} s in vain for {what}\n{self.evidence()}")
            time.sleep(0.05)

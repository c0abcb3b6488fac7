# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Text that a program writes into a page, between the lines <!-- BEGIN --> and <!-- END -->."""

import sys


def parts(page, begin, end):
    """The page up to the text, the text, and the rest."""
    whole = page.read_text(encoding="utf-8")
    before, begins, rest = whole.partition(f"<!-- {begin} -->\n")
    text, ends, after = rest.partition(f"<!-- {end} -->")
    if not begins or not ends or whole.count(begins) > 1:
        sys.exit(f"{page} needs the lines <!-- {begin} --> and <!-- {end} --> once, in this order, around the text to be written")
    return before + begins, text, ends + after


def filled(page, begin, end, text):
    """The whole page with another text."""
    before, _, after = parts(page, begin, end)
    return before + text + after

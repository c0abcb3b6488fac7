# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Neither page nor program contacts another host."""

import re

from tests.focus import harness
from tests.focus.harness import ROOT, PageTest


class Contacts(PageTest):
    def test_page_contacts_no_other_host(self):
        address = self.open(self.scene())
        names = self.run("return performance.getEntriesByType('resource').map(e => e.name)")
        self.assertGreater(len(names), 5)
        origin = re.match(r"http://[^/]+/", address).group()
        self.assertEqual([name for name in names if not name.startswith(origin)], [])
        for path in (ROOT / "tools" / "focus" / "page").iterdir():
            addresses = set(re.findall(r"(?:https?|wss?):?//[\w.]+", path.read_text()))
            self.assertLessEqual(addresses, {"http://www.w3.org"}, path.name)

    def test_program_contacts_no_other_host(self):
        clients = (
            r"^\s*(?:import|from) (?:urllib|http|socket|ssl|requests|ftplib|smtplib)\b|ClientSession|open_connection|create_connection"
        )
        for path in (ROOT / "tools" / "focus").glob("*.py"):
            text = path.read_text()
            self.assertEqual(re.findall(clients, text, re.MULTILINE), [], path.name)
            self.assertEqual(re.findall(r"(?:https?|wss?)://[\w.]+", text), [], path.name)


if __name__ == "__main__":
    harness.main()

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Both styles of apt's settings yield the same source list."""

import unittest

from tests.setup.scratch import REPOSITORY, SetupTest

FETCH = REPOSITORY / "cmake" / "fetch-debian-source"
CODENAME = next(
    line.split("=", 1)[1].strip().strip('"') for line in open("/etc/os-release", encoding="utf-8") if line.startswith("VERSION_CODENAME=")
)


ONE_LINE = f"""# a comment
deb [arch=amd64 signed-by=/keys/debian.gpg] http://mirror.invalid/debian {CODENAME} main contrib
deb http://mirror.invalid/debian {CODENAME}-updates main
deb http://security.invalid/debian-security {CODENAME}-security main
deb https://vendor.invalid/apt stable vendor
#deb http://off.invalid/debian {CODENAME} main
"""

DEB822 = f"""# a comment
Types: deb
URIs: http://mirror.invalid/debian
Suites: {CODENAME} {CODENAME}-updates
Components: main contrib
Signed-By: /keys/debian.gpg

Types: deb
URIs: http://off.invalid/debian
Suites: {CODENAME}
Components: main
Enabled: no

Types: deb
URIs: https://vendor.invalid/apt
Suites: nodistro
Components: main
"""

EXPECTED = [
    "Types: deb-src",
    "URIs: http://mirror.invalid/debian",
    f"Suites: {CODENAME}",
    "Components: main contrib",
    "Signed-By: /keys/debian.gpg",
]


class AptSettings(SetupTest):
    def settings(self, main="", **parts):
        (self.folder / "parts").mkdir(exist_ok=True)
        (self.folder / "sources.list").write_text(main, encoding="utf-8")
        for name, text in parts.items():
            (self.folder / "parts" / name.replace("_", ".")).write_text(text, encoding="utf-8")
        config = self.folder / "apt.conf"
        config.write_text(
            f'Dir::Etc::sourcelist "{self.folder}/sources.list";\n' f'Dir::Etc::sourceparts "{self.folder}/parts";\n', encoding="utf-8"
        )
        return {"APT_CONFIG": str(config)}

    def source_list(self, **kwargs):
        process = self.run_command(FETCH, "sources", env=self.settings(**kwargs))
        self.assert_succeeds(process)
        return [line for line in process.stdout.splitlines() if line]

    def test_one_line_style(self):
        self.assertEqual(self.source_list(main=ONE_LINE), EXPECTED)
        self.assertEqual(self.source_list(main="", debian_list=ONE_LINE), EXPECTED)

    def test_deb822_style(self):
        self.assertEqual(self.source_list(debian_sources=DEB822), EXPECTED)

    def test_both_styles_name_the_mirror_once(self):
        self.assertEqual(self.source_list(main=ONE_LINE, debian_sources=DEB822), EXPECTED)

    def test_key_within_the_settings(self):
        key = "\n -----BEGIN PGP PUBLIC KEY BLOCK-----\n .\n bWF0\n -----END PGP PUBLIC KEY BLOCK-----"
        lines = self.source_list(debian_sources=DEB822.replace(" /keys/debian.gpg", key))
        self.assertEqual(lines[4:], ["Signed-By: "] + key.splitlines()[1:])

    def test_suites_named_by_role(self):
        for suite in ("stable", "oldstable", "testing", "unstable", "sid"):
            lines = self.source_list(main=f"deb http://mirror.invalid/debian {suite} main\n")
            self.assertIn(f"Suites: {suite}", lines)

    def test_other_entries_only_if_none_is_of_the_release(self):
        vendor = "deb https://vendor.invalid/apt amber free\ndeb https://flat.invalid/apt ./\n"
        self.assertEqual(self.source_list(main=vendor + ONE_LINE), EXPECTED)
        self.assertEqual(
            self.source_list(main=vendor), ["Types: deb-src", "URIs: https://vendor.invalid/apt", "Suites: amber", "Components: free"]
        )

    def test_discs_are_left_out(self):
        self.assertEqual(self.source_list(main=f"deb cdrom:[Debian 12 - amd64]/ {CODENAME} main\n" + ONE_LINE), EXPECTED)

    def test_no_mirror(self):
        process = self.run_command(FETCH, "fetch", "povray", self.folder / "target", "1", env=self.settings())
        self.assert_fails_saying(process, "name no mirror of its release")

    def test_no_network(self):
        mirror = "http://127.0.0.1:9/debian"  # the discard port refuses at once, without a look-up
        env = self.settings(main=f"deb [trusted=yes] {mirror} {CODENAME} main\n")
        before = {path: path.read_bytes() for path in self.folder.rglob("*") if path.is_file()}
        process = self.run_command(FETCH, "fetch", "povray", self.folder / "target", "3.7.0.10", env=env)
        self.assert_fails_saying(process, "mirror could not be reached")
        for path, content in before.items():
            self.assertEqual(path.read_bytes(), content, f"{path} was changed")


if __name__ == "__main__":
    unittest.main()

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Both styles of apt's settings lead to the same source list, and the settings stay as they are. Of what the mirrors
hold, a pinned revision is taken."""

import hashlib
import unittest
import urllib.parse

from tests.setup.harness import REPOSITORY, SetupTest

FETCH = REPOSITORY / "cmake" / "fetch-debian-source"
CODENAME = next(line.split("=", 1)[1].strip().strip('"')
                for line in open("/etc/os-release", encoding="utf-8")
                if line.startswith("VERSION_CODENAME="))


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

EXPECTED = ["Types: deb-src", "URIs: http://mirror.invalid/debian", f"Suites: {CODENAME}",
            "Components: main", "Signed-By: /keys/debian.gpg"]


class AptSettings(SetupTest):
    def settings(self, main="", **parts):
        """Makes apt settings with the given sources.list and sources.list.d (file name -> text)."""
        (self.folder / "parts").mkdir(exist_ok=True)
        (self.folder / "sources.list").write_text(main, encoding="utf-8")
        for name, text in parts.items():
            (self.folder / "parts" / name.replace("_", ".")).write_text(text, encoding="utf-8")
        config = self.folder / "apt.conf"
        config.write_text(f'Dir::Etc::sourcelist "{self.folder}/sources.list";\n'
                          f'Dir::Etc::sourceparts "{self.folder}/parts";\n', encoding="utf-8")
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

    def test_no_debian_mirror(self):
        process = self.run_command(FETCH, "fetch", "povray", self.folder / "target", "1",
                                   env=self.settings(main="deb https://vendor.invalid/apt stable vendor\n"))
        self.assert_fails_saying(process, "name no mirror of its Debian release")

    def test_no_network(self):
        mirror = "http://127.0.0.1:9/debian"    # the discard port: refused at once, with no look-up
        env = self.settings(main=f"deb [trusted=yes] {mirror} {CODENAME} main\n")
        before = {path: path.read_bytes() for path in self.folder.rglob("*") if path.is_file()}
        process = self.run_command(FETCH, "fetch", "povray", self.folder / "target", "1:3.7.0.10-2", env=env)
        self.assert_fails_saying(process, "mirror could not be reached")
        for path, content in before.items():
            self.assertEqual(path.read_bytes(), content, f"{path} was changed")

    def mirror(self, *versions):
        """A mirror in a folder that holds these versions of a source package; returns apt settings that name it."""
        root = self.folder / "mirror"
        source = root / "dists" / CODENAME / "main" / "source"
        source.mkdir(parents=True)
        index = ""
        for version in versions:
            control = root / f"povray_{version}.dsc"
            control.write_text(f"Source: povray\nVersion: {version}\n", encoding="utf-8")
            content = control.read_bytes()
            index += (f"Package: povray\nBinary: povray\nVersion: {version}\nArchitecture: any\nFormat: 1.0\nDirectory: .\n"
                      f"Checksums-Sha256:\n {hashlib.sha256(content).hexdigest()} {len(content)} {control.name}\n\n")
        (source / "Sources").write_text(index, encoding="utf-8")
        content = index.encode()
        (root / "dists" / CODENAME / "Release").write_text(
            f"Codename: {CODENAME}\nDate: Thu, 01 Jan 2026 00:00:00 UTC\nComponents: main\nArchitectures: amd64\n"
            f"SHA256:\n {hashlib.sha256(content).hexdigest()} {len(content)} main/source/Sources\n", encoding="utf-8")
        return self.settings(main=f"deb [trusted=yes] file:{urllib.parse.quote(str(root))} {CODENAME} main\n")

    def test_newest_pinned_revision_is_taken(self):
        env = self.mirror("1-2", "1-3", "1-7")
        target = self.folder / "target"
        self.assert_succeeds(self.run_command(FETCH, "fetch", "povray", target, "1-1", "1-2", "1-3", env=env))
        self.assertEqual([file.name for file in target.glob("*.dsc")], ["povray_1-3.dsc"])

    def test_revision_that_is_not_pinned(self):
        env = self.mirror("1-7")
        process = self.run_command(FETCH, "fetch", "povray", self.folder / "target", "1-2", "1-3", env=env)
        self.assert_fails_saying(process, "hold povray in the revision 1-7, which is not pinned",
                                 "Add a revision of Debian's package")

    def test_package_that_no_mirror_holds(self):
        process = self.run_command(FETCH, "fetch", "povray-nowhere", self.folder / "target", "1-2", env=self.mirror("1-2"))
        self.assert_fails_saying(process, "hold no source package povray-nowhere")


if __name__ == "__main__":
    unittest.main()

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""apt gets the source from imitated mirrors."""

import dataclasses
import email.utils
import hashlib
import pathlib
import subprocess
import tempfile
import time
import unittest
import urllib.parse

from tests.setup.source_package import TARBALL, SourcePackageTest

DAY = 24 * 60 * 60


@dataclasses.dataclass
class System:
    release: str
    settings: str  # MIRROR, DEAD and KEY stand for addresses and for the words about the key
    suite: str
    component: str
    revision: str
    deb822: bool = False


SYSTEMS = {
    "Ubuntu noble": System(
        "ID=ubuntu\nID_LIKE=debian\nVERSION_CODENAME=noble\nUBUNTU_CODENAME=noble\n",
        "Types: deb\nURIs: MIRROR\nSuites: noble noble-updates noble-backports\nComponents: main restricted universe multiverse\nKEY\n\n"
        "Types: deb\nURIs: DEAD\nSuites: noble-security\nComponents: main restricted universe multiverse\nKEY\n",
        "noble",
        "universe",
        "3build2",
        deb822=True,
    ),
    "Ubuntu jammy": System(
        "ID=ubuntu\nID_LIKE=debian\nVERSION_CODENAME=jammy\n",
        "deb [KEY] MIRROR jammy main restricted\n# deb-src [KEY] MIRROR jammy main restricted\ndeb [KEY] MIRROR jammy universe\n"
        "deb [KEY] DEAD jammy-security universe\n",
        "jammy",
        "universe",
        "1ubuntu1.2",
    ),
    "Mint": System(
        'ID=linuxmint\nID_LIKE="ubuntu debian"\nVERSION_CODENAME=xia\nUBUNTU_CODENAME=noble\n',
        "deb [KEY] DEAD xia main upstream import backport\ndeb [KEY] MIRROR noble main restricted universe multiverse\n",
        "noble",
        "universe",
        "3build2",
    ),
    "Mint's Debian edition": System(
        "ID=linuxmint\nID_LIKE=debian\nVERSION_CODENAME=faye\nDEBIAN_CODENAME=bookworm\n",
        "deb [KEY] MIRROR bookworm main contrib\ndeb [KEY] DEAD faye main\n",
        "bookworm",
        "main",
        "2",
    ),
    "Raspberry Pi OS": System(
        "ID=debian\nVERSION_CODENAME=bookworm\n",
        "deb cdrom:[Raspbian 12 _Bookworm_]/ bookworm main\ndeb [ arch=armhf,arm64 KEY ] MIRROR bookworm main contrib\n"
        "deb [KEY] DEAD bookworm main\n",
        "bookworm",
        "main",
        "2",
    ),
    "Raspbian": System(
        "ID=raspbian\nID_LIKE=debian\nVERSION_CODENAME=trixie\n",
        "deb [KEY] MIRROR trixie main contrib non-free rpi\n",
        "trixie",
        "main",
        "3+rpi1",
    ),
    "a system without codename": System(
        "ID=other\nID_LIKE=debian\n",
        "Types: deb\nURIs: MIRROR\nSuites: amber\nComponents: free\nKEY\n",
        "amber",
        "free",
        "9other~2",
        deb822=True,
    ),
    "sid": System("ID=debian\n", "deb [KEY] MIRROR sid main\n", "sid", "main", "4"),
    "Debian with its sources on": System(
        "ID=debian\nVERSION_CODENAME=trixie\n",
        "Types: deb deb-src\nURIs: MIRROR\nSuites: trixie\nComponents: main\nKEY\n",
        "trixie",
        "main",
        "3",
        deb822=True,
    ),
}


def rfc_date(seconds):
    return email.utils.formatdate(time.time() + seconds, usegmt=True).replace("GMT", "UTC")


def sha256(content):
    return hashlib.sha256(content).hexdigest()


class Mirrors(SourcePackageTest):
    @classmethod
    def setUpClass(cls):
        scratch = tempfile.TemporaryDirectory(prefix="tilt-lens-")  # without blanks, which apt does not accept in a key's name
        cls.addClassCleanup(scratch.cleanup)
        cls.keys = pathlib.Path(scratch.name)
        cls.gpg("--passphrase", "", "--quick-gen-key", "Mirror <mirror@example.org>", "ed25519", "sign", "never")
        cls.addClassCleanup(subprocess.run, ["gpgconf", "--homedir", str(cls.keys), "--kill", "all"], check=False)
        cls.public_key = cls.gpg("--armor", "--export")
        (cls.keys / "mirror.asc").write_text(cls.public_key, encoding="utf-8")

    @classmethod
    def gpg(cls, *words, text=None):
        return subprocess.run(
            ["gpg", "--homedir", str(cls.keys), "--batch", "--quiet", *words], input=text, capture_output=True, text=True, check=True
        ).stdout

    def mirror(self, suite, component, revisions, made=-DAY, signed=True):
        """Made `made` seconds from now, valid for two days."""
        root = self.folder / "mirror"
        source = root / "dists" / suite / component / "source"
        source.mkdir(parents=True)
        sources = ""
        for revision in revisions:
            packaging = f"povray_1-{revision}.debian.tar.xz"
            if not (self.archives / packaging).exists():
                self.write_packaging(packaging)
            control = f"povray_1-{revision}.dsc"
            (self.archives / control).write_text(f"Source: povray\nVersion: 1:1-{revision}\n", encoding="utf-8")
            sources += (
                f"Package: povray\nBinary: povray\nVersion: 1:1-{revision}\nArchitecture: any\nFormat: 3.0 (quilt)\n"
                "Directory: pool\nChecksums-Sha256:\n"
            )
            for name in (control, TARBALL, packaging):
                content = (self.archives / name).read_bytes()
                sources += f" {sha256(content)} {len(content)} {name}\n"
            sources += "\n"
        (root / "pool").symlink_to(self.archives)
        content = sources.encode()
        (source / "Sources").write_bytes(content)
        release = (
            f"Origin: Imitation\nSuite: {suite}\nCodename: {suite}\nDate: {rfc_date(made)}\n"
            f"Valid-Until: {rfc_date(made + 2*DAY)}\nComponents: {component}\nArchitectures: all\n"
            f"SHA256:\n {sha256(content)} {len(content)} {component}/source/Sources\n"
        )
        if signed:
            (root / "dists" / suite / "InRelease").write_text(self.gpg("--clear-sign", text=release), encoding="utf-8")
        else:
            (root / "dists" / suite / "Release").write_text(release, encoding="utf-8")
        return "file:" + urllib.parse.quote(str(root))

    def environment(self, system, mirror, key):
        if system.deb822:
            key = {
                "": "",
                "trusted": "Trusted: yes",
                "signed": "Signed-By:" + "".join(f"\n {line or '.'}" for line in self.public_key.splitlines()),
            }[key]
        else:
            key = {"": "arch=all", "trusted": "trusted=yes", "signed": f"signed-by={self.keys}/mirror.asc"}[key]
        text = system.settings.replace("MIRROR", mirror).replace("DEAD", "file:/nowhere").replace("\nKEY", f"\n{key}" if key else "")
        parts = self.folder / "parts"
        parts.mkdir(exist_ok=True)
        (parts / ("system.sources" if system.deb822 else "system.list")).write_text(text.replace("KEY", key), encoding="utf-8")
        config = self.folder / "apt.conf"
        ours = {"sourceparts": parts}  # hides the settings of the system that runs the test
        config.write_text(
            "".join(
                f'Dir::Etc::{name} "{ours.get(name, "/dev/null")}";\n'
                for name in ("main", "parts", "sourcelist", "sourceparts", "trusted", "trustedparts")
            ),
            encoding="utf-8",
        )
        release = self.folder / "os-release"
        release.write_text(system.release, encoding="utf-8")
        return {"APT_CONFIG": str(config), "TILT_LENS_OS_RELEASE": str(release)}

    def prepare_on(self, system, key="signed", revisions=None, **options):
        mirror = self.mirror(system.suite, system.component, revisions or [system.revision], signed=key == "signed", **options)
        return self.prepare(env=self.environment(system, mirror, key))

    def assert_downloaded(self, process, revision):
        self.assert_succeeds(process)
        self.assertEqual(sorted(file.name for file in self.downloads.iterdir()), sorted([TARBALL, f"povray_1-{revision}.debian.tar.xz"]))
        self.assert_prepared()

    def test_trusted_without_signature(self):
        self.assert_downloaded(self.prepare_on(SYSTEMS["Mint"], key="trusted"), "3build2")

    def test_unsigned(self):
        process = self.prepare_on(SYSTEMS["Ubuntu noble"], key="")
        self.assert_fails_saying(
            process,
            "not signed by a key that this system knows",
            "mark the mirror's entry in apt's settings as trusted",
            "./render --source FOLDER",
        )
        self.assertEqual(list(self.downloads.iterdir()), [])

    def test_signed_by_an_unknown_key(self):
        system = SYSTEMS["Ubuntu jammy"]
        mirror = self.mirror(system.suite, system.component, [system.revision])
        self.assert_fails_saying(self.prepare(env=self.environment(system, mirror, "")), "not signed by a key that this system knows")

    def test_expired_index(self):
        self.assert_downloaded(self.prepare_on(SYSTEMS["sid"], made=-20 * DAY), "4")

    def test_slow_clock(self):
        self.assert_downloaded(self.prepare_on(SYSTEMS["sid"], made=20 * DAY), "4")

    def test_the_good_one_of_two_revisions(self):
        self.write_packaging("povray_1-5.debian.tar.xz", fix_main="another text\n")
        self.assert_downloaded(self.prepare_on(SYSTEMS["sid"], revisions=["4", "5"]), "4")

    def test_rebuilt_with_another_patch(self):
        self.write_packaging("povray_1-4.debian.tar.xz", fix_main="another text\n")
        self.assert_fails_saying(
            self.prepare_on(SYSTEMS["sid"]),
            "mirror's files are not those pinned",
            "povray_1-4.debian.tar.xz: debian/patches/fix-main.patch has SHA-256",
            "Take another packaging",
        )
        self.assertEqual(list(self.downloads.iterdir()), [])

    def test_another_tarball_under_the_same_name(self):
        pin = self.pin.read_text(encoding="utf-8")
        self.pin.write_text(pin.replace('"size": ', '"size": 1'), encoding="utf-8")
        self.assert_fails_saying(
            self.prepare_on(SYSTEMS["sid"]), "mirror's files are not those pinned", f"{TARBALL} has", "bytes, expected"
        )

    def test_another_upstream_version(self):
        self.pin.write_text(
            self.pin.read_text(encoding="utf-8").replace('"upstream_version": "1"', '"upstream_version": "2"'), encoding="utf-8"
        )
        self.assert_fails_saying(self.prepare_on(SYSTEMS["sid"]), "hold povray in the version 1:1-4, not in 2", "./render --source FOLDER")

    def test_package_missing_on_the_mirror(self):
        self.pin.write_text(
            self.pin.read_text(encoding="utf-8").replace('"package": "povray"', '"package": "povray-nowhere"'), encoding="utf-8"
        )
        self.assert_fails_saying(self.prepare_on(SYSTEMS["sid"]), "hold no source package povray-nowhere")

    def test_mirror_without_sources(self):
        system = System("ID=debian\n", "deb [KEY] MIRROR sid main\n", "sid", "other", "1")
        self.assert_fails_saying(self.prepare_on(system), "have no index of source packages")


def add_system(name, system):
    def test(self):
        self.assert_downloaded(self.prepare_on(system), system.revision)

    setattr(Mirrors, "test_" + "_".join(name.replace("'", "").lower().split()), test)


for each, described in SYSTEMS.items():
    add_system(each, described)

if __name__ == "__main__":
    unittest.main()

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""A copy of the set-up, with a stand-in for the program."""

import os
import re
import shutil

from tests.setup.scratch import REPOSITORY, SetupTest


STAND_IN = r"""#!/bin/bash
for argument in "$@"; do printf 'argument [%q]\n' "$argument" >&2; done
printf '%s\0' "=a picture.png" >> "$TILT_LENS_FILE_LIST"
echo 'a picture on standard output'
exit "${POVRAY_EXIT:-0}"
"""


class CommandTest(SetupTest):
    def setUp(self):
        super().setUp()
        self.copy = self.folder / "my clone"
        self.copy.mkdir()
        shutil.copytree(REPOSITORY / "cmake", self.copy / "cmake")
        for name in ("render", "check", "CMakeLists.txt"):
            shutil.copy(REPOSITORY / name, self.copy / name)
        self.gallery = self.copy / "scenes" / "gallery" / "miniature_town.pov"
        self.gallery.parent.mkdir(parents=True)
        self.gallery.write_text("", encoding="utf-8")
        self.tools = self.folder / "tools"
        self.tools.mkdir()
        self.tool("sudo", "exit 1")

    def tool(self, name, text):
        path = self.tools / name
        path.write_text(f"#!/bin/bash\n{text}\n", encoding="utf-8")
        path.chmod(0o755)

    def have_all_packages(self):
        (self.copy / "cmake" / "debian-packages").write_text("render  bash\n", encoding="utf-8")

    def built(self, target):
        build = self.copy / "build"
        build.mkdir()
        (build / "CMakeCache.txt").write_text(
            f"CMAKE_HOME_DIRECTORY:INTERNAL={self.copy}\nCMAKE_CACHEFILE_DIR:INTERNAL={build}\n" "TILT_LENS_TESTS:BOOL=ON\n",
            encoding="utf-8",
        )
        (build / "build.ninja").write_text(f"build {target}: phony\n", encoding="utf-8")
        return build

    def environment(self):
        return {"PATH": f"{self.tools}:{os.environ['PATH']}", "DISPLAY": "", "CI": ""}

    def command(self, name, *arguments, cwd=None, **env):
        return self.run_command(name, *arguments, cwd=cwd, env={**self.environment(), **env})


class BuiltProgram(CommandTest):
    def setUp(self):
        super().setUp()
        program = self.built("povray") / "bin" / "povray"
        program.parent.mkdir()
        program.write_text(STAND_IN, encoding="utf-8")
        program.chmod(0o755)
        self.scene = self.folder / "my scene.pov"
        self.scene.write_text("", encoding="utf-8")

    def render(self, *arguments, **kwargs):
        return self.command(self.copy / "render", *arguments, **kwargs)

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later

import argparse
import array
import dataclasses
import math
import pathlib
import shutil
import struct
import sys
import tempfile
import time
import unittest

from tools import povray_run
from tools.povray_run import PATIENCE

SETTINGS = argparse.Namespace(povray="povray", compare="compare", library=[])
HEAD = "#version 3.7; global_settings { assumed_gamma 1 }\n"


@dataclasses.dataclass
class Picture:
    width: int
    height: int
    names: list
    values: list
    told: str = ""

    def pixel(self, x, y):
        n = len(self.names)
        at = (y * self.width + x) * n
        return self.values[at : at + n]

    def crop(self, left, top, right, bottom):
        rows = [self.pixel(x, y) for y in range(top, bottom) for x in range(left, right)]
        return Picture(
            right - left,
            bottom - top,
            self.names,
            [v for p in rows for v in p],
            f"{self.told}cut to columns {left} to {right - 1}, rows {top} to {bottom - 1}\n",
        )

    def channel(self, name):
        return self.values[self.names.index(name) :: len(self.names)]


def read_pixels(path):
    """Width, height, type, channel names, stored values."""
    head, data = povray_run.pixels(SETTINGS.compare, path).split(b"\n", 1)
    width, height, _, form, *names = head.decode().split()
    return int(width), int(height), form, names, data


def read_picture(path, told):
    width, height, form, names, data = read_pixels(path)
    code, scale = {"uint8": ("B", 255.0), "uint16": ("H", 65535.0), "half": ("e", 1.0), "float": ("f", 1.0)}[form]
    if code == "e":
        values = [v for (v,) in struct.iter_unpack("=e", data)]
    else:
        values = list(array.array(code, data))
    return Picture(width, height, names, [v / scale for v in values], told)


@dataclasses.dataclass
class Job:
    scene: str
    options: tuple = ()
    width: int = 64
    height: int = 48
    extension: str = "png"

    def command(self):
        kind = {"png": "+FN16", "exr": "+FE"}[self.extension]
        return povray_run.command(
            SETTINGS.povray,
            "scene.pov",
            f"picture.{self.extension}",
            (self.width, self.height),
            kind,
            "File_Gamma=1.0",
            *self.options,
            library=SETTINGS.library,
        )

    def told(self):
        return f"{' '.join(self.command())}\n{HEAD}{self.scene.strip()}\n"

    def write(self, folder):
        (folder / "scene.pov").write_text(HEAD + self.scene)

    def start(self, folder):
        self.write(folder)
        return povray_run.start(self.command(), folder)

    def attempt(self, folder, before=(), **how):
        """Exit code and messages. Fails if POV-Ray does not end.
        @param before words of a command that starts POV-Ray"""
        self.write(folder)
        done = povray_run.run([*before, *self.command()], folder, **how)
        if done.code is None:
            raise AssertionError(f"{done.told()}\n{self.told()}")
        return done.code, done.said

    def stop(self, folder, number, kept):
        end = time.monotonic() + PATIENCE
        with self.start(folder) as process:
            while process.poll() is None and time.monotonic() < end:
                if any(state.stat().st_size > kept for state in folder.glob("*.pov-state")):
                    break
                time.sleep(0.01)
            running = process.poll() is None
            process.send_signal(number)
            said = process.stdout.read().decode(errors="replace")
        if not running or process.returncode == 0:
            raise AssertionError(f"it ended before it could be stopped, exit code {process.returncode}\n{self.told()}{said[-1500:]}")

    def run(self, folder):
        code, said = self.attempt(folder)
        if code != 0 or not (folder / f"picture.{self.extension}").is_file():
            raise AssertionError(f"exit code {code}\n{self.told()}{said[-1500:]}")
        return said

    def result(self, folder):
        return read_picture(folder / f"picture.{self.extension}", self.told())


def render(scene, *options, **how):
    return render_and_listen(scene, *options, **how)[0]


def render_and_listen(scene, *options, **how):
    job = Job(scene, options, **how)
    with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
        said = job.run(pathlib.Path(name))
        return job.result(pathlib.Path(name)), said


def difference(a, b):
    if (a.width, a.height, a.names) != (b.width, b.height, b.names):
        raise AssertionError(f"{a.width} x {a.height} {a.names}, not {b.width} x {b.height} {b.names}\n{a.told}{b.told}")
    squares = largest = 0.0
    for u, v in zip(a.values, b.values):
        squares += (u - v) ** 2
        largest = max(largest, abs(u - v))
    return math.sqrt(squares / len(a.values)), largest


class RenderTest(unittest.TestCase):
    longMessage = False

    def assert_same(self, a, b, what=""):
        rms, largest = difference(a, b)
        if largest != 0.0:
            off = [i // len(a.names) for i, (u, v) in enumerate(zip(a.values, b.values)) if u != v]
            self.fail(
                f"{what}: {len(set(off))} pixels differ, by up to {largest:g} (RMS {rms:g}), the first "
                f"at column {off[0] % a.width}, row {off[0] // a.width}\n{a.told}--- and\n{b.told}"
            )
        self.assertGreater(len(set(a.values)), 8, f"{what}: an empty picture shows nothing\n{a.told}")

    def assert_same_in_parts(self, scene, *options, first, last, **size):
        """The picture is equal for other threads, tiles, and rows `first` to `last`. Returns it."""
        whole = render(scene, "+WT1", *options, **size)
        self.assert_same(render(scene, "+WT3", "+BS13", *options, **size), whole, "threads")
        part = render(scene, f"+SR{first}", f"+ER{last}", *options, **size)
        area = (0, first - 1, whole.width, last)
        self.assert_same(part.crop(*area), whole.crop(*area), "rows")
        return whole

    def assert_near(self, a, b, rms, what=""):
        found, largest = difference(a, b)
        self.assertLessEqual(
            found, rms, f"{what}: RMS difference {found:g}, allowed {rms:g}, largest {largest:g}\n" f"{a.told}--- and\n{b.told}"
        )

    def assert_different(self, a, b, rms, what=""):
        found, _ = difference(a, b)
        self.assertGreater(found, rms, f"{what}: RMS difference only {found:g}\n{a.told}--- and\n{b.told}")

    def assert_finite(self, picture):
        bad = [i for i, v in enumerate(picture.values) if not math.isfinite(v)]
        self.assertFalse(bad, f"{len(bad)} values are not finite\n{picture.told}")


def main():
    parser = argparse.ArgumentParser(add_help=False)
    parser.add_argument("--povray", required=True)
    parser.add_argument("--compare", required=True)
    parser.add_argument("--library", action="append", default=[], help="further folder of include files")
    _, rest = parser.parse_known_args(namespace=SETTINGS)
    for program in (SETTINGS.povray, SETTINGS.compare):
        if shutil.which(program) is None:
            sys.exit(f"no such program: {program}")
    unittest.main(module="__main__", argv=[sys.argv[0], *rest])

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Values and safety of Output_Layers."""

import math
import pathlib
import re
import shlex
import signal
import subprocess
import tempfile

from tests.render import rendering, scenes
from tools.repository import ROOT

SIZE = {"width": 67, "height": 45}
SHEARED = "right <1.2, 0.1, 0> "
KNOWN = ["depth.Z", "position.X", "position.Y", "position.Z"]
LENS = KNOWN + ["blur"]
SAMPLED = LENS + ["samples", "standardError"]
TURNED = scenes.camera("tilt 4 swing 2 shift <3, -2> scene_unit 100", tail="rotate 20*y translate <1, 2, 3> scale 2") + scenes.WORLD


class Rendered:
    def __init__(self, scene, *options, **how):
        with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
            folder = pathlib.Path(name)
            job = rendering.Job(scene, ("+N", *options), **{**SIZE, **how})
            self.said = job.run(folder)
            self.picture = job.result(folder)
            self.layers = rendering.read_picture(folder / "picture.layers.exr", job.told())
            self.header = header(folder / "picture.layers.exr")
            self.files = sorted(path.name for path in folder.iterdir())

    def at(self, name, x, y):
        return self.layers.pixel(x, y)[self.layers.names.index(name)]

    def pixels(self):
        return [(x, y) for y in range(self.layers.height) for x in range(self.layers.width)]

    def position(self, x, y):
        return [self.at(f"position.{axis}", x, y) for axis in "XYZ"]

    def errors(self):
        """The summary's, with bias, and the root mean square of the layer."""
        squares = [error * error for error in self.layers.channel("standardError")]
        return float(re.search(r"Standard error\.+([\d.e-]+)", self.said)[1]), math.sqrt(sum(squares) / len(squares))

    def attribute(self, name):
        found = re.search(rf"^{re.escape(name)} \(type [^)]*\):?\s*(.*?)(?=^\S|\Z)", self.header, re.MULTILINE | re.DOTALL)
        if found is None:
            raise AssertionError(f"no attribute {name}\n{self.header}")
        return [float(v) for v in re.findall(r"-?(?:inf|nan|[\d.]+(?:e[-+]?\d+)?)", found[1])]


def header(path):
    return subprocess.run(["exrheader", str(path)], capture_output=True, check=True, text=True).stdout


class Numbers(rendering.RenderTest):
    @classmethod
    def setUpClass(cls):
        cls.turned = Rendered(TURNED)

    def test_channels_and_kinds(self):
        self.assertEqual(sorted(self.turned.layers.names), sorted(SAMPLED))
        for name in SAMPLED:
            self.assertRegex(self.turned.header, rf"\n +{re.escape(name)}, 32-bit floating-point, sampling 1 1")

    def test_common_tools_open_it(self):
        with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
            rendering.Job(TURNED, ("+N",), **SIZE).run(pathlib.Path(name))
            said = subprocess.run(
                ["oiiotool", "--info", "-v", "--stats", str(pathlib.Path(name) / "picture.layers.exr")],
                capture_output=True,
                check=True,
                text=True,
            ).stdout
        self.assertIn("67 x   45, 7 channel, float openexr", said)
        self.assertIn("tiltLens:tilt: 4", said)

    def test_commands_of_the_manual(self):
        manual = ROOT / "docs" / "manual.md"
        commands = [shlex.split(line) for line in re.findall(r"^    (oiiotool board\.layers\.exr .*)$", manual.read_text(), re.MULTILINE)]
        self.assertGreaterEqual(len(commands), 4)
        with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
            folder = pathlib.Path(name)
            scene = TURNED.replace("aperture 0.3", "aperture 0.15")
            self.assertNotEqual(scene, TURNED)
            rendering.Job(scene, ("+N", "+Oboard.png"), **SIZE).attempt(folder)
            for command in commands:
                subprocess.run(command, cwd=folder, check=True, capture_output=True)
                seen = rendering.read_picture(folder / command[-1], " ".join(command))
                self.assertEqual((seen.width, seen.height), (67, 45))
                self.assertGreater(len(set(seen.values)), 8, command)

    def test_picture_is_the_same(self):
        self.assert_same(self.turned.picture, rendering.render(TURNED, **SIZE), "with and without layers")

    def test_positions_project_to_their_pixels(self):
        m = self.turned.attribute("worldToNDC")
        hits = 0
        for x, y in self.turned.pixels():
            if math.isinf(self.turned.at("depth.Z", x, y)):
                continue
            p = [*self.turned.position(x, y), 1.0]
            u, v, _, w = (sum(p[i] * m[4 * i + j] for i in range(4)) for j in range(4))
            self.assertAlmostEqual(u / w * 67, x + 0.5, delta=0.01, msg=f"column {x}, row {y}: {p}")
            self.assertAlmostEqual(v / w * 45, y + 0.5, delta=0.01, msg=f"column {x}, row {y}: {p}")
            hits += 1
        self.assertGreater(hits, 1000)

    def test_depth_is_along_the_axis(self):
        m = self.turned.attribute("worldToCamera")
        for x, y in self.turned.pixels()[::7]:
            depth = self.turned.at("depth.Z", x, y)
            if not math.isinf(depth):
                z = sum(a * m[4 * i + 2] for i, a in enumerate([*self.turned.position(x, y), 1.0]))
                self.assertAlmostEqual(z, depth, delta=1e-4 * depth)

    def test_blur_of_a_wall(self):
        """|1/Z - 1/10| times diameter times film distance in pixels."""
        for distance in (4.0, 10.0, 30.0):
            scene = (
                "camera { location 0 direction z right 1.5*x up y aperture 1 focal_point 10*z blur_samples 4 tilt_lens {} }\n"
                f"plane {{ z, {distance} pigment {{ rgb 0.5 }} }}\n"
            )
            seen = Rendered(scene)
            for x, y in ((0, 0), (33, 22), (66, 44)):
                self.assertAlmostEqual(seen.at("depth.Z", x, y), distance, delta=1e-5)
                blur = 0.5 * 67 / 1.5 * (1 / distance - 0.1)
                self.assertAlmostEqual(seen.at("blur", x, y), blur, delta=1e-5 + 1e-5 * abs(blur))

    def test_blur_of_a_tilted_lens_by_its_plane(self):
        """Proportional to the distance from the plane over the depth."""
        normal, d = self.turned.attribute("tiltLens:focusNormal"), self.turned.attribute("tiltLens:focusDistance")[0]
        m = self.turned.attribute("worldToCamera")
        location = [-sum(m[12 + j] * m[4 * i + j] for j in range(3)) for i in range(3)]
        near = d - sum(n * p for n, p in zip(normal, location))
        ratios = []
        for x, y in self.turned.pixels()[::11]:
            depth = self.turned.at("depth.Z", x, y)
            if math.isinf(depth):
                continue
            off = d - sum(n * p for n, p in zip(normal, self.turned.position(x, y)))
            blur = self.turned.at("blur", x, y)
            if abs(off) > 1e-3 * near:
                ratios.append(blur * depth / (off / near))
        self.assertGreater(len(ratios), 100)
        self.assertGreater(min(ratios), 0.0)
        self.assertLess(max(ratios) / min(ratios), 1.001)

    def test_samples_and_error(self):
        seen = self.turned
        samples = seen.layers.channel("samples")
        told = re.search(r"mean ([\d.]+), 99% \d+, most (\d+)", seen.said)
        self.assertAlmostEqual(sum(samples) / len(samples), float(told[1]), delta=0.06)
        self.assertEqual(max(samples), float(told[2]))
        whole, noise = seen.errors()
        self.assertGreater(whole, 0.94 * noise)
        whole, noise = Rendered(TURNED.replace("tilt 4", "denoise off tilt 4")).errors()
        self.assertAlmostEqual(whole, noise, delta=0.06 * noise)

    def test_nothing_met(self):
        seen = self.turned
        sky = [(x, y) for x, y in seen.pixels() if math.isinf(seen.at("depth.Z", x, y))]
        self.assertTrue(sky, "no sky in the picture")
        for x, y in sky:
            self.assertEqual(seen.position(x, y), [0.0, 0.0, 0.0])
            self.assertTrue(math.isfinite(seen.at("blur", x, y)))
        self.assertFalse(any(math.isnan(v) for v in seen.layers.values))

    def test_threads_and_tiles(self):
        for options in (("+WT4", "+BS9"), ("+WT1", "+SP16"), ("+WT2", "+HR")):
            with self.subTest(options=options):
                self.assert_same(Rendered(TURNED, *options).layers, self.turned.layers, str(options))

    def test_sub_image(self):
        part = Rendered(TURNED, "+SC11", "+EC50", "+SR7", "+ER40").layers
        place = (10, 6, 50, 40)
        self.assert_same(part.crop(*place), self.turned.layers.crop(*place), "sub-image")
        outside = [v for x, y in self.turned.pixels() if not (10 <= x < 50 and 6 <= y < 40) for v in part.pixel(x, y)]
        self.assertEqual(set(outside), {0.0})


class Attributes(rendering.RenderTest):
    def test_physical_lens(self):
        view = "location 0 direction z up 2/3*y right x look_at 10*z "
        scene = (
            f"camera {{ {view}blur_samples 4 tilt_lens {{ focal_length 50 f_stop 2 film_width 36 tilt 3 swing -2 "
            "shift <4, 6> } }\n" + "sphere { 10*z, 1 pigment { rgb 1 } }\n"
        )
        seen = Rendered(scene)
        for name, wanted in (
            ("nominalFocalLength", [50]),
            ("aperture", [2]),
            ("focus", [10]),
            ("sensorOverallDimensions", [36, 24]),
            ("tiltLens:tilt", [3]),
            ("tiltLens:swing", [-2]),
            ("tiltLens:shift", [4, 6]),
            ("tiltLens:diameter", [25]),
            ("tiltLens:millimetresPerUnit", [1000]),
        ):
            with self.subTest(name=name):
                for found, value in zip(seen.attribute(name), wanted, strict=True):
                    self.assertAlmostEqual(found, value, delta=1e-4 * abs(value))
        film = seen.attribute("pinholeFocalLength")[0]
        self.assertAlmostEqual(seen.attribute("screenWindowWidth")[0], 36 / film, delta=1e-5)
        for found, value in zip(seen.attribute("screenWindowCenter"), (4 / film, 6 / film), strict=True):
            self.assertAlmostEqual(found, value, delta=1e-5)
        across = seen.attribute("tiltLens:fieldOfView")[0]
        self.assertAlmostEqual(across, 2 * math.degrees(math.atan(18 / film)), delta=1e-3)


class Cameras(rendering.RenderTest):
    def test_pinhole(self):
        seen = Rendered(f"camera {{ {scenes.VIEW} tilt_lens {{ shift <3, 1> }} }}\n" + scenes.WORLD)
        self.assertEqual(sorted(seen.layers.names), sorted(LENS))
        self.assertEqual(set(seen.layers.channel("blur")), {0.0})

    def test_focus_aid(self):
        seen = Rendered(scenes.camera("focus_map") + scenes.WORLD)
        self.assertEqual(sorted(seen.layers.names), sorted(LENS))
        self.assertGreater(len(set(seen.layers.channel("blur"))), 100)

    def test_stock_cameras_have_their_layers(self):
        for name, camera, options in (
            ("pinhole", scenes.VIEW, ()),
            ("focal blur", scenes.VIEW + "aperture 0.3 blur_samples 9", ()),
            ("anti-aliasing 1", scenes.VIEW, ("+A0.1",)),
            ("anti-aliasing 2", scenes.VIEW, ("+A0.1", "+AM2")),
            ("preview", scenes.VIEW, ("+SP8",)),
            ("sheared", scenes.VIEW + SHEARED, ()),
        ):
            with self.subTest(name=name):
                scene = f"camera {{ {camera} }}\n" + scenes.WORLD
                seen = Rendered(scene, *options, "+WT1")
                self.assertEqual(sorted(seen.layers.names), sorted(KNOWN))
                self.assert_same(seen.picture, rendering.render(scene, *options, "+WT1", **SIZE), name)
                if name != "sheared":
                    self.assert_same(seen.layers, Rendered(f"camera {{ {scenes.VIEW} }}\n" + scenes.WORLD).layers, name)

    def test_depth_of_other_cameras_is_the_ray(self):
        for kind in ("spherical angle 90 60", "fisheye angle 90", "panoramic", "cylinder 1"):
            with self.subTest(kind=kind):
                seen = Rendered(
                    f"camera {{ {kind} location 0 look_at z }}\nsphere {{ 0, 5 pigment {{ rgb 1 }} finish {{ emission 1 }} }}\n"
                )
                for x, y in ((33, 22), (20, 15), (50, 30)):
                    self.assertAlmostEqual(seen.at("depth.Z", x, y), math.dist(seen.position(x, y), (0, 0, 0)), delta=1e-4)
                self.assertAlmostEqual(
                    seen.at("depth.Z", 33, 22), 5.0 if "cylinder" not in kind else seen.at("depth.Z", 33, 22), delta=1e-4
                )

    def test_orthographic(self):
        seen = Rendered("camera { orthographic location -3*z look_at 0 right 4*x up 3*y }\nplane { z, 2 pigment { rgb 1 } }\n")
        self.assertAlmostEqual(seen.at("depth.Z", 5, 5), 5.0, delta=1e-5)


class Files(rendering.RenderTest):
    def test_only_on_request(self):
        for options in ((), ("-N",), ("Output_Layers=off",)):
            with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
                rendering.Job(scenes.TILTED, options).run(pathlib.Path(name))
                self.assertEqual(list(pathlib.Path(name).glob("*.exr*")), [], options)

    def test_ini_option(self):
        with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
            rendering.Job(scenes.TILTED, ("Output_Layers=on",)).run(pathlib.Path(name))
            self.assertTrue((pathlib.Path(name) / "picture.layers.exr").is_file())

    def test_beside_an_exr_picture(self):
        seen = Rendered(scenes.TILTED, extension="exr")
        self.assertEqual(seen.files, ["picture.exr", "picture.layers.exr", "scene.pov"])

    def test_a_file_for_each_frame(self):
        with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
            folder = pathlib.Path(name)
            job = rendering.Job(scenes.TILTED.replace("tilt 4", "tilt 4*clock"), ("+N", "+KFI1", "+KFF3"))
            code, said = job.attempt(folder)
            self.assertEqual(code, 0, said)
            tilts = [re.search(r"tiltLens:tilt \(type float\): (\S+)", header(folder / f"picture{i}.layers.exr"))[1] for i in (1, 2, 3)]
        self.assertEqual([float(t) for t in tilts], [0.0, 2.0, 4.0])

    def refused(self, *options, prepare=None):
        with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
            folder = pathlib.Path(name)
            (folder / "out").mkdir()
            if prepare:
                prepare(folder)
            job = rendering.Job(scenes.TILTED, ("+N", "+Oout/picture.png", *options))
            code, said = job.attempt(folder)
            said = re.sub(r"\s+", " ", said)
            self.assertNotEqual(code, 0, said)
            self.assertEqual([p.name for p in (folder / "out").iterdir() if p.is_file() and p.suffix != ".pov-state"], [], said)
            return said

    def test_standard_output(self):
        for name in ("-", "stdout", "stderr", "STDOUT"):
            said = self.refused(f"+O{name}")
            self.assertEqual(said.count("Output_Layers with a picture that goes to standard output or error"), 1, said)

    def test_no_picture_file(self):
        said = self.refused("-F")
        self.assertEqual(said.count("Output_Layers without a picture file"), 1, said)

    def test_unwritable_file(self):
        said = self.refused(prepare=lambda folder: (folder / "out" / "picture.layers.exr").mkdir())
        self.assertIn("Cannot write the layers 'out/picture.layers.exr' (Is a directory)", said)

    def test_continued_after_a_write_error(self):
        with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
            folder = pathlib.Path(name)
            (folder / "picture.layers.exr").mkdir()
            job = rendering.Job(TURNED, ("+N",), **SIZE)
            code, said = job.attempt(folder)
            self.assertNotEqual(code, 0, said)
            self.assertFalse((folder / "picture.png").exists())
            (folder / "picture.layers.exr").rmdir()
            said = rendering.Job(TURNED, ("+N", "+C"), **SIZE).run(folder)
            whole = Rendered(TURNED)
            self.assert_same(rendering.read_picture(folder / "picture.layers.exr", said), whole.layers, "layers")
            self.assert_same(job.result(folder), whole.picture, "picture")
            self.assertEqual(list(folder.glob("*.pov-state")), [])

    def test_symbolic_links_are_replaced(self):
        for exists in (True, False):
            with self.subTest(exists=exists), tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
                folder = pathlib.Path(name)
                (folder / "elsewhere").mkdir()
                for file in ("picture.png", "picture.layers.exr"):
                    (folder / file).symlink_to(folder / "elsewhere" / file)
                    if exists:
                        (folder / "elsewhere" / file).write_text("old")
                rendering.Job(scenes.TILTED, ("+N",)).run(folder)
                for file in ("picture.png", "picture.layers.exr"):
                    self.assertFalse((folder / file).is_symlink(), file)
                    self.assertGreater((folder / file).stat().st_size, 100, file)
                for path in (folder / "elsewhere").iterdir():
                    self.assertEqual(path.read_text(), "old", path.name)


class Interrupted(rendering.RenderTest):
    SLOW = scenes.camera("tilt 3", samples="blur_samples 600 variance 0 ") + scenes.WORLD
    HOW = {"width": 96, "height": 72}

    def stop(self, folder, signal_, *options):
        if "+N" in options:
            (folder / "picture.layers.exr").write_text("of an older render")
        rendering.Job(self.SLOW, ("+WT1", "+BS8", *options), **self.HOW).stop(folder, signal_, 30000)
        self.assertEqual(list(folder.glob("*.exr*")), [], "no half of a file, and no older one")

    def test_continued(self):
        whole = Rendered(self.SLOW, **self.HOW).layers
        for signal_ in (signal.SIGKILL, signal.SIGINT):
            with self.subTest(signal=signal_), tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
                folder = pathlib.Path(name)
                self.stop(folder, signal_, "+N")
                said = rendering.Job(self.SLOW, ("+WT2", "+BS8", "+C", "+N"), **self.HOW).run(folder)
                pixels = re.search(r"^Pixels: +(\d+)", said, re.MULTILINE)
                self.assertLess(int(pixels[1]), 96 * 72, said)
                layers = rendering.read_picture(folder / "picture.layers.exr", said)
                self.assert_same(layers, whole, "continued")
                self.assertEqual(list(folder.glob("*.pov-state")), [])

    def test_begun_without_layers(self):
        with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
            folder = pathlib.Path(name)
            self.stop(folder, signal.SIGKILL)
            code, said = rendering.Job(self.SLOW, ("+BS8", "+C", "+N"), **self.HOW).attempt(folder)
            said = re.sub(r"\s+", " ", said)
            self.assertNotEqual(code, 0, said)
            self.assertIn("of a picture that was begun without Output_Layers", said)
            self.assertTrue(list(folder.glob("*.pov-state")), "the state file is kept")
            rendering.Job(self.SLOW, ("+BS8", "+C"), **self.HOW).run(folder)

    def test_begun_with_layers_and_continued_without(self):
        with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
            folder = pathlib.Path(name)
            self.stop(folder, signal.SIGKILL, "+N")
            job = rendering.Job(self.SLOW, ("+BS8", "+C"), **self.HOW)
            job.run(folder)
            self.assert_same(job.result(folder), rendering.render(self.SLOW, **self.HOW), "picture")
            self.assertEqual(list(folder.glob("*.exr")), [])


if __name__ == "__main__":
    rendering.main()

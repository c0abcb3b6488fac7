# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later

import csv
import math
import pathlib
import re
import tempfile

from tests.render import rendering, scenes
from tools.povray_run import INCLUDE

LENSES = INCLUDE / "lenses"
WIDTH, HEIGHT = 48, 32
SIZE = {"width": WIDTH, "height": HEIGHT, "extension": "exr"}
VIEW = "location 0 look_at <0, 0, 10> right 3/2*x "
GAUSS = 'prescription "lenses/tronnier_gauss_50.dat" '
EVEN = "background { rgb <0.5, 2, 0.125> }\n"
SAMPLES = "blur_samples 8, 32 variance 0 "
WORLD = "plane { z, 10 pigment { checker rgb 0.2 rgb 1 scale 0.5 } finish { emission 1 diffuse 0 } }\n"


def camera(items, samples=SAMPLES, view=VIEW, unit=100):
    return f"camera {{ {view}{samples}tilt_lens {{ scene_unit {unit} {items} }} }}\n"


def job(scene, options=(), **how):
    return rendering.Job(scene, (f"+L{INCLUDE}", *options), **{**SIZE, **how})


def render(scene, *options, **how):
    return rendering.render(scene, f"+L{INCLUDE}", *options, **{**SIZE, **how})


def said(scene):
    return rendering.render_and_listen(scene, f"+L{INCLUDE}", **SIZE)[1]


class EvenLight(rendering.RenderTest):
    def test_uniform_without_vignetting(self):
        for items in ("f_stop 11", "f_stop 8 tilt 1", "f_stop 16 blades 5, 20 blade_curvature 0.5", "f_stop 16 squeeze 2 tilt 2 swing 1"):
            picture = render(camera(GAUSS + items) + EVEN)
            self.assertEqual(set(zip(*(picture.channel(name) for name in "RGB"))), {(0.5, 2.0, 0.125)}, picture.told)

    def test_rims_vignette_without_noise(self):
        picture = render(camera(GAUSS) + EVEN)
        level = lambda x, y: picture.pixel(x, y)[0] / 0.5
        self.assertAlmostEqual(level(WIDTH // 2, HEIGHT // 2), 1, delta=0.01)
        self.assertLess(level(0, 0), 0.4)
        for x in range(WIDTH // 2):
            for y in range(HEIGHT // 2):
                for other in ((WIDTH - 1 - x, y), (x, HEIGHT - 1 - y)):
                    self.assertAlmostEqual(level(x, y), level(*other), delta=0.003, msg=picture.told)
                self.assertGreater(level(x + 1, y), level(x, y) - 0.002)
                self.assertLess(level(x + 1, y) - level(x, y), 0.06)

    def test_natural_vignetting_of_a_thin_lens(self):
        with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
            (pathlib.Path(name) / "thin.dat").write_text("100 1e-6 1.5 20\n-100 1e-6 1 20\n0 0 0 2\n")
            scene = camera('prescription "thin.dat" natural_vignetting 1 film_width 60', unit=1000)
            picture = rendering.render(scene + EVEN, f"+L{name}", **SIZE)
        distance = 100 / (1 - 100 / 10000)
        for x, y in ((0, 0), (47, 3), (24, 16), (10, 25)):
            film = 60 / WIDTH * math.hypot(x + 0.5 - WIDTH / 2, y + 0.5 - HEIGHT / 2)
            self.assertAlmostEqual(picture.pixel(x, y)[0] / 0.5, math.cos(math.atan(film / distance)) ** 4, delta=0.004)


class Focus(rendering.RenderTest):
    def test_as_the_ideal_lens_of_its_numbers(self):
        turned = "tilt 3 swing -2 shift <2, 1> f_stop 4 "
        samples = "blur_samples 64, 256 variance 1e-5 "
        world = WORLD + "plane { y, -0.7 pigment { checker rgb <1, 0.5, 0.2> rgb 0.1 scale 0.3 } finish { emission 1 diffuse 0 } }\n"
        glass = render(camera('prescription "lenses/leica_summicron_52.dat" ' + turned, samples) + world)
        ideal = render(camera("focal_length 52.032 " + turned, samples) + world)
        moved = render(camera("focal_length 52.032 tilt 3 swing -2 shift <-2, -1> f_stop 4", samples) + world)
        self.assert_near(glass, ideal, 0.03, "glass and ideal lens")
        self.assert_different(glass, moved, 0.2)

    def test_its_stop_blurs(self):
        near = "plane { z, 3 pigment { checker rgb 0.2 rgb 1 scale 0.12 } finish { emission 1 diffuse 0 } }\n"
        spread = lambda items: (lambda row: max(row) - min(row))(
            render(camera(GAUSS + items) + near).channel("R")[WIDTH * 16 + 16 : WIDTH * 16 + 32]
        )
        self.assertGreater(spread("f_stop 64"), 0.7)
        self.assertLess(spread(""), 0.35)


class Layers(rendering.RenderTest):
    def test_positions_match_the_picture(self):
        items = GAUSS + "f_stop 11 tilt 2 shift <1, -1>"
        with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
            folder = pathlib.Path(name)
            task = job(camera(items) + WORLD, ("+N",))
            task.run(folder)
            layers = rendering.read_picture(folder / "picture.layers.exr", task.told())
        for x, y in ((3, 4), (24, 16), (44, 27)):
            at = dict(zip(layers.names, layers.pixel(x, y)))
            self.assertAlmostEqual(at["depth.Z"], 10, places=4)
            self.assertAlmostEqual(at["position.Z"], 10, places=4)
            place = f"<{at['position.X']}, {at['position.Y']}, 10>"
            picture = render(
                camera(items, "blur_samples 64, 64 variance 0 ")
                + f"sphere {{ {place}, 0.06 pigment {{ rgb 1 }} finish {{ emission 4 }} }}\n"
            )
            light = {(i, j): picture.pixel(i, j)[0] for i in range(WIDTH) for j in range(HEIGHT)}
            middle = [sum((at[axis] + 0.5) * value for at, value in light.items()) / sum(light.values()) for axis in (0, 1)]
            self.assertAlmostEqual(middle[0], x + 0.5, delta=0.15)
            self.assertAlmostEqual(middle[1], y + 0.5, delta=0.15)

    def test_focus_aids(self):
        picture = render(camera(GAUSS + "focus_map tilt 5") + WORLD)
        self.assert_finite(picture)
        self.assertGreater(len(set(picture.channel("R"))), 1)


class Report(rendering.RenderTest):
    def test_blocked_rays_are_counted(self):
        text = said(camera(GAUSS + "tilt 5") + WORLD)
        found = re.search(r"Blocked by the glass\.(\d+) of (\d+) rays \(([0-9.]+)%\)", text)
        self.assertTrue(found, text[-1500:])
        refused, tried = int(found[1]), int(found[2])
        self.assertGreater(refused, 0)
        self.assertLess(refused, 0.4 * tried)
        self.assertNotIn("Blocked by the glass", said(camera("f_stop 2") + WORLD))

    def test_lights_are_not_sampled_and_the_first_round_is_larger(self):
        lamps = "sphere { <0.3, 0.2, 8>, 0.01 pigment { rgb 1 } finish { emission 100 } }\n"
        self.assertIn("Emitter samples", said(camera("f_stop 2") + lamps))
        self.assertNotIn("Emitter samples", said(camera(GAUSS) + lamps))
        for lens, least in (("f_stop 2", 4), (GAUSS, 8)):
            self.assertRegex(said(camera(lens, samples="") + WORLD), rf"Ended at the minimum.*, after {least} samples")


class Sampling(rendering.RenderTest):
    def test_threads_and_parts(self):
        scene = camera(GAUSS + "tilt 4 blades 6", scenes.SAMPLES, scenes.VIEW.replace("angle 45", ""), 1000) + scenes.WORLD
        self.assert_finite(self.assert_same_in_parts(scene, f"+L{INCLUDE}", first=9, last=24, **SIZE))


class Dispersion(rendering.RenderTest):
    PLANAR = 'prescription "lenses/zeiss_planar_50.dat" dispersion on '
    SINGLET = "100 4 1.5168 30 64.17\n-100 30 1 30\n0 0 0 4\n"

    def test_uniform_surface_stays_uniform(self):
        picture = render(camera(self.PLANAR + "f_stop 11") + EVEN)
        self.assertEqual(set(zip(*(picture.channel(name) for name in "RGB"))), {(0.5, 2.0, 0.125)}, picture.told)
        wide = render(camera(self.PLANAR) + EVEN)
        self.assertLess(wide.pixel(0, 0)[0], 0.4)
        for red, green, blue in zip(*(wide.channel(name) for name in "RGB")):
            self.assertEqual((red, blue), (green / 4, green / 16), wide.told)

    def test_the_middle_is_as_bright_and_as_sharp(self):
        middle = lambda picture: [sum(picture.pixel(x, y)[c] for x in range(16, 32) for y in range(8, 24)) / 256 for c in range(3)]
        plain = middle(render(camera(self.PLANAR.replace("dispersion on", "")) + WORLD))
        coloured = middle(render(camera(self.PLANAR) + WORLD))
        for a, b in zip(plain, coloured):
            self.assertAlmostEqual(a, b, delta=0.01)

    def test_colours_focus_as_in_the_closed_form(self):
        film, radius = 0.5, 0.001  # mm, width of the film; units, of the point at 10
        with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
            (pathlib.Path(name) / "singlet.dat").write_text(self.SINGLET)
            scene = camera(f'prescription "singlet.dat" dispersion on film_width {film}', "blur_samples 2048, 2048 variance 0 ", unit=1000)
            point = f"sphere {{ <0, 0, 10>, {radius} pigment {{ rgb 1 }} finish {{ emission 1000 diffuse 0 }} }}\n"
            picture = rendering.render(scene + point, f"+L{name}", **SIZE)
        own = (film / WIDTH) ** 2 / 6 + (radius / 10 * 101) ** 2 / 2
        found = {}
        for colour in "RGB":
            light = dict(zip(((x, y) for y in range(HEIGHT) for x in range(WIDTH)), picture.channel(colour)))
            square = sum(((x + 0.5 - WIDTH / 2) ** 2 + (y + 0.5 - HEIGHT / 2) ** 2) * value for (x, y), value in light.items())
            found[colour] = math.sqrt(2 * max(0, square / sum(light.values()) * (film / WIDTH) ** 2 - own))
        for colour, shortest in zip("RGB", (600, 500, 400)):
            mean = math.sqrt(sum(self.disc(shortest + step + 0.5) ** 2 for step in range(100)) / 100)
            self.assertAlmostEqual(found[colour], mean, delta=0.005, msg=f"{found}, {colour}: {mean}")

    @staticmethod
    def disc(wavelength):
        """Radius, mm, behind a thick lens with dispersion; the stop is 30 mm behind."""
        index = 1.5168 + 0.5168 / 64.17 * (wavelength**-2 - 587.6**-2) / (486.1**-2 - 656.3**-2)
        focal = lambda n: 1 / ((n - 1) * (2 / 100 - (n - 1) * 4 / (n * 100 * 100)))
        image = lambda n: 1 / (1 / focal(n) - 1 / 10000)
        return abs(image(1.5168) - image(index)) * 2 / (image(1.5168) - 32)

    def test_threads_and_parts(self):
        scene = camera(self.PLANAR + "tilt 4 blades 6", scenes.SAMPLES, scenes.VIEW.replace("angle 45", ""), 1000) + scenes.WORLD
        self.assert_finite(self.assert_same_in_parts(scene, f"+L{INCLUDE}", first=9, last=24, **SIZE))


class Files(rendering.RenderTest):
    def test_each_lens_of_the_folder(self):
        with (LENSES / "lenses.csv").open(encoding="utf-8") as table:
            rows = list(csv.DictReader(table))
        self.assertEqual({row["file"] for row in rows}, {path.name for path in LENSES.iterdir()} - {"lenses.csv"})
        for row in rows:
            with self.subTest(row["file"]):
                scene = camera(f'prescription "lenses/{row["file"]}", 60 f_stop 4.2 tilt 1') + WORLD
                picture, text = rendering.render_and_listen(scene, f"+L{INCLUDE}", **SIZE)
                self.assert_finite(picture)
                # moved groups change the focal length
                moves = '"object-distance"' in (LENSES / row["file"]).read_text(encoding="utf-8")
                focal = float(re.search(r"Focal length\.+(\S+) mm", text)[1])
                self.assertAlmostEqual(focal, 60, delta=6 if moves else 0.001)
                self.assertEqual("Inner focus" in text, moves)
                self.assertGreater(max(picture.channel("R")) - min(picture.channel("R")), 0.7)
                if row["file"] != "tronnier_gauss_50.dat":  # its source has no Abbe numbers
                    scene = scene.replace("tilt 1", "tilt 1 dispersion on")
                    picture, text = rendering.render_and_listen(scene, f"+L{INCLUDE}", **SIZE)
                    self.assert_finite(picture)
                    # one glass of the Abbe number 50 would be off by 1.3 mm
                    blue, green, red = map(float, re.search(r"focus of colours\.+(\S+), (\S+), (\S+) mm", text).groups())
                    self.assertLess(max(abs(blue), abs(green), abs(red)), 0.5)


class Lamps(rendering.RenderTest):
    """Small lamps far out of focus, known to the sampler or not. The lens's aberrations fold their discs, and its rims cut them."""

    KNOWN = "pigment { rgb <1, 0.8, 0.5> } finish { ambient 0 diffuse 0 emission 300 }"
    UNKNOWN = scenes.unknown_glow(300, 240, 150)

    @staticmethod
    def picture(samples, glow, dispersion, radius=0.002):
        lens = f'prescription "lenses/zeiss_planar_50.dat" dispersion {dispersion} swing 3'
        places = ((0, 0, 30), (-9, 5, 40), (4, -3, 25), (1, 0.6, 5))
        lamps = "".join(f"sphere {{ <{x}, {y}, {z}>, {radius * z:g} {glow} }}\n" for x, y, z in places)
        view = VIEW + "focal_point 8*z "
        return render(camera(lens, samples + " variance 0 ", view, 40) + scenes.UNKNOWN_LIGHTS + lamps)

    def test_aimed_samples_have_less_noise(self):
        for dispersion in ("off", "on"):
            with self.subTest(dispersion):
                truth = self.picture("blur_samples 256, 256", self.KNOWN, dispersion).values
                known, unknown = (self.picture("blur_samples 64, 64", glow, dispersion).values for glow in (self.KNOWN, self.UNKNOWN))
                errors = [sum((a - b) ** 2 for a, b in zip(picture, truth)) for picture in (known, unknown)]
                self.assertGreater(errors[1], 10 * errors[0])

    def test_light_is_neither_gained_nor_lost(self):
        for dispersion in ("off", "on"):
            with self.subTest(dispersion):
                known, unknown = (
                    self.picture(samples, glow, dispersion, 0.008)
                    for samples, glow in (("blur_samples 64, 64", self.KNOWN), ("blur_samples 512, 512", self.UNKNOWN))
                )
                for channel in "RGB":
                    self.assertAlmostEqual(sum(known.channel(channel)) / sum(unknown.channel(channel)), 1, delta=0.03, msg=channel)


if __name__ == "__main__":
    rendering.main()

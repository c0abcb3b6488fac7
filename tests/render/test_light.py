# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Constant surroundings, radiosity, photons and media."""

from tests.render import rendering, scenes

SIZE = {"width": 48, "height": 36, "extension": "exr"}


class Furnace(rendering.RenderTest):
    LENSES = (
        "",
        "tilt 8",
        "swing -12",
        "tilt 60",
        "tilt 10 swing 10 shift <40, -30>",
        "blades 3",
        "blades 7, 20",
        "squeeze 2",
        "edge_light 0.5",
        "tilt 5 distortion 0.2 field_curvature 1 axial_colour 0.2 lateral_colour 0.1",
        "tilt 6 blades 5, 10 blade_curvature 0.5 squeeze 0.5",
        "focal_plane { y, 0 }",
        "focal_plane { z, -7 }",
        "focus_tilt 89",
        "focal_points x, y, z",
    )

    def check(self, camera):
        picture = rendering.render(camera + "background { rgb <0.5, 2, 0.125> }\n", **SIZE)
        self.assertEqual(set(zip(*(picture.channel(name) for name in "RGB"))), {(0.5, 2.0, 0.125)}, picture.told)

    def test_lenses(self):
        for lens in self.LENSES:
            for aperture in (4,) if lens else (0.01, 4):
                with self.subTest(lens=lens, aperture=aperture):
                    self.check(scenes.camera(lens, aperture, samples="blur_samples 3, 17 "))

    def test_bokeh(self):
        for pigment in (
            "rgb 1",
            "rgb 0.01",
            "gradient x",
            "image_map { function 8, 8 { select(x - 0.5, 0, 1) } }",
            "function { select((x - 0.5)*(x - 0.5) + (y - 0.5)*(y - 0.5) - 0.04, 1, 0) }",
        ):
            with self.subTest(pigment=pigment):
                self.check(scenes.camera("tilt 5", 0.5, tail=f"bokeh {{ pigment {{ {pigment} }} }}"))

    def test_inside_a_glowing_ball(self):
        scene = scenes.camera("tilt 10 swing 5") + ("sphere { 0, 100 hollow pigment { rgb 1 } finish { ambient 0.5 diffuse 0 } }\n")
        picture = rendering.render(scene, **SIZE)
        self.assertEqual(set(picture.channel("R") + picture.channel("G") + picture.channel("B")), {0.5}, picture.told)


class Renders(rendering.RenderTest):
    WORLDS = {
        "radiosity": "global_settings { radiosity { count 30 pretrace_start 0.1 pretrace_end 0.05 } }\n",
        "photons": "global_settings { photons { count 3000 } }\n"
        "sphere { <-0.8, 0.5, -0.5>, 0.4 pigment { rgbf 0.9 } interior { ior 1.4 }"
        " photons { target refraction on reflection on } }\n",
        "media": "box { <-5, -1, -5>, <5, 5, 5> hollow pigment { rgbt 1 } interior { media {"
        " scattering { 1, 0.05 } emission 0.02 samples 4, 8 } } }\n",
        "fog": "fog { distance 10 rgb 0.8 }\n",
        "camera inside glass": "sphere { <0.4, 1.5, -4>, 0.5 pigment { rgbf 0.95 } interior { ior 1.2 } hollow }\n",
        "lens half in glass": "box { <0.4, 0, -5>, <2, 3, -3> pigment { rgbf 0.95 } interior { ior 1.05 } hollow }\n",
    }

    def test_worlds(self):
        for name, world in self.WORLDS.items():
            with self.subTest(name):
                samples = "blur_samples 16, 64 variance 1/1000 "
                lens = rendering.render(scenes.camera("tilt 3", 0.002, samples) + world + scenes.WORLD, "+WT1", **SIZE)
                self.assert_finite(lens)
                pinhole = rendering.render(f"camera {{ {scenes.VIEW} }}\n" + world + scenes.WORLD, "+WT1", "+A0.0", "+R4", **SIZE)
                limit = 0.4 if name == "lens half in glass" else 0.05
                self.assert_near(lens, pinhole, limit, name)

    def test_camera_normal(self):
        tail = "normal { waves 0.05 scale 0.3 }"
        lens = rendering.render(scenes.camera("tilt 3", 0.002, tail=tail) + scenes.WORLD, **SIZE)
        stock = rendering.render(f"camera {{ {scenes.VIEW}{tail} }}\n" + scenes.WORLD, "+A0.0", "+R4", **SIZE)
        flat = rendering.render(f"camera {{ {scenes.VIEW} }}\n" + scenes.WORLD, "+A0.0", "+R4", **SIZE)
        self.assert_different(stock, flat, 0.1)
        self.assert_near(lens, stock, 0.06, "normal")

    def test_samples_of_a_camera_with_a_normal_stay_in_their_pixel(self):
        """A normal would displace a sample from its circle of confusion."""

        def render(denoise, tail):
            camera = scenes.camera(f"denoise {denoise}", 0.6, "blur_samples 1 ", tail=tail)
            return rendering.render(camera + scenes.WORLD, **SIZE)

        bumps = "normal { bumps 0.6 scale 0.25 }"
        self.assert_same(render("on", bumps), render("off", bumps), "normal")
        self.assert_different(render("on", ""), render("off", ""), 0.01, "no normal")

    def test_no_image(self):
        scene = scenes.camera() + scenes.WORLD
        ball = "sphere { <0, 1, -1>, 0.7 pigment { rgb 1 } no_image no_shadow no_reflection }\n"
        self.assert_same(rendering.render(scene + ball, **SIZE), rendering.render(scene, **SIZE), "no_image")

    def test_extreme_numbers(self):
        for lens, aperture in (
            ("tilt 89.99", 0.3),
            ("tilt 5 swing -89", 0.3),
            ("focal_plane { y, 1.4999999 }", 0.3),
            ("tilt 5", 1e6),
            ("tilt 5", 1e-9),
            ("shift <1e5, -1e5>", 0.3),
        ):
            with self.subTest(lens=lens, aperture=aperture):
                self.assert_finite(rendering.render(scenes.camera(lens, aperture, "blur_samples 8 ") + scenes.WORLD, **SIZE))

    def test_png_equals_exr(self):
        scene = scenes.camera(samples="blur_samples 16 variance 0 ") + scenes.WORLD
        exr = rendering.render(scene, **SIZE)
        png = rendering.render(scene, **{**SIZE, "extension": "png"})
        limited = rendering.Picture(exr.width, exr.height, exr.names, [min(1.0, v) for v in exr.values], exr.told)
        self.assert_near(png, limited, 5e-4, "PNG and EXR")


if __name__ == "__main__":
    rendering.main()

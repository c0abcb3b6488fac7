# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Pinholes, shifts and blur agree with POV-Ray's camera."""

import math

from tests.render import rendering, scenes

SIZE = {"width": 72, "height": 54}
RIGHT = "right 4/3*x "


def pinhole(lens, view=scenes.VIEW):
    return f"camera {{ {RIGHT}{view}tilt_lens {{ {lens} }} }}\n" + scenes.WORLD


def stock(view=scenes.VIEW):
    return f"camera {{ {RIGHT}{view} }}\n" + scenes.WORLD


class Pinhole(rendering.RenderTest):
    def test_without_shift(self):
        for lens in ("", "tilt 0 shift <0, 0>", "film_width 24 scene_unit 10"):
            for options in ((), ("+A0.2", "+AM2", "+R2", "-J")):
                with self.subTest(lens=lens, options=options):
                    self.assert_same(
                        rendering.render(pinhole(lens), *options, **SIZE), rendering.render(stock(), *options, **SIZE), "pinhole"
                    )

    def test_tilt_shows_nothing(self):
        self.assert_same(rendering.render(pinhole("tilt 8 swing -3"), **SIZE), rendering.render(stock(), **SIZE), "tilt")

    def test_aperture_0(self):
        scene = scenes.camera("", aperture=0, samples="", view=RIGHT + scenes.VIEW) + scenes.WORLD
        self.assert_same(rendering.render(scene, **SIZE), rendering.render(stock(), **SIZE), "aperture 0")

    def test_shift_is_a_shear(self):
        view = "location <0.4, 1.5, -4> right 4/3*x up y focal_point <0, 0, 0.5> "
        own = f"camera {{ {view}direction z tilt_lens {{ shift <9, -4.5> }} }}\n" + scenes.WORLD
        sheared = f"camera {{ {view}direction <4/3*0.25, -4/3*0.125, 1> }}\n" + scenes.WORLD
        self.assert_near(rendering.render(own, **SIZE), rendering.render(sheared, **SIZE), 1e-4, "shear")

    def test_shift_by_whole_pixels(self):
        still = rendering.render(pinhole(""), **SIZE)
        moved = rendering.render(pinhole("shift <3.5, 2>"), **SIZE)
        self.assert_near(moved.crop(0, 4, 65, 54), still.crop(7, 0, 72, 50), 1e-3, "shift")
        self.assert_different(moved, still, 0.01)


class WithAperture(rendering.RenderTest):
    def test_shift_by_whole_pixels(self):
        samples = "blur_samples 512 variance 0 "
        view = RIGHT + "location <0.4, 1.5, -4> look_at <0, 0.5, 0.5> angle 45 "
        size = {"width": 36, "height": 27}
        still = rendering.render(scenes.camera("focal_plane { y, 0.1 }", samples=samples, view=view) + scenes.WORLD, **size)
        moved = rendering.render(scenes.camera("focal_plane { y, 0.1 } shift <5, 3>", samples=samples, view=view) + scenes.WORLD, **size)
        self.assert_near(moved.crop(0, 3, 31, 27), still.crop(5, 0, 36, 24), 0.006, "shift")


class BlurSize(rendering.RenderTest):
    SCENE = "sphere { <0, 0, 8>, 0.1 pigment { rgb 1 } finish { ambient 20 diffuse 0 } }\n"
    CAMERA = "location -4*z right 4/3*x up y direction 1.5*z focal_point 0 aperture 2 blur_samples 1500 variance 0 "

    def spread(self, scene):
        """Root mean square distance from the centre of light, pixels; light."""
        picture = rendering.render(scene, width=48, height=36, extension="exr")
        light = picture.channel("R")
        total = sum(light)
        self.assertGreater(total, 0, picture.told)
        moments = [0.0] * 3
        for i, v in enumerate(light):
            x, y = i % 48, i // 48
            moments = [moments[0] + v * x, moments[1] + v * y, moments[2] + v * (x * x + y * y)]
        x, y, squares = (m / total for m in moments)
        return math.sqrt(squares - x * x - y * y), total

    def test_against_stock_and_theory(self):
        own, light = self.spread(f"camera {{ {self.CAMERA}tilt_lens {{}} }}\n{self.SCENE}")
        stock_spread, stock_light = self.spread(f"camera {{ {self.CAMERA} }}\n{self.SCENE}")
        # diameter 1, focus 4, light at 12, frame 4/3 wide at 1.5, 48 pixels
        pixels = 1.5 / (4 / 3) * 48
        lens, ball = abs(1 / 12 - 1 / 4) * pixels / 2, 0.1 / 12 * pixels
        # half the square of each disc's radius; a pixel's own 1/12 twice
        theory = math.sqrt(lens * lens / 2 + ball * ball / 2 + 1 / 6)
        told = f"spread {own:g}, stock {stock_spread:g}, theory {theory:g}; light {light:g}, stock {stock_light:g}"
        self.assertLess(abs(own / theory - 1), 0.04, told)
        self.assertLess(abs(own / stock_spread - 1), 0.1, told)
        self.assertLess(abs(light / stock_light - 1), 0.15, told)

    def test_blur_scales_with_aperture(self):
        half = self.CAMERA.replace("aperture 2", "aperture 1")
        self.assertLess(
            self.spread(f"camera {{ {half}tilt_lens {{}} }}\n{self.SCENE}")[0],
            0.75 * self.spread(f"camera {{ {self.CAMERA}tilt_lens {{}} }}\n{self.SCENE}")[0],
        )


if __name__ == "__main__":
    rendering.main()

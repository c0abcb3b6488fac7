# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Unnecessary work is skipped, and counted."""

import re

from tests.render import rendering, scenes

SIZE = {"width": 64, "height": 48, "extension": "exr"}
EVEN = "background { rgb 0.5 }\n"
FLOOR = "plane { y, 0 pigment { checker rgb 1 rgb 0.2 scale 0.1 } finish { ambient 1 diffuse 0 } }\n"
GRID = "light_source { <4, 6, -4>, rgb 1 area_light x*3, z*3, 7, 5 adaptive 0 }\nplane { y, 0 pigment { rgb 0.7 } }\n"
LAMP = "sphere { <0, 0.5, 6>, 0.01 pigment { rgb 1 } finish { emission 50 ambient 0 } }\n"
LEVEL = "location <0.4, 1.5, -4> look_at <0, 1.5, 0.5> angle 45 "
GLASS = "sphere { SPHERE pigment { rgbt 1 } interior { ior 1.3 } }\n"


def numbers(line, said):
    found = re.search(rf"^  {line}\.+(.*)$", said, re.M)
    return [int(number) for number in re.findall(r"\d+", found.group(1))] if found else None


def said_of(world, samples="blur_samples 8, 256 variance 1/2000 ", aperture=0.3, lens="scene_unit 100", view=scenes.VIEW):
    return rendering.render_and_listen(scenes.camera(lens, aperture, samples, view) + world, **SIZE)[1]


class Skipped(rendering.RenderTest):
    def test_even_pixels_end_at_the_minimum(self):
        self.assertEqual(numbers("Ended at the minimum", said_of(EVEN)), [64 * 48, 64 * 48, 8])
        ended = numbers("Ended at the minimum", said_of(FLOOR + EVEN, view=LEVEL))
        self.assertGreaterEqual(ended[0], 64 * 16)
        self.assertLess(ended[0], 64 * 24)

    def test_minimum_is_a_power_of_two(self):
        self.assertEqual(numbers("Ended at the minimum", said_of(EVEN, "blur_samples 9, 256 variance 1/2000 "))[2], 16)
        self.assertIsNone(numbers("Ended at the minimum", said_of(EVEN, "blur_samples 9, 16 variance 0 ")))

    def test_first_round_has_four_samples_if_eight_bring_nothing(self):
        for samples, lens, least in (
            ("", "", 4),
            ("blur_samples 64 ", "", 4),
            ("blur_samples 2 ", "", 2),
            ("", "denoise off", 8),
            ("normal { bumps 1e-5 } ", "", 8),
            ("variance 0 blur_samples 8 ", "", None),
            ("blur_samples 16, 64 ", "", 16),
        ):
            with self.subTest(samples + lens):
                ended = numbers("Ended at the minimum", said_of(EVEN, samples, lens="scene_unit 100 " + lens))
                self.assertEqual(ended, least and [64 * 48, 64 * 48, least])

    def test_sharp_picture_takes_the_minimum_but_at_edges(self):
        board = "plane { y, 0 pigment { checker rgb 1 rgb 0.2 scale 20 } finish { ambient 1 diffuse 0 } }\n"
        ended = numbers("Ended at the minimum", said_of(board + EVEN, aperture=1e-6))
        self.assertLess(ended[0], 64 * 48)
        self.assertGreater(ended[0], 0.7 * 64 * 48)

    def test_pixels_without_noise_are_not_rebuilt(self):
        self.assertEqual(numbers("Reconstruction", said_of(EVEN)), [0, 64 * 48])
        for samples in (8, 64):
            # rounding errors of shares spread over wide circles are no noise
            said = said_of(EVEN, f"blur_samples {samples}, 256 variance 1/2000 ", aperture=2)
            self.assertEqual(numbers("Reconstruction", said), [0, 64 * 48])
        ball = "sphere { <0, 0.5, 0.5>, 0.3 pigment { checker rgb 1 rgb 0 scale 0.1 } finish { ambient 1 diffuse 0 } }\n"
        wall = "plane { z, 20 pigment { rgb 0.5 } finish { ambient 1 diffuse 0 } }\n"
        rebuilt = numbers("Reconstruction", said_of(ball + wall))
        self.assertGreater(rebuilt[0], 100)
        self.assertGreater(rebuilt[1], 1000)
        # only outlines have noise
        self.assertGreater(numbers("Reconstruction", said_of(ball + EVEN, "blur_samples 8, 16 variance 1/2000 "))[0], 100)
        small = ball.replace("0.3", "0.15")
        for samples in ("blur_samples 8, 16 variance 1/2000 ", "blur_samples 8, 4096 variance 1/200000 "):
            rebuilt = numbers("Reconstruction", said_of(small + EVEN, samples))
            self.assertGreater(rebuilt[0], 100)
            self.assertGreater(rebuilt[1], 1000)
        self.assertIsNone(numbers("Reconstruction", said_of(FLOOR, lens="denoise off")))
        self.assertIsNone(numbers("Reconstruction", said_of(FLOOR, "blur_samples 8, 16 variance 0 ")))

    def test_area_light_is_sampled_at_one_point(self):
        said = said_of(GRID, "blur_samples 8, 8 variance 0 ")
        asked, left_out = numbers("Area lights", said)
        self.assertEqual(left_out, asked * (7 * 5 - 1))
        self.assertLessEqual(asked, 64 * 48 * 8)
        self.assertGreater(asked, 64 * 48 * 3)
        self.assertIsNone(numbers("Area lights", said_of(EVEN)))

    def test_emitters_are_sampled_only_where_visible(self):
        samples, lamps = numbers("Emitter samples", said_of(LAMP, "blur_samples 8, 8 variance 1/1000 "))
        self.assertEqual(lamps, 1)
        self.assertGreater(samples, 0)
        self.assertLess(samples, 64 * 48)
        self.assertIsNone(numbers("Emitter samples", said_of(EVEN)))
        large = LAMP.replace("0.01 pigment", "1 pigment")
        self.assertIsNone(numbers("Emitter samples", said_of(large)))

    def test_emitters_are_brighter_than_lit_objects(self):
        """A dim lamp is an emitter in moonlight and before a darker background."""
        lamp = LAMP.replace("emission 50", "emission 0.9").replace("0.01 pigment", "0.04 pigment")
        moon = "light_source { <4, 6, -4>, rgb 0.02 }\n"
        self.assertEqual(numbers("Emitter samples", said_of(lamp + moon))[1], 1)
        self.assertIsNone(numbers("Emitter samples", said_of(lamp + moon.replace("0.02", "1.5"))))
        self.assertIsNone(numbers("Emitter samples", said_of(lamp + moon + moon.replace("0.02", "1.48"))))
        self.assertEqual(numbers("Emitter samples", said_of(lamp + moon + moon.replace("0.02", "0.5")))[1], 1)
        self.assertEqual(numbers("Emitter samples", said_of(lamp))[1], 1)
        for brighter in (
            "background { rgb 0.9 }\n",
            "sky_sphere { pigment { rgb 0 } }\n",
            "fog { distance 1000 color rgb 0 }\n",
            "plane { -z, -50 pigment { rgb 0.9 } finish { emission 1 } }\n",
        ):
            self.assertIsNone(numbers("Emitter samples", said_of(lamp + brighter)), brighter)
        self.assertIsNone(numbers("Emitter samples", said_of("global_settings { radiosity { count 2 } }\n" + lamp + moon)))

    def test_colours_of_a_pattern_count(self):
        for colour, emission, lamps in ((50, 1, [1]), (0.5, 100, [1]), (0.005, 50, None)):
            pattern = f"gradient x color_map {{ [0 rgb 0] [1 rgb {colour}] }}"
            lamp = LAMP.replace("rgb 1", pattern).replace("emission 50", f"emission {emission}")
            found = numbers("Emitter samples", said_of(EVEN + lamp))
            self.assertEqual(found and found[1:], lamps, colour)

    def test_textures_of_a_mesh_count(self):
        def mesh(corner, textures):
            return (
                f"mesh2 {{ vertex_vectors {{ 3, 0, x*{corner}, y*{corner} }} {textures} face_indices {{ 1, <0, 1, 2>, 0 }}"
                " translate <0, 0.5, 6> }\n"
            )

        lamp = "texture_list { 1, texture { pigment { rgb 1 } finish { emission 50 } } }"
        self.assertEqual(numbers("Emitter samples", said_of(EVEN + mesh(0.01, lamp)))[1], 1)
        self.assertIsNone(numbers("Emitter samples", said_of(EVEN + mesh(0.01, lamp.replace("50", "0.1")))))
        painted = "texture_list { 1, texture { pigment { checker rgb 0 rgb 1 } finish { emission 50 } } }"
        self.assertIsNotNone(numbers("Lamps searched", said_of(EVEN + mesh(5, painted))))

    def test_objects_away_from_the_lens_are_not_tested(self):
        away = GLASS.replace("SPHERE", "<0, 0.5, 1>, 0.3") + GLASS.replace("SPHERE", "<1, 0.5, 1>, 0.3")
        self.assertEqual(numbers("Around the lens", said_of(EVEN + away)), [0, 2, 0])
        self.assertIsNone(numbers("Around the lens", said_of(EVEN)))

    def test_only_objects_touching_the_lens_are_tested(self):
        """Objects tested, with an interior, containing the lens at <0.4, 1.5, -4>, 0.075 wide."""
        rest = "pigment { rgbt 1 } interior { ior 1.3 } "
        for solid, found in (
            ("sphere { <0.4, 1.5, -4>, 0.5", [0, 1, 1]),
            ("sphere { <0.4, 1.5, -4>, 0.05", [1, 1, 0]),
            ("sphere { <0.4, 1.5, -4>, 0.5 scale 2 translate <-0.4, -1.5, 4>", [0, 1, 1]),
            ("sphere { <0.4, 1.5, -4>, 0.01 inverse", [1, 1, 0]),
            ("box { <0, 1, -5>, <1, 2, -3>", [0, 1, 1]),
            ("box { <0, 1, -5>, <1, 1.5, -3>", [1, 1, 0]),
            ("box { <0.39, 1, -5>, <0.41, 2, -3> inverse", [1, 1, 0]),
            ("plane { y, 0", [0, 1, 0]),
            ("plane { y, 1.5", [1, 1, 0]),
            ("plane { y, 3", [0, 1, 1]),
            ("plane { y, 3 inverse", [0, 1, 0]),
            ("plane { x+y, 0", [0, 1, 0]),
            ("cylinder { <0.4, 1, -4>, <0.4, 2, -4>, 1", [1, 1, 0]),
        ):
            with self.subTest(solid):
                self.assertEqual(numbers("Around the lens", said_of(EVEN + solid + " " + rest + "}\n")), found)

    def test_known_and_tested_interiors_render_alike(self):
        fog = "hollow pigment { rgbt 1 } interior { media { absorption 0.3 } } "
        lens = scenes.camera("scene_unit 100", 0.3, "blur_samples 8, 8 ")
        known, asked, without = (
            rendering.render_and_listen(lens + FLOOR + EVEN + solid + fog + "}\n", **SIZE)[0]
            for solid in (
                "sphere { <0.4, 1.5, -4>, 3 ",
                "intersection { sphere { <0.4, 1.5, -4>, 3 } plane { y, 9 } ",
                "sphere { <0.4, 1.5, -40>, 3 ",
            )
        )
        self.assert_same(known, asked)
        self.assertLess(sum(known.values), 0.8 * sum(without.values))

    def test_pinhole_takes_one_ray_per_pixel(self):
        said = said_of(FLOOR + EVEN, aperture=0)
        self.assertNotIn("Tilt Lens Sampling", said)
        self.assertRegex(said, r"Rays:\s+3072\b")


if __name__ == "__main__":
    rendering.main()

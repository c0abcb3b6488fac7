# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Pixels and cost of focus_peaking, focus_map, show_planes."""

import functools
import math
import re

from tests.render import rendering, scenes

SIZE = {"width": 131, "height": 93}  # no multiple of any tile; large enough for the map's scale
AREA_LIT = """light_source { <4, 8, -6>, rgb 1 area_light x*3, z*3, 5, 5 adaptive 1 }
plane { y, 0 pigment { checker rgb 1 rgb 0.7 } } sphere { <0.3, 0.8, 0>, 0.7 pigment { rgb <0.8, 0.3, 0.2> } }
"""
LENS = "tilt 4 swing 2 shift <2, -1> "
PEAKING = "focus_peaking rgb <0, 1, 0>, 1.5 "
AIDS = (PEAKING, "focus_map ", "show_planes ", "show_planes focus_peaking rgb <1, 0, 1> ")


@functools.cache
def picture(aid, *options, lens=LENS, world=scenes.WORLD, **how):
    return rendering.render(scenes.camera(lens + aid) + world, *options, **{**SIZE, **how})


def pinhole(world=scenes.WORLD, lens=LENS, **how):
    return rendering.render(f"camera {{ {scenes.VIEW} tilt_lens {{ {lens} }} }}\n" + world, **{**SIZE, **how})


def wall(distance, aid, width=64, height=48):
    """A black wall with the blur |1/Z - 1/10| times 0.5 * 1 * 64 pixels (diameter, film distance, width)."""
    scene = (
        f"camera {{ location 0 direction z right x up 0.75*y aperture 1 focal_point 10*z tilt_lens {{ {aid} }} }}\n"
        f"plane {{ z, {distance} pigment {{ rgb 0 }} }}\n"
    )
    return rendering.render(scene, width=width, height=height), 32 * (1 / distance - 1 / 10)


def brightness(pixel):
    return 0.2 * pixel[0] + 0.7 * pixel[1] + 0.1 * pixel[2]


class Repeatable(rendering.RenderTest):
    def test_threads_tiles_and_previews(self):
        for aid in AIDS:
            whole = picture(aid)
            for options in (("+WT4", "+BS9"), ("+WT1", "+SP32", "+EP4")):
                with self.subTest(aid=aid, options=options):
                    self.assert_same(picture(aid, *options), whole, aid)

    def test_sub_images(self):
        for aid in AIDS:
            with self.subTest(aid=aid):
                part = picture(aid, "+WT2", "+SC23", "+EC120", "+SR18", "+ER90")
                place = (22, 17, 120, 90)
                self.assert_same(part.crop(*place), picture(aid).crop(*place), aid)

    def test_anti_aliasing_is_left_out(self):
        for aid in AIDS[:3]:
            with self.subTest(aid=aid):
                with_aa, said = rendering.render_and_listen(scenes.camera(LENS + aid) + scenes.WORLD, "+A0.1", **SIZE)
                self.assert_same(with_aa, picture(aid), aid)
                self.assertEqual(re.sub(r"\s+", " ", said).count("(+A) is not used with"), 1, said)


class Peaking(rendering.RenderTest):
    def count_tinted(self, drawn, plain):
        tinted = 0
        for i in range(plain.width * plain.height):
            x, y = i % plain.width, i // plain.width
            was, now = plain.pixel(x, y), drawn.pixel(x, y)
            if max(abs(a - b) for a, b in zip(was, now)) < 1e-4:
                continue
            half = [0.5 * was[0], 0.5 * was[1] + 0.5, 0.5 * was[2]]
            self.assertLess(max(abs(a - b) for a, b in zip(half, now)), 1e-4, f"column {x}, row {y}: {was} became {now}\n{drawn.told}")
            tinted += 1
        return tinted

    def test_tints_exactly_the_sharp_pixels(self):
        sharp = picture(PEAKING)
        tinted = self.count_tinted(sharp, pinhole())
        self.assertTrue(300 < tinted < 9000, f"{tinted} pixels are tinted\n{sharp.told}")

    def test_an_area_light_lights_with_all_its_points(self):
        tinted = self.count_tinted(picture(PEAKING, world=AREA_LIT), pinhole(world=AREA_LIT))
        self.assertGreater(tinted, 300)

    def test_the_pixels_of_blur(self):
        for distance in (7.53, 14.9):
            for limit, tint in (("", 0.0), (", 1", 0.0), (", 1.1", 0.5), (", 0.9", 0.0)):
                with self.subTest(distance=distance, limit=limit):
                    seen, blur = wall(distance, "focus_peaking rgb <1, 1, 1>" + limit)
                    self.assertTrue(1.0 < abs(blur) < 1.1, blur)
                    self.assertAlmostEqual(seen.pixel(30, 20)[0], tint, delta=0.001, msg=seen.told)

    def test_sharp_by_default_under_one_pixel(self):
        seen, blur = wall(9.8, "focus_peaking rgb 1")
        self.assertLess(abs(blur), 1.0)
        self.assertAlmostEqual(seen.pixel(30, 20)[0], 0.5, delta=0.001, msg=seen.told)


class Map(rendering.RenderTest):
    def test_hue_is_the_side_and_darkness_the_amount(self):
        before = None
        for distance in (10.0, 9.0, 7.0, 5.0, 3.0, 1.5, 0.8, 0.4):
            seen, blur = wall(distance, "focus_map")
            red, _, blue = seen.pixel(5, 5)
            shade = brightness(seen.pixel(5, 5))
            if distance < 10.0:
                self.assertGreater(red, blue, f"blur {blur}, before the plane: orange\n{seen.told}")
                self.assertLess(shade, before, f"blur {blur}: darker than a smaller one\n{seen.told}")
            before = shade
        before = 2.0
        for distance in (10.0, 12.0, 20.0, 1e4):
            seen, blur = wall(distance, "focus_map")
            red, _, blue = seen.pixel(5, 5)
            if distance > 10.0:
                self.assertGreater(blue, red, f"blur {blur}, behind the plane: blue\n{seen.told}")
                self.assertLess(brightness(seen.pixel(5, 5)), before, f"blur {blur}\n{seen.told}")
            before = brightness(seen.pixel(5, 5))

    def test_sharp_is_white(self):
        seen, _ = wall(10.0, "focus_map")
        self.assertGreater(min(seen.pixel(5, 5)), 0.9, seen.told)

    def test_colour_matches_the_scale(self):
        for distance, name in ((7.0, "before"), (16.0, "behind")):
            with self.subTest(distance=distance):
                seen, blur = wall(distance, "focus_map", 640, 480)
                blur *= 10
                place = math.copysign(math.log1p(abs(blur)) / math.log1p(64), blur)
                # 2 dots around the box; the bar begins at 2 + 6
                left, right = 4 + 16, 640 - 4 - 16
                column = round(left + 0.5 * (place + 1) * (right - left) - 0.5)
                row = 480 - 4 - 2 * (2 + 5 + 2 + 2)
                bar, shown = seen.pixel(column, row), seen.pixel(30, 30)
                self.assertLess(max(abs(a - b) for a, b in zip(bar, shown)), 0.02, f"{name}: {blur} pixels\n{seen.told}")

    def test_background_is_blurred_as_at_infinity(self):
        empty = rendering.render(
            "camera { location 0 direction z right x up 0.75*y aperture 1 focal_point 10*z "
            "tilt_lens { focus_map } }\nsphere { -9*z, 1 }\n"
        )
        far, _ = wall(1e6, "focus_map")
        self.assertLess(max(abs(a - b) for a, b in zip(empty.pixel(5, 5), far.pixel(5, 5))), 1e-3, empty.told)

    def test_scale_is_there_and_not_in_small_pictures(self):
        large = picture("focus_map")
        row = [large.pixel(x, 93 - 2 - 3)[1] for x in range(4, 126)]
        self.assertGreater(max(row) - min(row), 0.5, f"no numbers under the scale\n{large.told}")
        small = picture("focus_map", width=63, height=50)
        plain = [small.pixel(x, 48) for x in range(63)]
        self.assertGreater(min(max(p) for p in plain), 0.1, f"a dark box in a small picture\n{small.told}")


class Planes(rendering.RenderTest):
    def test_hidden_behind_nearer_surfaces(self):
        lens = "tilt 0 "
        near = "sphere { <0.4, 1.5, -4> + 0.6*(<0, 0.5, 0.5> - <0.4, 1.5, -4>), 0.3 pigment { rgb 0.6 } }\n"
        seen, plain = (picture("show_planes", lens=lens, world=scenes.WORLD + near), pinhole(scenes.WORLD + near, lens))
        middle = (65, 46)
        self.assertEqual(seen.pixel(*middle), plain.pixel(*middle), seen.told)
        behind = (65, 2)
        self.assertNotEqual(seen.pixel(*behind), plain.pixel(*behind), seen.told)

    def test_each_surface_at_its_depth(self):
        tints = []
        for distance in (6.0, 9.0, 10.9, 12.0, 50.0):
            seen, blur = wall(distance, "show_planes")
            tints.append((blur, seen.pixel(30, 20)))
        black, first, second, third, fourth = (colour for _, colour in tints)
        self.assertEqual(max(black), 0.0)
        self.assertGreater(first[0], 2 * first[2], "near limit: orange")
        self.assertGreater(second[2], first[2] + 0.1, "then the plane of sharp focus: white")
        self.assertEqual(second, third)
        self.assertGreater(fourth[2] - fourth[0], third[2] - third[0] + 0.02, "then the far limit: blue")

    def test_wedge_meets_in_the_hinge(self):
        scene = (
            "camera { location 0 direction z right x up 0.75*y aperture 1 focal_point <0, 0, 10> "
            "tilt_lens { focus_tilt 80 show_planes } }\n"
            "sphere { -9*z, 1 }\nbackground { rgb 0 }\n"
        )
        seen = rendering.render(scene, "+UA", width=64, height=48)
        self.assertEqual(max(seen.pixel(30, 1)[:3]), 0.0, f"above\n{seen.told}")
        self.assertGreater(min(seen.pixel(30, 40)[:3]), 0.1, f"below\n{seen.told}")

    def test_covers_transparent_background(self):
        scene = scenes.camera("show_planes") + "sphere { -99*z, 1 }"
        seen = rendering.render(scene, "+UA", extension="exr", **SIZE)
        self.assertTrue(0.3 < seen.pixel(60, 40)[seen.names.index("A")] < 1.0, seen.told)


class Cost(rendering.RenderTest):
    def test_one_ray_a_pixel(self):
        rays = {}
        for name, scene in {
            "pinhole": f"camera {{ {scenes.VIEW} tilt_lens {{}} }}\n" + scenes.WORLD,
            **{aid: scenes.camera(aid) + scenes.WORLD for aid in AIDS},
        }.items():
            said = rendering.render_and_listen(scene, **SIZE)[1]
            found = re.search(r"^Rays: +(\d+)", said, re.MULTILINE)
            self.assertIsNotNone(found, said)
            rays[name] = int(found[1])
        for aid in AIDS:
            self.assertLessEqual(rays[aid], rays["pinhole"], f"{aid}: {rays}")


class Report(rendering.RenderTest):
    def test_reports_the_drawn_aid(self):
        for aid, words in (
            (PEAKING, "focus_peaking: tinted where blurred under 1.5 pixels"),
            ("focus_map", "focus_map: blue behind the sharp plane, orange before it"),
            ("show_planes", "show_planes: the sharp plane's grid has 0*\\.?0*[125]0* units"),
        ):
            with self.subTest(aid=aid):
                said = rendering.render_and_listen(scenes.camera(aid) + scenes.WORLD)[1]
                self.assertRegex(said, r"Drawn\.{16}" + words)
                self.assertIn("Samples per pixel....1, through the lens centre", said)
        self.assertNotIn("Drawn...", rendering.render_and_listen(scenes.TILTED)[1])


if __name__ == "__main__":
    rendering.main()

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Small bright lamps reach the requested variance."""

import math
import re

from tests.render import rendering, scenes

GLOW = "pigment { rgb <1, 0.8, 0.5> } finish { ambient 0 diffuse 0 emission 30 }"
UNKNOWN = scenes.unknown_glow(30, 24, 15)
SIZE = {"width": 40, "height": 30}


def lamps(glow):
    return f"""{scenes.UNKNOWN_LIGHTS}
#for (I, 0, 5)
  #for (J, -3, 3)
    #declare Place = <J*0.6 + I*0.13, 0.2 + 0.25*I, I*I*0.9 - 2>;
    #switch (mod(I + J + 6, 3))
      #case (0) sphere {{ Place, 0.012 {glow} }} #break
      #case (1) union {{ box {{ Place - 0.01, Place + 0.01 }} sphere {{ Place + 0.1*x, 0.008 }} {glow} }} #break
      #else light_source {{ Place, rgb 0 looks_like {{ sphere {{ 0, 1 scale <0.01, 0.02, 0.01> {glow} }} }} }}
    #end
  #end
#end
plane {{ y, 0 pigment {{ rgb 0.02 }} }}
box {{ <0.5, 0, 0.5>, <1, 1, 0.6> pigment {{ rgb 0.1 }} finish {{ ambient 0.5 }} }}
"""


def scene(samples, glow=GLOW, lens="focus_tilt 20 scene_unit 100"):
    return scenes.camera(lens, 0.6, samples) + lamps(glow)


def clipped_error(picture, truth):
    """Error as displayed; share of pixels off by more than 2 sqrt(1e-4)."""
    channels = len(picture.names)
    errors = [(min(1.0, a) - min(1.0, b)) ** 2 for a, b in zip(picture.values, truth.values)]
    pixels = [max(errors[i : i + channels]) for i in range(0, len(errors), channels)]
    return sum(errors) / len(errors), sum(e > 4e-4 for e in pixels) / len(pixels)


class Emitters(rendering.RenderTest):
    def test_variance_is_honoured(self):
        asked = "blur_samples 8, 4096 variance 1/10000 "
        for lens in ("scene_unit 100", "focus_tilt 20 scene_unit 100 blades 6"):
            with self.subTest(lens):
                truth = rendering.render(scene("blur_samples 1024, 1024 variance 0 ", lens=lens), **SIZE)
                error, beyond = clipped_error(rendering.render(scene(asked, lens=lens), **SIZE), truth)
                self.assertLess(error, 1.2e-4, f"{lens}: MSE {error:g}")
                self.assertLess(beyond, 0.05, f"{lens}: {beyond:.1%}")

    def test_known_lamps_take_fewer_rays(self):
        asked = "blur_samples 8, 32 variance 1/10000 "
        truth = rendering.render(scene("blur_samples 1024, 1024 variance 0 "), **SIZE)
        known, unknown = (clipped_error(rendering.render(scene(asked, glow), **SIZE), truth)[0] for glow in (GLOW, UNKNOWN))
        self.assertGreater(unknown, 2.0 * known)

    def test_light_is_neither_gained_nor_lost(self):
        samples = "blur_samples 1024, 1024 variance 0 "
        known, unknown = (rendering.render(scene(samples, glow), extension="exr", **SIZE) for glow in (GLOW, UNKNOWN))
        for channel in ("R", "G", "B"):
            sums = [sum(picture.channel(channel)) for picture in (known, unknown)]
            self.assertLess(abs(sums[0] - sums[1]), 0.02 * sums[1], channel)

    def test_threads_tiles_and_parts(self):
        whole = rendering.render(scene(scenes.SAMPLES), "+WT1", **SIZE)
        self.assert_same(rendering.render(scene(scenes.SAMPLES), "+WT3", "+BS13", **SIZE), whole, "threads")
        part = rendering.render(scene(scenes.SAMPLES), "+SR9", "+ER20", **SIZE)
        self.assert_same(part.crop(0, 8, 40, 20), whole.crop(0, 8, 40, 20), "rows")


DISC = {"width": 96, "height": 96, "extension": "exr"}
WALL = "plane { -z, -40 pigment { checker rgb 0.1 rgb 0.5 scale 0.4 } finish { ambient 0 diffuse 0 emission 1 } }\n"
BLURRED_LAMP = "sphere { 20*z, 0.06 pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 300 } no_shadow }\n"


def disc_camera(samples, lens=""):
    view = "right x location 0 look_at z angle 30 aperture 2 focal_point 6*z"
    return f"camera {{ {view} blur_samples {samples} tilt_lens {{ {lens} }} }}\n"


class DiscOutline(rendering.RenderTest):
    """Discs of blurred lamps."""

    def test_a_disc_before_a_blurred_pattern_has_no_outline(self):
        lit, wall = (
            rendering.render(disc_camera("16, 16 variance 1e-9") + WALL + lamp, **DISC).channel("G") for lamp in (BLURRED_LAMP, "")
        )
        lamp = [a - b for a, b in zip(lit, wall)]
        width = DISC["width"]
        middle = (width - 1) / 2
        distance = [math.hypot(i % width - middle, i // width - middle) for i in range(width * width)]
        radius = max(d for d, light in zip(distance, lamp) if light > 0.5 * max(lamp))
        self.assertGreater(radius, 10)
        ring = [i for i, d in enumerate(distance) if radius + 1.5 < d < radius + 6]
        outside = sum(lamp[i] for i in ring) / sum(wall[i] for i in ring)
        self.assertLess(abs(outside), 0.03, f"radius {radius:.1f}: {outside:+.1%} of the wall's light beside the disc")

    def test_the_rim_of_a_small_disc_is_smooth(self):
        """Pixels at the rim see the lamp from a part of their square."""
        small = {"width": 32, "height": 32, "extension": "exr"}
        lamps = "".join(f"sphere {{ <{x}, {y}, 20>, 0.03 {GLOW} no_shadow }}\n" for x in (-2.3, 0.1, 2.2) for y in (-2.1, 0.2, 2.4))
        cameras = (disc_camera("1024, 1024 variance 0", "denoise off"), disc_camera("8, 8 variance 1e-9"))
        exact, few = (rendering.render(camera + lamps, **small).channel("G") for camera in cameras)
        error = sum((a - b) ** 2 for a, b in zip(few, exact)) / sum(a**2 for a in exact)
        self.assertLess(error, 0.01, f"squared error {error:.4f} of the squared light")


MIRRORS = {
    "box": "box { <-9, -9, 4>, <9, 9, 4.1> pigment { rgb 0.1 } finish { reflection 0.8 } }",
    "turned box": "box { <-9, -9, 0>, <9, 9, 0.1> pigment { rgb 0 } finish { reflection 0.8 } rotate <2, 6, 7> translate 5*z }",
    "plane": "plane { -z, -4 pigment { rgb 0.1 } finish { reflection 0.8 } rotate 5*x }",
    "layer of a map": "plane { -z, -4 texture { gradient x texture_map { [0 pigment { rgb 0 } finish { reflection 0.8 }]"
    " [1 pigment { rgb 0 } finish { reflection 0.7 }] } } }",
    "room": "box { <-9, -9, -9>, <9, 9, 6> pigment { rgb 0 } finish { ambient 0 diffuse 0 reflection 0.3 } hollow }",
    "periscope": "".join(
        f"box {{ -3, <3, 3, -2.98> pigment {{ rgb 0 }} finish {{ reflection 0.8 }} translate 2.99*z rotate 45*y translate <{x}, 1, 3> }} "
        for x in (0, -8)
    ),
}
PLACES = {"periscope": "<-8, 0, 9>"}  # of lamps


def mirrored(mirror, glow=GLOW, flags=""):
    place = PLACES.get(mirror, "-7*z")
    lamps = "".join(f"sphere {{ {place} + <{x}, {y}, 0>, 0.02 {glow} {flags} }}\n" for x in (-1, 0.3, 1.5) for y in (0.4, 1.7))
    return lambda samples: scenes.camera("scene_unit 100 denoise off", 0.4, samples) + MIRRORS[mirror] + lamps + scenes.UNKNOWN_LIGHTS


class Mirrors(rendering.RenderTest):
    def emitters(self, scene):
        said = rendering.render_and_listen(scene("blur_samples 8, 16 variance 1/2000 "), **SIZE)[1]
        found = re.search(r"emitters in view: (\d+)", said)
        return int(found.group(1)) if found else None

    def test_lamps_in_flat_mirrors_are_known(self):
        """Unknown lamps have more error from as many rays."""
        samples, small = "blur_samples 64, 64 variance 1/1000 ", {"width": 24, "height": 18, "extension": "exr"}
        for mirror in MIRRORS:
            with self.subTest(mirror):
                exact = rendering.render(mirrored(mirror)("blur_samples 512, 512 variance 0 "), **small)
                known, unknown = (rendering.render(mirrored(mirror, glow)(samples), **small) for glow in (GLOW, UNKNOWN))
                errors = [sum((a - b) ** 2 for a, b in zip(picture.values, exact.values)) for picture in (known, unknown)]
                self.assertGreater(errors[1], 4.0 * errors[0])

    def test_only_what_is_reflected_is_sought_in_mirrors(self):
        self.assertEqual(self.emitters(mirrored("box")), 6)
        self.assertEqual(self.emitters(mirrored("box", flags="no_image")), 6)
        self.assertIsNone(self.emitters(mirrored("box", flags="no_reflection")))
        bumpy = mirrored("box")
        self.assertIsNone(
            self.emitters(lambda samples: bumpy(samples).replace("finish { reflection", "normal { bumps } finish { reflection"))
        )


class Highlights(rendering.RenderTest):
    def test_highlights_of_spheres_are_known(self):
        """Ellipsoids of a sphere's shape have unknown highlights."""
        for finish in ("specular 3 roughness 0.0005", "phong 2 phong_size 400"):
            with self.subTest(finish):

                def balls(samples, scaled):
                    places = [(-2, 0.4, 6), (0.3, 0.9, 7), (2, 0.2, 5)]
                    size = "1 scale <0.2, 0.2, 0.2000001>" if scaled else "0.2"
                    spheres = "".join(
                        f"sphere {{ 0, {size} pigment {{ rgb 0.1 }} finish {{ {finish} }} translate <{x}, {y}, {z}> }}\n"
                        for x, y, z in places
                    )
                    light = "light_source { <9, 20, -9>, rgb 1 }\n"
                    return scenes.camera("scene_unit 100 denoise off", 0.4, samples) + light + spheres

                exact = rendering.render(balls("blur_samples 1024, 1024 variance 0 ", False), extension="exr", **SIZE)
                known, unknown = (
                    rendering.render(balls("blur_samples 16, 16 variance 1/10000 ", scaled), extension="exr", **SIZE)
                    for scaled in (False, True)
                )
                errors = [sum((a - b) ** 2 for a, b in zip(picture.values, exact.values)) for picture in (known, unknown)]
                self.assertGreater(errors[1], 1.5 * errors[0])


SKY = (
    "sky_sphere { pigment { function { select(pow(x*12 - floor(x*12) - 0.5, 2) + pow(y*12 - floor(y*12) - 0.5, 2) - 0.003, 1, 0) }"
    " color_map { [0.5 rgb 0] [0.5 rgb 30] } } emission 1 }\n"
)
WINDOWS = (
    "plane { -z, -8 pigment { image_map { function 96, 64 { select(pow(mod(12*x, 1) - 0.5, 2) + pow(mod(8*y, 1) - 0.5, 2) - 0.03, 1, 0) }"
    " once } scale <12, 8, 1> translate <-6, -4, 0> } finish { ambient 0 emission 20 diffuse 0 } }\n"
)
PANE = "box { <-20, -12, -1>, <20, 12, 1> pigment { rgbt 1 } finish { diffuse 0 } interior { ior 1.5 } rotate 40*y translate 4*z }\n"


class Searched(rendering.RenderTest):
    """Lamps that no list of objects tells are found in a sharp picture."""

    def scene(self, world, samples="blur_samples 16, 256 variance 1/2000 ", lens="scene_unit 100"):
        return scenes.camera(lens, 2, samples) + scenes.UNKNOWN_LIGHTS + world

    def found(self, world, *scene):
        said = rendering.render_and_listen(self.scene(world, *scene), **SIZE)[1]
        searched = re.search(r"^  Lamps searched\.+(\d+) rays?, (\d+) found$", said, re.M)
        return [int(number) for number in searched.groups()] if searched else None

    def test_all_are_found(self):
        self.assertEqual(self.found(scenes.painted())[1], 6)
        self.assertEqual(self.found("global_settings { radiosity { count 2 } }\n" + scenes.painted())[1], 6)
        self.assertGreaterEqual(self.found(PANE + scenes.six(GLOW, 9, 0.2))[1], 3)  # others appear where they are
        self.assertGreater(self.found(SKY)[1], 60)  # of 94
        self.assertGreater(self.found(WINDOWS)[1], 20)  # of 39

    def test_found_lamps_have_less_error(self):
        exact = rendering.render(self.scene(scenes.six(GLOW), "blur_samples 1024, 1024 variance 0 "), extension="exr", **SIZE)
        found, unknown = (
            rendering.render(self.scene(lamps, "blur_samples 32, 32 variance 0 "), extension="exr", **SIZE)
            for lamps in (scenes.painted(), scenes.six(UNKNOWN))
        )
        errors = [sum((a - b) ** 2 for a, b in zip(picture.values, exact.values)) for picture in (found, unknown)]
        self.assertGreater(errors[1], 5.0 * errors[0])

    def test_threads_tiles_and_parts(self):
        self.assert_same_in_parts(self.scene(PANE + scenes.six(GLOW) + SKY), first=9, last=20, **SIZE)

    def test_nothing_is_searched_in_vain(self):
        for world in (
            scenes.painted(3.9),
            scenes.six(GLOW) + SKY.replace("rgb 30", "rgb 3"),
            WINDOWS.replace("emission 20", "emission 3"),
            PANE + scenes.six(GLOW.replace("emission 30", "emission 3")),
            PANE.replace("ior 1.5", "ior 1") + scenes.six(GLOW),
        ):
            self.assertIsNone(self.found(world), world)
        for samples, lens in (
            ("blur_samples 2, 16 ", "scene_unit 100"),
            ("blur_samples 64 ", "focus_map"),
            ("blur_samples 64 normal { bumps 1e-5 } ", "scene_unit 100"),
        ):
            self.assertIsNone(self.found(scenes.painted(), samples, lens), samples + lens)

    def test_a_few_rays_tell_that_there_is_none(self):
        even = "plane { -z, -8 pigment { gradient x color_map { [0 rgb 10] [1 rgb 10] } } finish { ambient 0 emission 1 diffuse 0 } }\n"
        rays, lamps = self.found(even)
        self.assertEqual(lamps, 0)
        self.assertLess(rays, 2 * SIZE["width"] * SIZE["height"])
        self.assertGreater(self.found(scenes.painted())[0], 9 * SIZE["width"] * SIZE["height"])
        few = self.found(scenes.painted(), "blur_samples 4, 16 variance 1/2000 ")[0]
        self.assertLess(few, 1.1 * 4 * SIZE["width"] * SIZE["height"], "a quarter of 16, and parts of cells")


if __name__ == "__main__":
    rendering.main()

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Pixels do not depend on per-thread caches."""

import random

from tests.render import rendering, scenes

SIZE = {"width": 40, "height": 30}
CAMERA = scenes.camera("tilt 3 swing -2", samples="blur_samples 4, 16 variance 1/2000 ")
OTHER_WAYS = (("+WT2",), ("+WT4", "+BS8"), ("+WT1", "+BS5", "+RP3"))


def vector(chance, low, high):
    return "<" + ", ".join(f"{chance.uniform(low, high):.2f}" for _ in range(3)) + ">"


def texture(chance):
    normal = chance.choice(["", "normal { facets size 0.2 }", "normal { bumps 0.4 scale 0.1 }", "normal { crackle 0.5 scale 0.2 }"])
    pigment = chance.choice(
        [
            f"rgb {vector(chance, 0.2, 1)}",
            f"rgbf <{chance.uniform(0.5, 1):.2f}, 0.9, 0.8, 0.8>",
            f"rgbt <0.9, {chance.uniform(0.5, 1):.2f}, 0.8, 0.6>",
            "checker rgb 0.9 rgbt <1, 0.4, 0.3, 0.5> scale 0.21",
            "crackle color_map { [0 rgb 0.1][0.3 rgbf <0.9, 0.9, 0.5, 0.4>] } scale 0.3",
        ]
    )
    finish = chance.choice(["", "finish { reflection 0.3 phong 0.4 }", "finish { crand 0.1 }"])
    return f"pigment {{ {pigment} }} {normal} {finish}", "rgbf" in pigment


def thing(chance):
    at = [chance.randrange(-4, 5) * 0.4, chance.randrange(0, 4) * 0.4, chance.randrange(-2, 6) * 0.4]
    place = "<{:.1f}, {:.1f}, {:.1f}>".format(*at)
    surface, clear = texture(chance)
    interior = "interior { ior 1.4 }" if clear and chance.random() < 0.6 else ""
    solid = chance.choice(
        [
            "sphere { 0, 0.4",
            "box { -0.4, 0.4",
            "box { <-0.6, -0.2, -0.2>, <0.6, 0.2, 0.2>",
            "cylinder { -0.4*y, 0.4*y, 0.4",
            "torus { 0.4, 0.2",
            "cone { -0.4*y, 0.4, 0.4*y, 0",
            "union { box { -0.4, <0.4, 0, 0.4> } sphere { <0, 0.2, 0>, 0.2 }",
            "difference { box { -0.4, 0.4 } sphere { 0, 0.5 }",
            "isosurface { function { x*x + y*y + z*z - 0.16 + 0.02*sin(20*x) } contained_by { box { -0.5, 0.5 } } max_gradient 1.2",
            "isosurface { function { sqrt(x*x + y*y + z*z) - 0.3 - 0.05*sin(25*y) } contained_by { sphere { 0, 0.5 } } "
            "evaluate 0.6, 1.1, 0.9",
        ]
    )
    return f"{solid} {surface} {interior} translate {place} }}\n"


def light(chance):
    kind = chance.choice(
        [
            "",
            "area_light 2*x, 2*y, 4, 4 adaptive 1",
            "area_light 2*x, 2*z, 3, 5 jitter",
            "shadowless",
            "spotlight point_at 0 radius 20 falloff 35",
        ]
    )
    return f"light_source {{ <{chance.randrange(-6, 7)}, {chance.randrange(4, 9)}, {chance.randrange(-8, 0)}>, rgb 0.5 {kind} }}\n"


def scene(seed, more=""):
    chance = random.Random(seed)
    things = "".join(thing(chance) for _ in range(26))
    group = "".join(thing(chance) for _ in range(3))
    lights = "".join(light(chance) for _ in range(3))
    ground = "plane { y, -0.4 pigment { checker rgb 0.8 rgb 0.4 } finish { reflection 0.1 } }\n"
    return f"{CAMERA}{more}{ground}{things}{lights}light_group {{ {light(chance)}{group} global_lights on }}\n" "background { rgb 0.3 }\n"


class History(rendering.RenderTest):
    def check(self, text, what, ways=OTHER_WAYS):
        whole = rendering.render(text, "+WT1", **SIZE)
        for options in ways:
            self.assert_same(rendering.render(text, *options, **SIZE), whole, f"{what}, {' '.join(options)}")
        return whole

    def check_band(self, text, whole, first, last):
        band = rendering.render(text, "+WT2", f"+SR{first}", f"+ER{last}", **SIZE)
        place = (0, first - 1, SIZE["width"], last)
        self.assert_same(band.crop(*place), whole.crop(*place), f"rows {first} to {last}")

    def test_random_scenes(self):
        for seed in range(8):
            with self.subTest(seed=seed):
                whole = self.check(scene(seed), f"scene {seed}")
                self.check_band(scene(seed), whole, 11, 20)

    def test_photons(self):
        targets = "".join(
            f"sphere {{ <{x}, 0.3, {x}>, 0.35 pigment {{ rgbf <1, 0.9, 0.8, 0.9> }} interior {{ ior 1.5 }} "
            "photons { target refraction on reflection on collect off } }\n"
            for x in (-0.9, 0, 0.9)
        )
        lights = "".join(f"light_source {{ <{x}, 6, -2>, rgb 0.7 photons {{ refraction on reflection on }} }}\n" for x in (-3, 3))
        ground = "plane { y, 0 pigment { rgb 0.8 } }\nbackground { rgb 0.3 }\n"
        photons = "global_settings { photons { count 4000 jitter 0.6 } }\n"
        text = CAMERA + photons + targets + lights + ground
        whole = self.check(text, "photons", (("+WT2",), ("+WT3",), ("+WT4",)))
        self.check_band(text, whole, 16, 25)


if __name__ == "__main__":
    rendering.main()

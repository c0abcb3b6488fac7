# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Random numbers give the same pixels for any threads, except with radiosity."""

from tests.render import rendering, scenes

FEW = "blur_samples 8, 16 variance 1/1000 "
TILTED = scenes.camera(samples=FEW)
AREA_LIGHT = "light_source { <4, 8, -6>, rgb 1 area_light x*3, z*3, 3, 3 adaptive 1 jitter }\n"
FLOOR = "plane { y, 0 pigment { checker rgb 1 rgb 0.2 } }\nbackground { rgb 0.3 }\n"
BALL = "sphere { <0.3, 0.8, 0>, 0.7 pigment { rgb <0.8, 0.3, 0.2> } }\n"
LIGHT = "light_source { <4, 8, -6>, rgb 1 }\n"

RANDOM = {
    "area light": AREA_LIGHT + FLOOR + BALL,
    "crand": LIGHT + FLOOR + "sphere { <0.3, 0.8, 0>, 0.7 pigment { rgb 0.5 } finish { crand 0.4 } }\n",
    "media": LIGHT + FLOOR + BALL + "media { scattering { 1, 0.1 } samples 4, 8 jitter 1 method 3 }\n",
    "media of method 1": LIGHT + FLOOR + BALL + "media { scattering { 1, 0.1 } intervals 2 samples 2, 4 jitter 1 method 1 }\n",
    "media in an object": LIGHT + FLOOR + "sphere { <0, 1, 0>, 1 hollow pigment { rgbt 1 } interior { media {"
    " emission 0.5 scattering { 1, 0.5 } density { bozo } jitter 1 } } }\n",
    "photons": "global_settings { photons { count 2000 jitter 1 } }\n"
    + LIGHT
    + FLOOR
    + "sphere { <0.3, 0.8, 0>, 0.7 pigment { rgbf 0.9 } interior { ior 1.4 }"
    " photons { target reflection on refraction on } }\n",
    "subsurface": "global_settings { mm_per_unit 10 subsurface { samples 8, 8 } }\n"
    + LIGHT
    + FLOOR
    + "sphere { <0.3, 0.8, 0>, 0.7 pigment { rgb 0.8 } finish { ambient 0 subsurface {"
    " translucency <0.9, 0.6, 0.3> } } interior { ior 1.3 } }\n",
    "averaged normals": LIGHT + FLOOR + "sphere { <0.3, 0.8, 0>, 0.7 pigment { rgb 0.1 } finish { reflection 0.8 }"
    " normal { average normal_map { [1 bumps 0.3 scale 0.01][1 bumps 0.3 scale 0.01 translate 5] } } }\n",
    "dispersion": LIGHT + FLOOR + "sphere { <0.3, 0.8, 0>, 0.7 pigment { rgbf 1 } interior { ior 1.5 dispersion 1.1"
    " dispersion_samples 5 } }\n",
    "camera normal": LIGHT + FLOOR + BALL,
}


class Threads(rendering.RenderTest):
    def test_threads_and_tiles(self):
        for name, world in RANDOM.items():
            camera = TILTED if name != "camera normal" else scenes.camera(samples=FEW, tail="normal { bumps 0.1 scale 0.1 }")
            with self.subTest(name):
                one = rendering.render(camera + world, "+WT1", "+BS8", width=40, height=30)
                for options in (["+WT4", "+BS13"], ["+WT2", "+BS64", "+SP16", "+EP4"]):
                    many = rendering.render(camera + world, *options, width=40, height=30)
                    self.assert_same(many, one, name + " " + " ".join(options))

    def test_focus_aids(self):
        camera = scenes.camera("tilt 6 focus_peaking rgb x", samples=FEW)
        for name in ("area light", "crand", "media", "subsurface"):
            with self.subTest(name):
                one, many = (
                    rendering.render(camera + RANDOM[name], *options, width=40, height=30)
                    for options in (["+WT1", "+BS8"], ["+WT4", "+BS13"])
                )
                self.assert_same(many, one, name)

    def test_sub_image(self):
        for name in ("area light", "crand", "media"):
            with self.subTest(name):
                whole = rendering.render(TILTED + RANDOM[name], "+WT2", width=40, height=30)
                part = rendering.render(TILTED + RANDOM[name], "+WT1", "+SR11", "+ER22", width=40, height=30)
                self.assert_same(part.crop(0, 10, 40, 22), whole.crop(0, 10, 40, 22), name)


if __name__ == "__main__":
    rendering.main()

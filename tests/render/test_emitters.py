# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Small lamps far brighter than white reach the requested variance, sharp or blurred."""

from tests.render import rendering, scenes

GLOW = "pigment { rgb <1, 0.8, 0.5> } finish { ambient 0 diffuse 0 emission 30 }"
# texture maps hide lamps from the list of emitters
UNKNOWN = f"texture {{ gradient x texture_map {{ [0 {GLOW}] [1 {GLOW}] }} }}"
SIZE = {"width": 40, "height": 30}


def lamps(glow):
    return f"""
#for (I, 0, 5)
  #for (J, -3, 3)
    #declare Place = <J*0.6 + I*0.13, 0.2 + 0.25*I, I*I*0.9 - 2>;
    #switch (mod(I + J + 6, 3))
      #case (0) sphere {{ Place, 0.012 {glow} }} #break
      #case (1) union {{ box {{ Place - 0.01, Place + 0.01 }} sphere {{ Place + 0.1*x, 0.008 }} {glow} }} #break
      #else light_source {{ Place, rgb 0.001 looks_like {{ sphere {{ 0, 1 scale <0.01, 0.02, 0.01> {glow} }} }} }}
    #end
  #end
#end
plane {{ y, 0 pigment {{ rgb 0.02 }} }}
box {{ <0.5, 0, 0.5>, <1, 1, 0.6> pigment {{ rgb 0.1 }} finish {{ ambient 0.5 }} }}
"""


def scene(samples, glow=GLOW, lens="focus_tilt 20 scene_unit 100"):
    return scenes.camera(lens, 0.6, samples) + lamps(glow)


def clipped_error(picture, truth):
    """Error as displayed, and the share of pixels off by more than 2 sqrt(1e-4)."""
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


if __name__ == "__main__":
    rendering.main()

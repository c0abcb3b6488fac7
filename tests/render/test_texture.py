# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Remaining noise prefers neither rows, columns nor blocks."""

import numpy

from tests.render import rendering
from tests.tools import error_direction

MOST = 1.2  # power of noise in one direction over that in another

LIGHTS = "light_source { <-20, 30, -20> rgb 1.1 area_light 4*x, 4*z, 5, 5 adaptive 1 jitter }\nlight_source { <6, 4, -6> rgb 0.3 }\n"

WALL = (
    LIGHTS
    + """
box { <-8, 0, 5>, <8, 6, 5.2> pigment { gradient x triangle_wave color_map { [0 rgb <0.32, 0.3, 0.42>] [1 rgb <0.42, 0.4, 0.5>] } scale 0.06 }
  normal { gradient y 0.3 scale 0.07 } }
"""
)

CHROME = (
    WALL
    + """
plane { y, 0 pigment { checker rgb 0.75, rgb 0.25 scale 0.12 } finish { reflection 0.15 diffuse 0.7 } }
sphere { <1.7, 0.6, 0.6>, 0.6 pigment { rgb 0.1 } finish { reflection 0.85 specular 1 roughness 0.0005 } }
"""
)

HIGHLIGHTS = """light_source { <-20, 30, -20> rgb 1 }
plane { y, 0 pigment { rgb 0.3 } }
#declare S = seed(2);
#for (I, 0, 60)
  sphere { <8*rand(S)-4, 0.15, 6*rand(S)>, 0.15
    pigment { rgb <0.02, 0.02, 0.03> } finish { specular 40 roughness 0.0002 reflection 0.05 } }
#end
"""


def camera(place, samples, items, seed):
    return (
        f"camera {{ right x*image_width/image_height {place} {samples} tilt_lens {{ {items} sample_seed {seed} }} }}\n"
        "background { rgb <0.05, 0.06, 0.1> }\n"
    )


PICTURE_QUALITY = "blur_samples 256 variance 1/8000"
SIZE = (192, 128)
CASES = {  # camera, samples, lens, world, size if not SIZE
    "blurred wall": (
        "location <0, 2.2, -7> look_at <-1.5, 2, 5> angle 6.3 focal_point <0, 0.5, 0>",
        PICTURE_QUALITY,
        "scene_unit 40 f_stop 8.4 tilt 0.3",
        WALL,
    ),
    "chrome": (
        "location <0, 2.2, -7> look_at <1.7, 1.15, 0.6> angle 6.3 focal_point <0, 0.5, 0>",
        PICTURE_QUALITY,
        "scene_unit 40 f_stop 8.4 tilt 0.3",
        CHROME,
    ),
    "highlights": (
        "location <0, 1.5, -5> look_at <0, 0.6, 0> angle 40 focal_point <0, 0.6, -1.5>",
        "",
        "scene_unit 60 f_stop 1.4",
        HIGHLIGHTS,
        (480, 270),
    ),
}


class Measure(rendering.RenderTest):
    def figures(self, filtered):
        random = numpy.random.default_rng(1)
        power = error_direction.spectrum(filtered(random.normal(size=(192, 192)))[..., None])
        return error_direction.axes_over_diagonals(power), error_direction.blocks_over_surroundings(power)

    def test_white_noise(self):
        for ratio in self.figures(lambda noise: noise):
            self.assertLess(abs(ratio - 1), 0.1)

    def test_streaks_and_crosses(self):
        axes, _ = self.figures(lambda noise: noise + sum(numpy.roll(noise, i, 1) for i in range(1, 9)))
        self.assertGreater(axes, 2)
        slanted, _ = self.figures(lambda noise: noise + sum(numpy.roll(noise, (i, i), (0, 1)) for i in range(1, 9)))
        self.assertLess(slanted, 0.5)

    def test_blocks(self):
        def with_borders(noise):
            noise[:, ::16] += 2
            return noise

        self.assertGreater(self.figures(with_borders)[1], 2)


class Texture(rendering.RenderTest):
    def test_noise_prefers_no_direction(self):
        for name, (place, samples, items, world, *size) in CASES.items():
            width, height = size[0] if size else SIZE
            with self.subTest(name):
                first, second = (
                    rendering.render(camera(place, samples, items, seed) + world, width=width, height=height) for seed in (1, 2)
                )
                self.assertGreater(rendering.difference(first, second)[0], 1e-4, f"{name}: no noise to measure\n{first.told}")
                axes, blocks = error_direction.figures(first, second)
                self.assertLess(
                    max(axes, 1 / axes), MOST, f"{name}: power of noise along rows and columns over diagonals {axes:.2f}\n{first.told}"
                )
                self.assertLess(blocks, MOST, f"{name}: power of noise at periods of a block over others {blocks:.2f}\n{first.told}")


if __name__ == "__main__":
    rendering.main()

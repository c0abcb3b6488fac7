# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Half of the lens sees water or glass."""

from tests.render import rendering

SIZE = {"width": 320, "height": 240, "extension": "exr"}
CAMERA = "camera {{ right 4/3*x location <0, 2, -9> look_at 0 angle 40 aperture 0.6 focal_point 0 tilt_lens {{ sample_seed {} }} }}\n"
SCENE = """
light_source { <20, 30, -30>, rgb 1 }
background { rgb <0.5, 0.6, 0.9> }
sphere { <-1.5, 0, 0>, 1 pigment { rgb <0.2, 0.4, 0.6> } finish { phong 1 reflection 0.2 } }
"""
FLOOR = "plane { y, -1 pigment { checker rgb 0.3 rgb 0.8 } }\n"
CLEAR = "pigment { rgbt <0.8, 0.9, 1, 0.9> } hollow "
DEEP = "interior { ior 1.33 fade_distance 5 fade_power 1001 fade_color <0.2, 0.5, 0.6> }"
SURFACES = {
    "water": FLOOR + f"plane {{ y, 2 {CLEAR} {DEEP} }}\n",
    "water that only darkens": FLOOR + f"plane {{ y, 2 pigment {{ rgbt <0.4, 0.5, 0.6, 0.6> }} hollow {DEEP} }}\n",
    "a ball of glass": f"sphere {{ <0, -4, -9>, 6 {CLEAR} {DEEP} }}\n",
}


def stand_out(picture, width, height):
    green = picture.channel("G")
    found = []
    for y in range(2, height - 2):
        for x in range(2, width - 2):
            around = [green[v * width + u] for v in (y - 1, y, y + 1) for u in (x - 1, x, x + 1) if (u, v) != (x, y)]
            if not 0.7 * min(around) <= green[y * width + x] <= 1.4 * max(around):
                found.append((x, y))
    return found


class CutLens(rendering.RenderTest):
    def test_no_pixel_stands_out(self):
        for name, surface in SURFACES.items():
            with self.subTest(name):
                picture = rendering.render(CAMERA.format(0) + SCENE + surface, **SIZE)
                self.assertEqual(stand_out(picture, SIZE["width"], SIZE["height"]), [], picture.told)


if __name__ == "__main__":
    rendering.main()

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Shadows in small and large units equal the plain camera's."""

from tests.render import rendering

# powers of two; at the first, stock misses near shadows until it finds a far one
SCALES = ("1/256", "1/64", "1", "1024")
EXTREME = ("1e-4", "3e-4", "1e6")
POST = {
    "cylinder": "cylinder { <1, -1, -3>*S, <1, 0.8, -3>*S, 0.2*S pigment { rgb <0.1, 0.7, 0.2> } }",
    "mesh": "mesh { triangle { <0.8, -1, -3>*S, <1.2, -1, -3>*S, <1, 0.8, -3>*S } pigment { rgb <0.1, 0.7, 0.2> } }",
    "csg": "difference { box { <0.8, -1, -3.2>*S, <1.2, 0.8, -2.8>*S } sphere { <1, 0, -3>*S, 0.25*S } pigment { rgb <0.1, 0.7, 0.2> } }",
    "glass": "cylinder { <1, -1, -3>*S, <1, 0.8, -3>*S, 0.2*S pigment { rgbt <0.1, 0.7, 0.2, 0.5> } }",
}


def scene(post, scale, block):
    return (
        f"#declare S = {scale};\n"
        f"camera {{ right x*image_width/image_height location <0, 2, -9>*S look_at <1, -0.5, -3>*S angle 20 {block} }}\n"
        "light_source { <20, 30, -30>*S, rgb 0.8 }\n"
        "light_source { <-20, 20, -10>*S, rgb 0.3 area_light 2*S*x, 2*S*z, 3, 3 }\n"
        f"plane {{ y, -1*S pigment {{ rgb 0.8 }} }}\n{POST[post]}\n"
    )


class Shadows(rendering.RenderTest):
    def check(self, post, scales, extreme=EXTREME):
        size = {"width": 80, "height": 60}
        stock = {scale: rendering.render(scene(post, scale, ""), "+WT1", **size) for scale in ("1", *extreme)}
        for scale in (*scales, *extreme):
            with self.subTest(post=post, scale=scale):
                ours = rendering.render(scene(post, scale, "tilt_lens { }"), "+WT1", **size)
                self.assert_same(ours, stock.get(scale, stock["1"]), f"{post}, scale {scale}")

    def test_cylinder(self):
        self.check("cylinder", ("1/1024", *SCALES))

    def test_mesh(self):
        self.check("mesh", SCALES)

    def test_csg(self):
        self.check("csg", SCALES)

    def test_transparent(self):
        self.check("glass", (), (*SCALES, *EXTREME))


if __name__ == "__main__":
    rendering.main()

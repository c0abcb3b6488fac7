# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
from tests.render import rendering, scenes

LENSES = {
    "lens turned": "tilt 4 swing 2 shift <2, -1>",
    "focus turned": "focus_tilt 50 focus_swing 20 blades 5",
    "plane": "focal_plane { <0.2, 1, 0.3>, 0.3 }",
    "points": "focal_points <0, 0, 0>, <1, 0.2, 0>, <0, 0.5, 3>",
    "physical": "focal_length 40 f_stop 0.2 tilt 4 scene_unit 900",
    "film distance": "focal_length 40 f_stop 0.2 tilt 4 scene_unit 900 film_distance 40.4",
    "focus scale": "focal_length 40 f_stop 0.2 tilt 4 scene_unit 900 focus_scale 4.6",
}
NO_ANGLE = "location <0.4, 1.5, -4> look_at <0, 0.5, 0.5> "
SAMPLES = "blur_samples 32 variance 0 "
SIZE = {"width": 48, "height": 36}
TURN = "rotate <10, 30, -5> translate <1, -2, 3> "


def camera_of(name, tail="", samples=SAMPLES):
    physical = "focal_length" in LENSES[name]
    view = NO_ANGLE if physical else scenes.VIEW
    aperture = "" if physical else "aperture 0.3 "
    return f"camera {{ {view}{aperture}{samples}tilt_lens {{ {LENSES[name]} }} {tail} }}\n"


def declared(camera, tail=""):
    return f"#declare Cam = {camera}camera {{ Cam {tail} }}\n"


def moved_world(tail):
    """Objects glow: POV-Ray's shadows and reflections have absolute tolerances."""
    return (
        "#default { finish { ambient 1 diffuse 0 } }\nunion {\n"
        "  plane { y, 0 pigment { checker rgb <0.9, 0.8, 0.7> rgb <0.1, 0.3, 0.5> } }\n"
        "  sphere { <0.3, 0.6, 0>, 0.6 pigment { rgb <0.8, 0.2, 0.1> } }\n"
        "  box { <-2, 0, 1>, <-1, 1.6, 2> pigment { gradient y color_map { [0.5 rgb 0.9][0.5 rgb 0.1] } scale 0.4 } }\n"
        f"  {tail}\n}}\nbackground {{ rgb <0.3, 0.5, 0.8> }}\n"
    )


class Declared(rendering.RenderTest):
    def test_identifier(self):
        for name in LENSES:
            with self.subTest(name):
                plain = rendering.render(camera_of(name) + scenes.WORLD, **SIZE)
                self.assert_same(rendering.render(declared(camera_of(name)) + scenes.WORLD, **SIZE), plain, name)

    def test_block_behind_the_identifier(self):
        view = camera_of("plane").split("tilt_lens")[0]
        for name in ("lens turned", "focus turned", "points"):
            for before in ("", "tilt_lens { tilt -7 blades 3 }"):
                with self.subTest(name, before=before):
                    text = (
                        f"#declare Cam = {view}{before} }}\n#declare Other = camera {{ Cam tilt_lens {{ tilt 1 }} }}\n"
                        f"camera {{ Cam tilt_lens {{ {LENSES[name]} }} }}\n"
                    )
                    self.assert_same(
                        rendering.render(text + scenes.WORLD, **SIZE), rendering.render(camera_of(name) + scenes.WORLD, **SIZE)
                    )

    def test_transformations_behind_the_identifier(self):
        tails = {
            "all of them": "translate x rotate 20*y scale 1.5 matrix <1,0,0, 0,0.8,-0.6, 0,0.6,0.8, 0.1,0.2,0.3>",
            "transform": "transform { rotate 10*z translate <1, 2, 3> scale 0.5 }",
        }
        for name in LENSES:
            for kind, tail in tails.items():
                with self.subTest(name, kind=kind):
                    world = moved_world(tail)
                    inside = rendering.render(camera_of(name, tail) + world, "+WT2", **SIZE)
                    behind = rendering.render(declared(camera_of(name), tail) + world, "+WT2", **SIZE)
                    self.assert_same(behind, inside, f"{name}, {kind}")

    def test_identifier_is_not_changed(self):
        both = f"#declare Cam = {camera_of('points')}#declare Other = camera {{ Cam translate 5*x scale 3 }}\n" f"camera {{ Cam }}\n"
        self.assert_same(rendering.render(both + scenes.WORLD), rendering.render(camera_of("points") + scenes.WORLD))


class Together(rendering.RenderTest):
    stills = {}

    def still(self, name):
        if name not in self.stills:
            self.stills[name] = rendering.render(camera_of(name) + moved_world(""), "+WT2", **SIZE)
        return self.stills[name]

    def check(self, tail, rms=2e-3, names=tuple(LENSES)):
        for name in names:
            with self.subTest(name, tail=tail):
                still = self.still(name)
                moved = rendering.render(camera_of(name, tail) + moved_world(tail), "+WT2", **SIZE)
                self.assert_near(moved, still, rms, f"{name}, {tail}")

    def test_turned(self):
        self.check(TURN)

    def test_scaled_up(self):
        self.check("scale 1000")

    def test_scaled_down(self):
        self.check("scale 1e-3")

    def test_far_away(self):
        self.check("translate <30000, 0, -20000>", names=("lens turned", "points"))

    def test_mirrored(self):
        self.check("scale <-1, 1, 1>", names=("lens turned", "focus turned", "plane", "points"))

    def test_camera_written_out(self):
        tail = "translate <1, 2, 3>"
        out = (
            "camera { location <1.4, 3.5, -1> look_at <1, 2.5, 3.5> angle 45 aperture 0.3 "
            + SAMPLES
            + "tilt_lens { focal_points <1, 2, 3>, <2, 2.2, 3>, <1, 2.5, 6> } }\n"
        )
        self.assert_near(rendering.render(camera_of("points", tail) + moved_world(tail)), rendering.render(out + moved_world(tail)), 2e-3)


class Alpha(rendering.RenderTest):
    def test_coverage(self):
        scene = (
            scenes.camera("tilt 3", samples="blur_samples 256 variance 0 ", view="location -4*z focal_point 0 angle 45 ")
            + """
            sphere { <0, 0, 2>, 1.2 pigment { rgb <1, 0.5, 0.25> } finish { ambient 1 diffuse 0 } } background { rgbt <9, 9, 9, 1> }"""
        )
        picture = rendering.render(scene, "+UA", extension="exr")
        self.assert_finite(picture)
        alpha, red, blue = (picture.channel(name) for name in "ARB")
        told = picture.told
        self.assertEqual((alpha[0], alpha[24 * 64 + 32]), (0.0, 1.0), told)
        self.assertTrue(all(0.0 <= a <= 1.0 for a in alpha), told)
        self.assertGreater(sum(0.05 < a < 0.95 for a in alpha), 30, told)
        # background light would make a halo
        for a, r, b in zip(alpha, red, blue):
            self.assertLess(abs(r - a), 0.01, f"red {r}, coverage {a}\n{told}")
            self.assertLess(abs(b - 0.25 * a), 0.01, f"blue {b}, coverage {a}\n{told}")


if __name__ == "__main__":
    rendering.main()

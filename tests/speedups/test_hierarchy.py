# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The picture does not depend on the boxes."""

from tests.render import rendering

LIGHT = "light_source { <40, 60, -50>, 1 }\n"
SIZE = {"width": 64, "height": 48}

# splits of nested boxes bring nothing
NESTED = """
union { #for (I, 1, 23) sphere { 0, 0.04*I scale <1, 1 + 0.01*I, 1> pigment { rgbt <1, 1 - I/30, 0, 0.8> } } #end
        split_union on translate <-1, 1, 1> }
"""
SCATTERED = """
#declare Dice = seed(4);
#for (I, 1, 300)
  #local Place = <6*rand(Dice) - 3, 3*rand(Dice) - 0.5, 5*rand(Dice)>;
  #if (mod(I, 3)) sphere { Place, 0.12 pigment { rgb <rand(Dice), rand(Dice), 0.5> } finish { reflection 0.2 } }
  #else box { Place, Place + 0.2 pigment { rgb <0.2, rand(Dice), rand(Dice)> } } #end
#end
"""
MESHES = """
#declare Dice = seed(9);
#declare Leaf = mesh { #for (I, 1, 200)
  #local Place = <rand(Dice), rand(Dice), rand(Dice)>;
  triangle { Place, Place + 0.2*<rand(Dice), rand(Dice), 0>, Place + 0.2*<0, rand(Dice), rand(Dice)> }
#end inside_vector y }
object { Leaf pigment { rgb <0.3, 0.8, 0.2> } translate <-0.5, 0, 0> }
intersection { object { Leaf } sphere { 0.5, 0.6 } pigment { rgb <0.9, 0.3, 0.2> } translate <0.8, -0.3, 1> }
"""
INFINITE = """
plane { y, -0.6 pigment { checker rgb 0.2 rgb 0.8 } } plane { -z, -8 pigment { rgb <0.3, 0.4, 0.7> } }
sphere { <1, 0, 1e6>, 1e5 pigment { rgb 1 } } sphere { <0, 0, 2>, 1e-4 pigment { rgb 1 } }
"""
# a town in millimetres before hills: POV-Ray calls objects of more than 2e10 cubic units infinite
MILLIMETRES = """
light_source { <4e6, 6e6, -5e6>, 1 }
#declare Dice = seed(6);
#for (I, 1, 120) box { <-3000, -500, -2500>, <3000, 4000 + 6000*rand(Dice), 2500> rotate 90*rand(Dice)*y
  translate <60000*rand(Dice) - 30000, 0, 60000*rand(Dice)> pigment { rgb <rand(Dice), rand(Dice), 0.5> } } #end
#for (I, 1, 12) sphere { 0, 9e4 scale <1, 0.3 + 0.02*I, 1> translate <4e4*I - 2.6e5, -5000*I, 4e5> pigment { rgb I/20 } } #end
plane { y, -600 pigment { checker rgb 0.2 rgb 0.8 scale 2000 } }
intersection { plane { y, -400 } plane { x, -2e4 } pigment { rgb <0.2, 0.3, 0.6> } finish { reflection 0.3 } }
"""
# more than the traversal's stack holds
CROWD = """
#for (I, 1, 90) plane { -z, I/10 - 18 pigment { rgb <0.3, I/90, 0.7> } }
  sphere { <I/300, 0.7, 0>, 0.5 + I/300 pigment { rgbf <1, I/90, 0.5, 0.9> } } #end
"""
# triangles may be skipped; an inside needs all intersections; one mesh per triangle
TRIANGLES = """
#declare Dice = seed(5);
#macro Leaf()
  #local Place = <rand(Dice), rand(Dice), rand(Dice)>;
  triangle { Place, Place + 0.3*<rand(Dice), rand(Dice), 0>, Place + 0.3*<0, rand(Dice), rand(Dice)> }
#end
union { %s pigment { rgbf <0.4, 1, 0.6, 0.7> } scale <3, 2, 2.5> translate <-1.5, -0.3, 0> }
plane { y, -0.6 pigment { checker rgb 0.2 rgb 0.8 } }
"""
LEAVES = {
    "passed over": "mesh { #for (I, 1, 150) Leaf() #end }",
    "all wanted": "mesh { #for (I, 1, 150) Leaf() #end inside_vector <1, 2, 3> }",
    "one by one": "#for (I, 1, 150) mesh { Leaf() } #end",
}
ASKED = """
#macro Corner(A, B) <cos(A)*cos(B), sin(B), sin(A)*cos(B)> #end
#declare Ball = mesh { #for (I, 0, 23) #for (J, -6, 5)
    #local A = I*pi/12; #local B = J*pi/12; #local C = A + pi/12; #local D = B + pi/12;
    triangle { Corner(A, B), Corner(C, B), Corner(A, D) } triangle { Corner(C, D), Corner(C, B), Corner(A, D) }
  #end #end inside_vector <1, 2, 3> %s }
#declare Top = trace(Ball, <0.13, 4, 0.07>, -y);
#declare Within = function { pattern { object { Ball scale 0.3 } } }
sphere { Top + <0.9, 0, 2>, 0.2 pigment { rgb <0.2, 0.3, Top.y> } }
object { Ball scale 0.5 translate <-1, 0, 0> pigment { object { Ball scale 0.3 translate <-1.1, 0.3, -0.4> rgb 1, rgb x } } }
intersection { object { Ball scale 0.6 } box { -0.4, 1 } pigment { rgb <0.3, 0.7, 0.3> } translate <0.4, 0, 0> }
sphere { 0, 0.5 clipped_by { object { Ball scale <0.6, 0.6, 0.3> } } translate <1.2, 0, -0.8> pigment { rgb <0.7, 0.6, 0.2> } }
union { torus { 0.2, 0.1 rotate 50*x } bounded_by { object { Ball scale 0.25 } } translate <-0.3, 1.3, 0>
        pigment { function { 1 - Within(x, 2*y, z)/2 } } }
object { Ball hierarchy off scale 0.3 translate <0.6, 1.2, 0> pigment { rgb <0.2, 0.6, 0.8> } }
object { Ball scale 0.25 translate <0, 0.1, -1.5> pigment { rgbf 0.9 } interior { ior 1.5 }
         photons { target reflection on refraction on } }
plane { y, -0.6 pigment { checker rgb 0.3 rgb 0.8 } }
global_settings { photons { count 3000 } }
"""
WORLD = LIGHT + NESTED + SCATTERED + MESHES + INFINITE
CAMERAS = {
    "perspective": "camera { location <0.3, 0.8, -4> look_at <0, 0.7, 0> }\n",
    "along an axis": "camera { orthographic location <0.1, 0.7, -4> direction z right 4*x up 3*y }\n",
}
TILTED = (
    "camera { location <0.3, 0.8, -4> look_at <0, 0.7, 0> focal_point <0, 0.7, 0> aperture 0.1 "
    "blur_samples 2, 2 variance 0 tilt_lens { tilt 5 } }\n"
)


class Hierarchy(rendering.RenderTest):
    def test_equals_the_picture_without_boxes(self):
        for name, camera in {**CAMERAS, "tilt_lens": TILTED}.items():
            with self.subTest(name):
                self.assert_same(rendering.render(camera + WORLD, **SIZE), rendering.render(camera + WORLD, "-MB", **SIZE), name)

    def test_of_one_object_and_of_infinite_ones(self):
        for name, world in (
            ("one", LIGHT + "sphere { 0, 1 pigment { rgb 1 } }"),
            ("infinite", LIGHT + 4 * INFINITE),
            ("crowd", LIGHT + CROWD),
        ):
            with self.subTest(name):
                self.assert_same(rendering.render(TILTED + world, "+MB1", **SIZE), rendering.render(TILTED + world, "-MB", **SIZE), name)

    def test_of_large_objects(self):
        camera = (
            "camera { location <0, 12000, -30000> look_at <0, 4000, 20000> focal_point <0, 0, 20000> aperture 900 "
            "blur_samples 2, 2 variance 0 tilt_lens { tilt 5 } }\n"
        )
        picture, told = rendering.render_and_listen(camera + MILLIMETRES, "+MB1", **SIZE)
        self.assert_same(picture, rendering.render(camera + MILLIMETRES, "-MB", **SIZE))
        self.assertRegex(told, r"Finite Objects: +132\b")
        self.assertRegex(told, r"Infinite Objects: +2\b")

    def test_of_meshes(self):
        pictures = {name: rendering.render(TILTED + LIGHT + TRIANGLES % leaves, **SIZE) for name, leaves in LEAVES.items()}
        for name in ("passed over", "all wanted"):
            self.assert_same(pictures[name], pictures["one by one"], name)

    def test_of_meshes_by_every_query(self):
        for name, camera in {**CAMERAS, "tilt_lens": TILTED}.items():
            walked = rendering.render(camera + LIGHT + ASKED % "hierarchy off", "-MB", "+WT1", **SIZE)
            for options in ("-MB",), ("+MB1",), ("+BM2",), ("+MB1", "+WT4"):
                with self.subTest(name, options=options):
                    self.assert_same(rendering.render(camera + LIGHT + ASKED % "", *options, **SIZE), walked, name)


if __name__ == "__main__":
    rendering.main()

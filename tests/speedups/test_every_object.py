# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Hierarchies of tilt_lens scenes give the pictures without bounding (-MB).

An empty tilt_lens block keeps the camera's rays. Stock's hierarchy (+MB) misses some rays along faces of boxes."""

import random

from tests.render import rendering

SIZE = {"width": 48, "height": 36}
LIGHTS = "light_source { <40, 60, -50>, 1 }\nlight_source { <-60, 30, -20>, 0.4 }\n"
FLOOR = "plane { y, -1.31 pigment { checker rgb 0.2 rgb 0.8 } finish { reflection 0.15 } }\n"

POINTS = "<-0.7, -0.8>, <0.9, -0.5>, <0.6, 0.8>, <-0.8, 0.7>, <-0.7, -0.8>"
MESH2 = (
    "mesh2 { vertex_vectors { 5, <0, 1, 0>, <1, -0.8, 0.9>, <-1, -0.7, 1>, <-0.9, -0.8, -1>, <0.8, -0.9, -0.9> } "
    "face_indices { 6, <0, 1, 2>, <0, 2, 3>, <0, 3, 4>, <0, 4, 1>, <1, 2, 3>, <1, 3, 4> } %s }"
)
PATCH = " ".join(f", <{x - 1.5}, {((x * 7 + z * 5) % 4) * 0.5 - 0.7}, {z - 1.5}>" for z in range(4) for x in range(4))
OBJECTS = {
    "box": "box { -0.8, <0.9, 0.7, 0.8> }",
    "sphere": "sphere { 0.1*y, 0.9 }",
    "ellipsoid": "sphere { 0, 1 scale <1, 0.4, 0.7> }",
    "cylinder": "cylinder { -0.8*y, 0.7*y, 0.6 }",
    "open cylinder": "cylinder { -0.8*x, 0.7*y, 0.6 open }",
    "cone": "cone { -0.8*y, 0.8, 0.9*y, 0.2 }",
    "torus": "torus { 0.7, 0.25 }",
    "disc": "disc { 0, <1, 2, -2>, 0.9, 0.3 }",
    "triangle": "triangle { <-0.9, -0.8, 0>, <0.9, -0.7, 0.2>, <0.1, 0.9, 0.5> }",
    "smooth_triangle": "smooth_triangle { <-0.9, -0.8, 0>, <-1, 0, -2>, <0.9, -0.7, 0.2>, <1, 0, -2>, <0.1, 0.9, 0.5>, <0, 1, -2> }",
    "polygon": f"polygon {{ 5, {POINTS} }}",
    "mesh": "mesh { triangle { <-0.9, -0.8, 0>, <0.9, -0.7, 0.2>, <0.1, 0.9, 0.5> } "
    "smooth_triangle { <-0.8, -0.7, 1>, -z, <0.9, 0.7, 1.2>, <1, 0, -2>, <-0.4, 0.9, 0.5>, <0, 1, -2> } }",
    "mesh2": MESH2 % "",
    "mesh2 with inside": MESH2 % "inside_vector <1, 2, 3>",
    "prism": f"prism {{ linear_spline -0.5, 0.6, 5, {POINTS} }}",
    "prism of curves": f"prism {{ cubic_spline -0.5, 0.6, 7, <-0.8, 0.7>, {POINTS}, <0.9, -0.5> }}",
    "conic prism": f"prism {{ conic_sweep linear_spline 0.2, 1, 5, {POINTS} }}",
    "lathe": "lathe { quadratic_spline 5, <0.2, -1>, <0.3, -0.8>, <0.9, -0.2>, <0.5, 0.5>, <0.1, 0.9> }",
    "sor": "sor { 5, <0.3, -1>, <0.4, -0.8>, <0.9, -0.2>, <0.5, 0.5>, <0.4, 0.9> }",
    "blob": "blob { threshold 0.5 sphere { -0.4*x, 0.9, 1 } sphere { 0.5*x, 0.8, 1 } cylinder { -0.5*y, 0.7*y, 0.5, 1 } }",
    "superellipsoid": "superellipsoid { <0.3, 0.6> scale 0.8 }",
    "quadric": "quadric { <1, 1, -0.4>, <0, 0, 0>, <0, 0, 0>, -0.4 clipped_by { box { -1, 1 } } }",
    "cubic": "cubic { <1, 0, 0, 0.3, 0, 0, 0, 0, 0, -0.5, 0.2, 1, 0, 0, 0, 1, 0, 0, 0, -0.3> clipped_by { box { -1, 1 } } }",
    "quartic": "quartic { <1, 0, 0, 0, 2, 0, 0, 2, 0, -0.9, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 2, 0, 0.7, 0, 0, 0, 0, 1, 0, -0.9, "
    "0, 0.15> sturm clipped_by { box { -1.1, 1.1 } } }",
    "parametric": "parametric { function { u*0.9 } function { sin(3*u)*cos(2*v)*0.4 } function { v*0.8 } <-1, -1>, <1, 1> "
    "contained_by { box { -1, 1 } } accuracy 0.01 }",
    "isosurface": "isosurface { function { x*x + y*y*y*y + z*z - 0.6 } contained_by { box { -1, 1 } } max_gradient 5 }",
    "julia_fractal": "julia_fractal { <-0.08, 0, -0.83, -0.025> quaternion sqr max_iteration 5 precision 20 scale 0.7 }",
    "height_field": "height_field { function 12, 12 { pattern { bozo scale 0.2 } } smooth translate -0.5 scale <2, 0.9, 2> }",
    "text": 'text { internal 1 "Rg" 0.3, 0 translate <-0.6, -0.3, 0> scale 1.4 }',
    "bicubic_patch": f"bicubic_patch {{ type 1 flatness 0.01 u_steps 3 v_steps 3 {PATCH[1:]} scale 0.6 }}",
    "sphere_sweep": "sphere_sweep { cubic_spline 5, <-2, 0, 0>, 0.2, <-0.8, 0.5, 0>, 0.3, <0, -0.6, 0>, 0.2, <0.8, 0.4, 0.3>, 0.3, "
    "<2, 0, 0>, 0.2 }",
    "ovus": "ovus { 0.7, 0.4 translate -0.5*y }",
    "union": "union { sphere { -0.3*x, 0.5 } box { 0, 0.8 } cone { -0.9*y, 0.6, 0, 0.1 } }",
    "merge": "merge { sphere { -0.3*x, 0.5 } box { -0.1, 0.8 } }",
    "intersection": "intersection { sphere { 0, 0.9 } box { -0.7, 0.65 } }",
    "difference": "difference { box { -0.7, 0.75 } sphere { <0.2, 0.3, -0.7>, 0.6 } cylinder { -2*x, 2*x, 0.3 } }",
    "mesh in CSG": "intersection { object { %s } sphere { 0, 0.8 } }" % (MESH2 % "inside_vector <1, 2, 3>"),
    "inverse": "intersection { sphere { 0, 0.9 } box { -0.4, 0.45 inverse } }",
    "clipped": "sphere { 0, 0.9 clipped_by { plane { <1, 1, -1>, 0.2 } } }",
    "clipped mesh": "object { %s clipped_by { box { -0.6, 2 } } }" % (MESH2 % ""),
    "bounded": "union { torus { 0.6, 0.2 } sphere { 0, 0.3 } bounded_by { sphere { 0, 0.9 } } }",
    "bounded by a mesh": "union { torus { 0.6, 0.2 } sphere { 0, 0.3 } bounded_by { object { %s scale 3 } } }"
    % (MESH2 % "inside_vector <1, 2, 3>"),
    "no_shadow": "box { -0.6, 0.7 no_shadow }",
    "no_image": "box { -0.6, 0.7 no_image }",
    "no_reflection": "sphere { 0, 0.8 no_reflection double_illuminate }",
    "hollow glass": "sphere { 0, 0.8 hollow pigment { rgbf <1, 0.8, 0.7, 0.8> } interior { ior 1.4 } }",
    "lamp": "light_source { <0, 1, -1>, 0.3 looks_like { sphere { 0, 0.5 pigment { rgb 1 } finish { emission 0.7 } } } }",
    "light_group": "light_group { light_source { <3, 3, -3>, 0.7 } sphere { 0, 0.8 } global_lights on }",
}

PLACES = [
    "rotate <20, 35, 10> translate <-1.6, 0, 0.4>",
    "rotate <0, 80, -30> scale <0.8, 1.2, 0.7> translate <0.3, -0.1, 2.1>",
    "rotate -50*x scale 0.5 translate <1.7, 0.2, -0.7>",
    "scale 0.3 rotate 77 translate <0.4, -0.8, -1.3>",
]


def camera(block, more=""):
    return "camera { location <0.31, 0.83, -5.2> look_at <0.07, 0.03, 0> angle 48 " f"{'tilt_lens { }' if block else ''} {more} }}\n"


def in_millimetres(world):
    """Some objects have more than 2e10 cubic units, which POV-Ray calls infinite."""
    return world.replace("}\n", "scale 4000 }\n")


def placed(body):
    return "#declare Thing = %s;\n" % body + "".join(
        f"object {{ Thing pigment {{ rgb <0.{9 - 2*i}, 0.{3 + i}, 0.{2 + 2*i}> }} {place} }}\n" for i, place in enumerate(PLACES)
    )


class EveryObject(rendering.RenderTest):
    def assert_as_without_boxes(self, world, what, make_camera=camera):
        self.assert_same(
            rendering.render(make_camera(True) + world, "-A", "+MB1", **SIZE),
            rendering.render(make_camera(False) + world, "-A", "-MB", **SIZE),
            what,
        )

    def test_every_object(self):
        for name, body in OBJECTS.items():
            with self.subTest(name):
                world = placed(body)
                if "pigment" in body or name in ("lamp", "light_group"):
                    world = world.replace("object { Thing pigment { rgb", "object { Thing finish { ambient rgb 0.1*")
                if name in ("lamp", "light_group"):
                    world = "".join(f"{body[:-1]} {place} }}\n" for place in PLACES)
                self.assert_as_without_boxes(LIGHTS + FLOOR + world, name)
                # the same camera twice: at these lengths the rays of both differ by a rounding
                self.assert_as_without_boxes(
                    in_millimetres(LIGHTS + FLOOR + world), f"{name} in millimetres", lambda block: in_millimetres(camera(True))
                )

    def test_random_scenes(self):
        for seed in range(12):
            dice = random.Random(seed)
            world = LIGHTS + FLOOR
            for _ in range(dice.choice((3, 9, 40, 150))):
                size = 10.0 ** dice.uniform(-2, 0)
                name = dice.choice(("sphere", "box", "mesh2", "difference", "torus", "union", "mesh in CSG", "clipped mesh", "text"))
                spin, place = (
                    [dice.uniform(-180, 180) for _ in range(3)],
                    [dice.uniform(-2, 2), dice.uniform(-1, 1.5), dice.uniform(-2, 5)],
                )
                world += (
                    f"object {{ {OBJECTS[name]} rotate <{spin[0]}, {spin[1]}, {spin[2]}> scale {size} "
                    f"translate <{place[0]}, {place[1]}, {place[2]}> pigment {{ rgbt <{dice.random()}, {dice.random()}, "
                    f"{dice.random()}, {dice.choice((0, 0, 0.5))}> }} finish {{ reflection {dice.choice((0, 0.3))} }} }}\n"
                )
            with self.subTest(seed):
                self.assert_as_without_boxes(world, f"seed {seed}")

    def test_sizes(self):
        """POV-Ray's tolerances leave little of a tiny world, nothing beyond 1e7 units."""
        world = placed(OBJECTS["mesh2"]) + placed(OBJECTS["box"]).replace("Thing", "Other").replace("translate <", "translate 1.1*<")
        for size in (1e-9, 1e-6, 1e-2, 1e3, 1e5, 1e9, 1e12):
            with self.subTest(size):
                self.assert_as_without_boxes(
                    LIGHTS
                    + FLOOR
                    + placed(OBJECTS["difference"])
                    + f"union {{ {world} scale {size} translate <0.2, 0.1, {2.1*size:.17g}> }}\n",
                    f"{size:g}",
                )

    def test_along_axes(self):
        def axes(block, direction, up):
            return (
                f"camera {{ location -4*{direction} direction {direction} right 4*vcross({up}, {direction}) up 3*{up} "
                f"{'tilt_lens { }' if block else ''} }}\n"
            )

        grid = "".join(
            f"box {{ <{x}, {y}, {z}>, <{x + 0.5}, {y + 0.5}, {z + 0.5}> pigment {{ rgb <0.{3 + x}, 0.{4 + y}, 0.{5 + z}> }} }}\n"
            for x in (-2, -1, 0, 1)
            for y in (-2, 0, 1)
            for z in (-1, 0, 1)
        )
        for direction, up in (("z", "y"), ("x", "y"), ("-y", "z")):
            with self.subTest(direction):
                self.assert_as_without_boxes(
                    LIGHTS + grid + placed(OBJECTS["mesh2"]), direction, lambda block, d=direction, u=up: axes(block, d, u)
                )

    def test_camera_inside(self):
        for place in ("<0, 0, 0>", "<-0.5, 0.2, 0>", "<0.5, 0.5, 0.5>", "<0.5, 0.5, 0>", "<0.25, 0, -0.5>"):

            def inside(block, place=place):
                return f"camera {{ location {place} look_at {place} + <0.4, 0.1, 1> angle 90 " f"{'tilt_lens { }' if block else ''} }}\n"

            with self.subTest(place):
                self.assert_as_without_boxes(
                    LIGHTS + "box { -0.5, 0.5 pigment { checker rgbt <1, 0.5, 0.2, 0.4> rgbt <0.2, 0.5, 1, 0.4> scale 0.21 } }"
                    "sphere { <0.2, 0.1, 0.3>, 0.4 pigment { rgbt <0.3, 0.9, 0.4, 0.6> } }" + FLOOR + placed(OBJECTS["mesh2"]),
                    place,
                    inside,
                )

    def test_degenerate(self):
        world = (
            "".join(f"disc {{ <{0.3*i - 1.5}, 0, {i}>, {'xyz'[i % 3]}, 0.7 pigment {{ rgb <0.{i}, 0.5, 0.7> }} }}\n" for i in range(9))
            + "".join(f"sphere {{ 0, {0.5 + 0.001*i} pigment {{ rgbt <1, {i/40:g}, 0.3, 0.9> }} }}\n" for i in range(40))
            + "triangle { <-1, -1, 3>, <1, -1, 3>, <0, 1, 3> pigment { rgb <0.9, 0.9, 0.2> } }\n"
            "sphere { <0, 0, 4>, 1e-7 pigment { rgb 1 } } sphere { <0, 3e6, 0>, 1e6 pigment { rgb <0.3, 0.4, 1> } }\n"
        )
        self.assert_as_without_boxes(LIGHTS + FLOOR + world, "degenerate")

    def test_equal_depth(self):
        for count in (3, 40):
            boxes = [
                f"box {{ -1, 1 pigment {{ rgb <{i % 3/2}, {i/count:.3f}, {1 - i/count:.3f}> }} finish {{ ambient 1 diffuse 0 }} }}\n"
                for i in range(count)
            ]
            for order in (boxes, boxes[::-1], boxes[count // 2 :] + boxes[: count // 2]):
                self.assert_as_without_boxes(LIGHTS + FLOOR + "".join(order), f"{count} boxes")


if __name__ == "__main__":
    rendering.main()

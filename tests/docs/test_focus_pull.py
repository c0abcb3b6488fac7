# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Focus pulls by tilt_lens_pull.inc."""

import itertools
import math
import pathlib
import re
import tempfile

from tests.docs.test_macros import INCLUDE, RIGHT, WORLD, Lens, refusal
from tests.render import rendering
from tools.povray_run import INCLUDE as FOLDER

EYE = "<0, 1.6, -6>"
POINT = f"focal_point Tilt_Lens_Pull_Point(clock, {EYE}) "
PULL = f"Tilt_Lens_Pull(clock, {EYE})"

# upright, through infinity, leaning backward; swing to the left
ANGLES = ((0, 2.8, 0, 0, (0, 1, -2)), (0.3, 4, 6, 0, (0, 0, 2)), (0.7, 16, -4, 3, (3, 2, 40)), (1, 5.6, 8, -5, (-1, 0.2, -3)))
# parallel to the film; the ground; a wall on the left
PLANES = (
    (0, 2.8, (0, 0, 0), (0, 2, 0), (1, 0, 0)),
    (0.4, 5.6, (0, 0, 0), (0, 0, 9), (1, 0, 0)),
    (1, 4, (-2, 0, 0), (-2, 0, 9), (-2, 3, 0)),
)


def text(value):
    return f"<{', '.join(map(str, value))}>" if isinstance(value, tuple) else str(value)


def keys(macro, rows):
    return "".join(f"{macro}({', '.join(map(text, row))})\n" for row in rows)


def film(before, camera, frames, eye=EYE):
    rendering.SETTINGS.library = [FOLDER]
    scene = f"{INCLUDE}{before}camera {{ {RIGHT}blur_samples 1 location {eye} look_at <0, 1, 2> {camera} }}\n{WORLD}"
    job = rendering.Job(scene, ("-F", "+KFI0", f"+KFF{frames - 1}"), width=8, height=6)
    with tempfile.TemporaryDirectory(prefix="tilt_lens.") as folder:
        code, said = job.attempt(pathlib.Path(folder))
    lenses = [Lens(part) for part in re.split("^Tilt Lens$", said, flags=re.MULTILINE)[1:]]  # one report a frame
    if code != 0 or len(lenses) != frames:
        raise AssertionError(f"exit code {code}, {len(lenses)} frames\n{job.told()}{said[-1500:]}")
    return lenses


def plane(lens, eye=(0, 1.6, -6)):
    """The normal divided by its distance from the lens; blur is linear in it."""
    distance = sum(n * (p - e) for n, p, e in zip(lens.normal, lens.point, eye))
    return [n / distance for n in lens.normal]


def greatest_step(lenses):
    steps = [math.dist(plane(a), plane(b)) for a, b in itertools.pairwise(lenses)]
    return max(steps) / sum(steps)


class FocusPull(rendering.RenderTest):
    CAMERAS = (
        ("Tilt_Lens_Key", ANGLES, f"{POINT}tilt_lens {{ focal_length 50 {PULL} }}"),
        ("Tilt_Lens_Key", ANGLES, f"{POINT}angle 40 tilt_lens {{ shift <0, 3> {PULL} }}"),
        ("Tilt_Lens_Key_Points", PLANES, f"tilt_lens {{ focal_length 35 {PULL} blades 7 }}"),
        ("Tilt_Lens_Key_Points", PLANES, f"angle 40 tilt_lens {{ {PULL} }}"),
    )

    def test_the_plane_never_jumps(self):
        """Twice as many frames halve the greatest step; a jump would stay."""
        for (macro, rows, camera), ease in itertools.product(self.CAMERAS, ("yes", "no")):
            before = f"#declare Tilt_Lens_Ease = {ease};\n{keys(macro, rows)}"
            coarse, fine = (greatest_step(film(before, camera, frames)) for frames in (26, 51))
            self.assertLess(fine, 0.1, camera)
            self.assertLess(fine / coarse, 0.6, f"{camera}: steps of {coarse} and {fine}")

    def test_keys_are_met(self):
        for macro, rows, camera in self.CAMERAS:
            lenses = film(keys(macro, rows), camera, 11)
            for row in rows:
                lens = lenses[round(row[0] * 10)]
                self.assertEqual(lens.aperture[0], row[1], f"{camera}\n{lens.said}")
                for value in row[2:]:
                    if isinstance(value, tuple):
                        self.assertLess(lens.off_plane(value), 1e-5, f"{camera}: {row}\n{lens.said}")
                if macro == "Tilt_Lens_Key":
                    self.assertEqual(lens.turn, list(row[2:4]), f"{camera}\n{lens.said}")

    def test_between_two_keys(self):
        before = keys("Tilt_Lens_Key", ((0, 2, 0, 4, (0, 1.6, -4)), (1, 8, 6, -2, (0, 1.6, 2))))
        camera = f"look_at <0, 1.6, 0> {POINT}tilt_lens {{ focal_length 50 {PULL} }}"
        for ease, weights in (("no", (0, 0.25, 0.5, 0.75, 1)), ("yes", (0, 0.15625, 0.5, 0.84375, 1))):
            for weight, lens in zip(weights, film(f"#declare Tilt_Lens_Ease = {ease};\n{before}", camera, 5)):
                distance = 1 / ((1 - weight) / 2 + weight / 8)
                self.assertLess(lens.off_plane((0, 1.6, distance - 6)), 1e-5, f"{weight}\n{lens.said}")
                self.assertLess(abs(lens.turn[0] - 6 * weight), 1e-3, lens.said)
                self.assertLess(abs(lens.turn[1] - (4 - 6 * weight)), 1e-3, lens.said)
                self.assertLess(abs(lens.aperture[0] / (2 * 4**weight) - 1), 1e-3, lens.said)

    def test_planes_stay_between_the_keys(self):
        first, second = ((-1, 0, 0), (-1, 2, 0), (1, 0, 0.5)), ((0, 0, 0), (1, 0, 4), (-2, 0.3, 3))
        lenses = film(keys("Tilt_Lens_Key_Points", ((0, 4, *first), (1, 4, *second))), f"angle 40 tilt_lens {{ {PULL} }}", 26)
        begin, end = plane(lenses[0]), plane(lenses[-1])
        length, passed = math.dist(begin, end), 0
        for lens in lenses[1:-1]:
            here = plane(lens)
            from_begin, to_end = math.dist(begin, here), math.dist(here, end)
            self.assertLess(from_begin + to_end, length * (1 + 1e-4), lens.said)
            self.assertGreater(from_begin, passed)
            passed = from_begin

    def test_a_moving_camera(self):
        eye = "<clock, 1.6, -6 + 2*clock>"
        lenses = film(
            keys("Tilt_Lens_Key_Points", ((0.2, 4, *PLANES[1][2:]), (0.5, 4, *PLANES[2][2:]))),
            f"angle 50 tilt_lens {{ Tilt_Lens_Pull(clock, {eye}) }}",
            11,
            eye,
        )
        for frame, points in ((0, PLANES[1]), (2, PLANES[1]), (5, PLANES[2]), (10, PLANES[2])):
            for point in points[2:]:
                self.assertLess(lenses[frame].off_plane(point), 1e-5, lenses[frame].said)

    def test_through_infinity(self):
        rows = ((0, 4, (0, 0, -2), (0, 9, -2), (1, 0, -2)), (1, 4, (0, 0, -10), (0, 9, -10), (1, 0, -10)))
        lenses = film(
            f"#declare Tilt_Lens_Ease = no;\n{keys('Tilt_Lens_Key_Points', rows)}",
            f"look_at <0, 1.6, 0> angle 40 tilt_lens {{ {PULL} }}",
            5,
        )
        for lens, expected in zip(lenses, (0.25, 0.125, 0, -0.125, -0.25)):
            self.assertLess(math.dist(plane(lens), (0, 0, expected)), 1e-5, lens.said)

    def test_another_pull(self):
        before = f"{keys('Tilt_Lens_Key', ANGLES)}#declare Tilt_Lens_Keys = 0;\n{keys('Tilt_Lens_Key_Points', PLANES[1:2])}"
        lens = film(before, f"angle 40 tilt_lens {{ {PULL} }}", 2)[1]
        for point in PLANES[1][2:]:
            self.assertLess(lens.off_plane(point), 1e-5, lens.said)

    def test_refusals(self):
        view = f"location {EYE} look_at 0 "
        block = f"tilt_lens {{ {PULL} }}"
        angles, planes = keys("Tilt_Lens_Key", ANGLES), keys("Tilt_Lens_Key_Points", PLANES)
        for before, camera, words in (
            ("", block, "Tilt_Lens_Pull: there is no key. Write Tilt_Lens_Key or Tilt_Lens_Key_Points before the camera."),
            (
                angles,
                block,
                "Tilt_Lens_Pull: no focal_point for Time 0.0000. Before tilt_lens write focal_point Tilt_Lens_Pull_Point(Time, Location).",
            ),
            (angles, f"focal_point Tilt_Lens_Pull_Point(0.5, {EYE}) {block}", "no focal_point for Time 0.0000"),
            (angles, f"{block} {POINT}", "Before tilt_lens write"),
            (
                planes,
                f"{POINT}{block}",
                "Tilt_Lens_Pull_Point: keys by Tilt_Lens_Key_Points say all about the plane; leave focal_point out.",
            ),
            (
                angles + "Tilt_Lens_Key(1, 4, 0, 0, 0)",
                block,
                "Time is 1.0000, but the key before it has 1.0000. Times must grow; sort the keys.",
            ),
            (angles + "Tilt_Lens_Key(0.5, 4, 0, 0, 0)", block, "Time is 0.5000, but the key before it has 1.0000"),
            (
                angles + "Tilt_Lens_Key_Points(2, 4, x, y, z)",
                block,
                "Tilt_Lens_Key_Points: the keys before are of the other kind. Use one kind, or #declare Tilt_Lens_Keys = 0; first.",
            ),
            ("Tilt_Lens_Key(0, 0, 0, 0, 0)", block, "Tilt_Lens_Key: Stop is 0.0000. It must be larger than 0"),
            (
                "Tilt_Lens_Key(0, 4, 1, -90, 0)",
                block,
                "at Time 0.0000 Tilt is 1.0000 and Swing -90.0000 degrees. Both must be between -90 and 90",
            ),
            (
                "Tilt_Lens_Key_Points(3, 4, 0, x, 2*x)",
                block,
                "Tilt_Lens_Key_Points: at Time 3.0000 the three points are on one line. A plane needs three that are not; move one.",
            ),
            ("Tilt_Lens_Key_Points(3, 4, x, x, z)", block, "at Time 3.0000 the three points are on one line"),
            (
                f"Tilt_Lens_Key_Points(3, 4, {EYE}, x, y)",
                block,
                "Tilt_Lens_Pull: the plane of the key at Time 3.0000 passes through Location. No lens can do that; move a point.",
            ),
            (
                f"Tilt_Lens_Key(3, 4, 0, 0, {EYE})",
                POINT + block,
                "Subject of the key at Time 3.0000 is at Location. No lens can focus there; move it.",
            ),
            (
                "#declare N = 0; #while (N < 101) Tilt_Lens_Key(N, 4, 0, 0, 0) #declare N = N + 1; #end",
                block,
                "there are 100 keys already, and no more are allowed; leave some out.",
            ),
        ):
            code, said = refusal(view + camera, before)
            self.assertNotEqual(code, 0, f"{before}{camera}\n{said}")
            self.assertIn(words, said, f"{before}{camera}: {said}")
            self.assertRegex(said, r"File 'scene\.pov' line \d+: Parse Error", "the place is that of the call")

    def test_wrong_kinds(self):
        for before, words in (
            ("Tilt_Lens_Key(0, 4, <1, 2, 3>, 0, 0)", "Tilt_Lens_Key: Tilt is a point <x, y, z>. It must be a number"),
            ('Tilt_Lens_Key(0, 4, 0, 0, "tree")', "Tilt_Lens_Key: Subject is a text. It must be a point"),
            ("Tilt_Lens_Key_Points(<0, 0, 0>, 4, 0, x, y)", "Tilt_Lens_Key_Points: Time is a point <x, y, z>. It must be"),
        ):
            code, said = refusal("tilt_lens {}", before)
            self.assertNotEqual(code, 0, said)
            self.assertIn(words, said)
            self.assertIn("File 'scene.pov' line 3", said)


if __name__ == "__main__":
    rendering.main()

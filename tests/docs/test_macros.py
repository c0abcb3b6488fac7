# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The macros of tilt_lens.inc."""

import math
import pathlib
import re
import tempfile

from tests.render import rendering
from tools import povray_run
from tools.repository import ROOT

INCLUDE = '#include "tilt_lens.inc"\n'
WORLD = "sphere { <0, 0, 1e4>, 1 } light_source { <0, 100, -100>, rgb 1 }\n"
RIGHT = "right x*image_width/image_height "
NUMBER = r"(-?[\d.]+(?:e[-+]?\d+)?|infinity)"
VECTOR = rf"<{NUMBER}, {NUMBER}, {NUMBER}>"


def numbers(match):
    return [float(group) for group in match.groups()]


class Lens:
    PATTERNS = {
        "turn": rf"Lens\.+tilt {NUMBER}, swing {NUMBER} degrees",
        "focal": rf"Focal length\.+{NUMBER} mm, film at {NUMBER} mm",
        "aperture": rf"Aperture\.+f/{NUMBER}, diameter {NUMBER} mm",
        "point": rf"Sharp plane through\.+{VECTOR}",
        "normal": rf"normal\.+{VECTOR}",
        "hinge": rf"Hinge line\.+(?:at )?{NUMBER}",
        "range": rf"Sharp on the axis\.+from {NUMBER} units to {NUMBER}",
    }

    def __init__(self, said):
        self.said = re.sub(r"\s+", " ", said)
        for name, pattern in self.PATTERNS.items():
            match = re.search(pattern, self.said)
            setattr(self, name, numbers(match) if match else None)

    def off_plane(self, point):
        along = sum(n * (p - q) for n, p, q in zip(self.normal, point, self.point))
        return abs(along) / (1 + max(abs(v) for v in [*point, *self.point]))

    def point_distance(self, eye):
        return math.dist(self.point, eye)


def report(camera, before="", size=(32, 18)):
    scene = f"{INCLUDE}{before}\ncamera {{ {RIGHT}blur_samples 1 {camera} }}\n{WORLD}"
    library = rendering.SETTINGS.library
    rendering.SETTINGS.library = [povray_run.INCLUDE]
    try:
        return Lens(rendering.render_and_listen(scene, width=size[0], height=size[1])[1])
    finally:
        rendering.SETTINGS.library = library


def refusal(camera, before=""):
    scene = f"#version 3.7;\n{INCLUDE}{before}\ncamera {{ {camera} }}\n{WORLD}"
    with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
        (pathlib.Path(name) / "scene.pov").write_text(scene)
        command = povray_run.command(rendering.SETTINGS.povray, "scene.pov", None, (8, 6), library=[povray_run.INCLUDE])
        done = povray_run.run(command, name)
    return done.code, re.sub(r"\s+", " ", done.said)


def table(page, heading):
    below = page.read_text().split(f"\n{heading}\n", 1)[1]
    lines = [line for line in below.split("\n#", 1)[0].split("\n") if line.startswith("|")]
    return [[cell.strip().strip("`") for cell in line.strip("|").split("|")] for line in lines[2:]]


class Macros(rendering.RenderTest):
    VIEW = "location <0, 2, -6> look_at <0, 1, 0> "

    def assert_close(self, found, expected, relative, what):
        self.assertLessEqual(abs(found - expected), relative * max(abs(expected), 1e-3), f"{what}: found {found:g}, expected {expected:g}")

    def test_formats(self):
        rows = table(ROOT / "docs" / "manual.md", "#### Film formats")
        self.assertGreaterEqual(len(rows), 8)
        say = "".join(f'#debug concat("{name} ", str(Tilt_Lens_Film_Width({name}), 0, 6), "\\n")\n' for name, _, _ in rows)
        for width, height in ((36, 24), (24, 36), (32, 18), (20, 20)):
            said = report(self.VIEW + "tilt_lens {}", say, size=(width, height)).said
            for name, long, short in rows:
                sides = (float(long), float(short)) if width >= height else (float(short), float(long))
                found = float(re.search(rf"{name} ([\d.]+)", said)[1])
                self.assert_close(found, min(sides[0], sides[1] * width / height), 1e-5, f"{name}, {width} x {height}")

    def test_film_width_reaches_the_lens(self):
        lens = report(self.VIEW + "angle 90 tilt_lens { film_width Tilt_Lens_Film_Width(Tilt_Lens_Film_4x5) f_stop 8 }", size=(24, 36))
        self.assert_close(lens.focal[1], 127 * 24 / 36 / 2, 1e-4, "film's distance")

    def test_lenses(self):
        rows = table(ROOT / "docs" / "manual.md", "#### Lenses")
        self.assertEqual(len(rows), 10)
        for macro, _, focal, stop, tilt, shift in rows:
            focal, stop, tilt, shift = (float(text.split()[0].lstrip("f/")) for text in (focal, stop, tilt, shift))
            fit = report(f"{self.VIEW}{macro}(1000, {stop}, {tilt}, 0, <0, {shift}>)")
            # a frame at the limits may miss the plane of sharp focus, which also warns
            self.assertNotRegex(fit.said, r"the real one stops|opens to f/", macro)
            self.assert_close(fit.focal[0], focal, 1e-4, macro)
            self.assert_close(fit.aperture[0], stop, 1e-4, macro)
            self.assert_close(fit.turn[0], tilt, 1e-4, macro)
            past = {
                f"opens to f/{stop:.1f} only": (stop * 0.99, 0, 0, 0, 0),
                f"turned by {tilt * 1.02:.2f} degrees; the real one stops at {tilt:.1f}": (stop, -tilt * 1.02, 0, 0, 0),
                f"mm; the real one stops at {shift:.1f}": (stop, 0, 0, shift * 0.8, -shift * 0.8),
            }
            cameras = "".join(
                f"#declare C = camera {{ {self.VIEW}{macro}({n}, {a}, {t}, {s}, <{right}, {up}>) }}\n"
                for n, (a, t, s, right, up) in enumerate([*past.values(), (stop, 0.72 * tilt, 0.72 * tilt, 0, 0)], 1000)
            )
            said = report(self.VIEW, cameras).said
            self.assertEqual(said.count("Warning:"), 4, f"{macro}: {said}")
            self.assertEqual(said.count(f"degrees; the real one stops at {tilt:.1f}"), 2, f"{macro}: {said}")
            for words in past:
                self.assertIn(words, said, macro)

    def test_lenses_of_glass(self):
        rows = table(ROOT / "docs" / "manual.md", "#### Lenses of glass")
        text = (ROOT / "scenes" / "include" / "tilt_lens.inc").read_text()
        files = {path.name for path in (ROOT / "scenes" / "include" / "lenses").iterdir()} - {"lenses.csv"}
        self.assertEqual(set(re.findall(r'Tilt_Lens_Glass\("lenses/([\w.]+)"', text)), files)
        self.assertEqual(len(rows), len(files))
        for macro, _, focal, stop in rows:
            focal, stop = (float(words.split()[0].lstrip("f/")) for words in (focal, stop))
            # distant, because moving groups change the numbers nearby
            lens = report(f"{self.VIEW} focal_point <0, -1e5, 6e5> {macro}(1000, 0, 1, 0, <0, 0>)")
            self.assert_close(lens.focal[0], focal, 2e-4, macro)
            self.assert_close(lens.aperture[0], stop, 1e-3, macro)
            stopped = report(f"{self.VIEW}{macro}(1000, 8, 0, 2, <1, 2>)")
            self.assertEqual(stopped.aperture[0], 8)
            self.assertEqual(stopped.turn, [0, 2])
            self.assertIn("shift <1, 2> mm", stopped.said)

    def test_character(self):
        for macro, words in (
            ("Fast(2)", "Edge light...........0.35"),
            ("Anamorphic()", "squeezed to 0.5 of its width"),
            ("Soft()", "in the middle"),
        ):
            said = report(f"{self.VIEW}tilt_lens {{ focal_length 50 f_stop 2 tilt 2 Tilt_Lens_Character_{macro} }}").said
            self.assertIn(words, said)
            self.assertNotIn("Warning:", said)

    def test_lens_on_another_film(self):
        camera = self.VIEW + "Tilt_Lens_Canon_TS_E_24(1000, 4, 0, 0, <0, 0>) "
        for film, width in (("Full_Frame", 36), ("APS_C", 15.6 * 1.5)):
            lens = report(camera, f"#declare Tilt_Lens_Film = Tilt_Lens_Film_{film}", size=(36, 24))
            # blur of one pixel, which scales with the film's width
            blur = lens.aperture[1] * (1 / lens.range[0] - 1 / lens.point_distance((0, 2, -6))) / 1000 * lens.focal[1]
            self.assert_close(blur, width / 36, 1e-3, film)

    def test_hinge_tilt(self):
        for hinge in (300, -450):
            lens = report(f"{self.VIEW}tilt_lens {{ focal_length 50 f_stop 4 scene_unit 100 " f"tilt Tilt_Lens_Hinge_Tilt(50, {hinge}) }}")
            self.assert_close(lens.hinge[0], abs(hinge) / 100, 1e-4, "hinge distance")
            self.assertEqual(lens.turn[0] > 0, hinge > 0)

    def test_ground_tilt(self):
        pitch = math.degrees(math.atan2(340, 1000))
        lens = report(
            "location <0, 34, -100> look_at 0 tilt_lens { focal_length 50 f_stop 4 scene_unit 10 "
            f"tilt Tilt_Lens_Ground_Tilt(50, 340, {pitch}) }}"
        )
        self.assert_close(abs(lens.normal[1]), 1, 1e-5, "the plane's normal")
        for point in ((0, 0, 0), (50, 0, 300), (-20, 0, -60)):
            self.assertLess(lens.off_plane(point), 1e-4, f"{point}\n{lens.said}")

    def test_hyperfocal(self):
        for factor in (1.001, 0.999):
            lens = report(
                "location 0 look_at z "
                "focal_point z*Tilt_Lens_Hyperfocal(50, 8, Tilt_Lens_Pixel(Tilt_Lens_Film_Full_Frame))"
                f"/1000*{factor} tilt_lens {{ focal_length 50 f_stop 8 }}",
                size=(1200, 800),
            )
            expected = (50 * 50 / (8 * 36 / 1200) + 50) / 1000
            self.assertEqual(math.isinf(lens.range[1]), factor > 1, lens.said)
            self.assert_close(lens.range[0], expected / 2, 2e-3, "near limit")

    def test_turned(self):
        for angle, rotation in ((6, 0), (6, 90), (-4, 30), (8, 135), (5, -60)):
            lens = report(f"{self.VIEW}tilt_lens {{ f_stop 4 Tilt_Lens_Turned({angle}, {rotation}) }}")
            tilt, swing = (math.tan(math.radians(v)) for v in lens.turn)
            self.assert_close(math.hypot(tilt, swing), math.tan(math.radians(abs(angle))), 1e-4, "angle")
            self.assert_close(
                math.cos(math.atan2(swing, tilt) - math.radians(rotation + (180 if angle < 0 else 0))), 1, 1e-6, f"rotation {rotation}"
            )

    def test_miniature(self):
        eye, town = (-80, 133, -192), (22, 0, 26)
        text = [f"<{p[0]}, {p[1]}, {p[2]}>" for p in (eye, town)]
        lenses = {
            strength: report(f"location {text[0]} look_at {text[1]} angle 39 " f"Tilt_Lens_Miniature({text[0]}, {text[1]}, {strength})")
            for strength in (1, 2)
        }
        self.assert_close(lenses[2].aperture[1] / lenses[1].aperture[1], 2, 1e-4, "blur of twice the strength")
        self.assertLess(abs(lenses[1].normal[1]), 1e-4, f"the plane is not upright: {lenses[1].said}")
        self.assertLess(lenses[1].off_plane(town), 1e-4, lenses[1].said)
        small = [f"<{p[0] / 100}, {p[1] / 100}, {p[2] / 100}>" for p in (eye, town)]
        other = report(f"location {small[0]} look_at {small[1]} angle 39 Tilt_Lens_Miniature({small[0]}, {small[1]}, 1)")
        for name in ("turn", "focal", "aperture"):
            self.assertEqual(getattr(other, name), getattr(lenses[1], name), f"{name} depends on the scene's units")

    def test_on_ground(self):
        lens = report("location <0, 1.6, -4> look_at <0, 0.2, 3> angle 40 Tilt_Lens_On_Ground(0.2, 100, 4)")
        for point in ((0, 0.2, 0), (3, 0.2, 30)):
            self.assertLess(lens.off_plane(point), 1e-4, lens.said)
        lens = report(
            "sky z location <0, -4, 1.6> look_at <0, 3, 0> angle 40 Tilt_Lens_On_Ground(0, 100, 4)", "#declare Tilt_Lens_Sky = z;"
        )
        for point in ((0, 0, 0), (3, 30, 0)):
            self.assertLess(lens.off_plane(point), 1e-4, lens.said)

    def test_near_far(self):
        for near, far in (((-1, 0.2, 0), (4, 3, 20)), ((0.5, 1, 1), (0.5, 0, 9)), ((2, 2, 5), (-3, 0, 12))):
            places = [f"<{p[0]}, {p[1]}, {p[2]}>" for p in (near, far)]
            lens = report(
                f"location <1, 2, -6> look_at <0, 1, 5> angle 40 Tilt_Lens_Near_Far(<1, 2, -6>, <0, 1, 5>, "
                f"{places[0]}, {places[1]}, 100, 4)"
            )
            self.assert_close(lens.turn[1], 0, 1e-6, f"swing\n{lens.said}")
            self.assertNotEqual(lens.turn[0], 0)
            for point in (near, far):
                self.assertLess(lens.off_plane(point), 1e-4, lens.said)

    def columns(self, camera):
        poles = "".join(
            f"cylinder {{ <{x}, -50, 0>, <{x}, 50, 0>, 0.1 pigment {{ rgb {colour} }} finish {{ emission 1 }} }}\n"
            for x, colour in ((-5, "x"), (5, "z"))
        )
        ball = "sphere { <0, 9, 0>, 0.5 pigment { rgb y } finish { emission 1 } }\n"
        rendering.SETTINGS.library = [povray_run.INCLUDE]
        picture, _ = rendering.render_and_listen(
            f"{INCLUDE}camera {{ {RIGHT}{camera} }}\n{poles}{ball}", "+A0.01", "+R4", width=161, height=121
        )
        rows = []
        for part in (range(10), range(picture.height - 10, picture.height)):
            for colour in (0, 2):
                weights = [sum(picture.pixel(x, y)[colour] for y in part) for x in range(picture.width)]
                self.assertGreater(sum(weights), 5, f"no pole in the rows {part}\n{picture.told}")
                rows.append(sum(x * w for x, w in enumerate(weights)) / sum(weights))
        seen = [(x, y, picture.pixel(x, y)[1]) for x in range(picture.width) for y in range(picture.height)]
        total = sum(w for _, _, w in seen)
        middle = [sum(p[i] * p[2] for p in seen) / total for i in (0, 1)]
        return rows, middle

    def test_upright(self):
        eye, top = "<0, 1.7, -22>", "<0, 9, 0>"
        for camera in (
            f"Tilt_Lens_Upright({eye}, {top}, 50, 1000, 0)",
            f"Tilt_Lens_Upright({eye}, {top}, 50, 1000, 8) blur_samples 64",
            f"Tilt_Lens_Real_Upright(Tilt_Lens_TS_24, 1000, 22, {eye}, {top}) blur_samples 64",
        ):
            rows, middle = self.columns(camera)
            for i in (0, 1):
                self.assertLess(abs(rows[i] - rows[2 + i]), 0.05, f"{camera}: a pole leans: {rows}")
            self.assertLess(math.dist(middle, (80, 60)), 0.2, f"{camera}: the ball is at {middle}")
        rows, middle = self.columns(f"location {eye} look_at {top} angle 50")
        self.assertGreater(abs(rows[0] - rows[2]), 3, f"a camera turned up shows no difference: {rows}")
        self.assertLess(math.dist(middle, (80, 60)), 0.2)

    def test_upright_warns(self):
        said = report("Tilt_Lens_Real_Upright(Tilt_Lens_TS_24, 1000, 8, <0, 1.7, -10>, <0, 9, 0>)").said
        self.assertIn("mm; the real one stops at 12.0", said)

    def test_product(self):
        for eye, near, far in (((0, 20, -16), (0, 0, -4), (0, 14, 3)), ((3, 16, -22), (-2, 1, -3), (4, 9, 6))):
            places = [f"<{p[0]}, {p[1]}, {p[2]}>" for p in (eye, near, far)]
            camera = f"Tilt_Lens_Product({places[0]}, <0, 9, 0>, {places[1]}, {places[2]}, 60, 1000, 16)"
            lens = report(camera)
            self.assertEqual(lens.turn[1], 0, lens.said)
            for point in (near, far):
                self.assertLess(lens.off_plane(point), 1e-4, lens.said)
            rows, middle = self.columns(f"{camera} blur_samples 64")
            for i in (0, 1):
                self.assertLess(abs(rows[i] - rows[2 + i]), 0.05, f"{camera}: a pole leans: {rows}")
            self.assertLess(math.dist(middle, (80, 60)), 0.2, f"{camera}: the ball is at {middle}")

    def test_ring(self):
        for focal, name in ((24, "TS_24"), (90, "TS_90")):
            lens = report(f"{self.VIEW}Tilt_Lens_Real_Ring(Tilt_Lens_{name}, 100, 8, 0, 0, <2, -3>, 15)")
            self.assert_close(lens.point_distance((0, 2, -6)) + lens.focal[1] / 100, 15, 1e-4, "the distance on the ring")
            self.assertEqual((lens.focal[0], lens.aperture[0]), (focal, 8))
            self.assertIn("shift <2, -3> mm", lens.said)
        said = report(f"{self.VIEW}Tilt_Lens_Real_Ring(Tilt_Lens_TS_24, 100, 2, 9, 0, <0, 13>, 30)").said
        for words in ("opens to f/3.5 only", "the real one stops at 8.5", "the real one stops at 12.0"):
            self.assertIn(words, said)

    def test_refusals(self):
        eye = "location <0, 2, -6> look_at 0 "
        for camera, words in (
            (eye + "Tilt_Lens_Miniature(<0, 2, -6>, 0, 0)", "Tilt_Lens_Miniature: Strength is 0.0000. It must be larger"),
            (eye + "Tilt_Lens_Miniature(<0, 2, -6>, 0, -1)", "Strength is -1.0000"),
            (eye + "Tilt_Lens_Miniature(<0, 2, -6>, <0, 2, -6>, 1)", "Location and Subject are the same point"),
            (eye + "Tilt_Lens_Miniature(<0, 2, -6>, <0, 0, -6>, 1)", "it goes straight up or down (-90.00 degrees)"),
            (eye + "Tilt_Lens_Upright(<0, 2, -6>, <0, 9, -6>, 40, 1, 0)", "straight up or down (90.00 degrees)"),
            (eye + "Tilt_Lens_Upright(<0, 2, -6>, <0, 9, 0>, 180, 1, 0)", "Angle is 180.0000 degrees. It must be"),
            (eye + "Tilt_Lens_Near_Far(<0, 2, -6>, 0, <1, 0, 0>, <2, 0, 0>, 1, 4)", "lie side by side"),
            (eye + "Tilt_Lens_Near_Far(<0, 2, -6>, 0, <1, 0, 0>, <1, 0, 0>, 1, 4)", "lie side by side"),
            (eye + "Tilt_Lens_Product(<0, 2, -6>, <0, 1, 0>, <1, 0, 0>, <2, 0, 0>, 40, 1, 4)", "Tilt_Lens_Product: Near"),
            (eye + "Tilt_Lens_Product(<0, 2, -6>, <0, 1, 0>, <1, 0, 0>, <2, 1, 0>, 0, 1, 4)", "Tilt_Lens_Product: Angle is 0.0000"),
            (eye + "Tilt_Lens_Product(<0, 2, -6>, <0, 1, 0>, <1, 0, 0>, <2, 1, 0>, 40, 1, 0)", "Tilt_Lens_Product: Stop is 0.0000"),
            (
                eye + "Tilt_Lens_Real_Ring(Tilt_Lens_TS_24, 1000, 4, 0, 0, <0, 0>, 0.05)",
                "Tilt_Lens_Real_Ring: Distance is 0.0500 units (50.0 mm). It must be at least four focal lengths, 96 mm.",
            ),
            (eye + "Tilt_Lens_Real(array[3] { 1, 2, 3 }, 1, 4, 0, 0, <0, 0>)", "an array of four"),
            (eye + "Tilt_Lens_Glass_Minolta_50(1000, -1, 0, 0, <0, 0>)", "Stop is -1.0000. Neither may be less than 0"),
            (eye + "Tilt_Lens_Canon_TS_E_24(1000, 0, 0, 0, <0, 0>)", "Stop is 0.0000. It must be larger than 0"),
            (eye + "Tilt_Lens_Real_Upright(Tilt_Lens_TS_24, 1, 4, <0, 2, -6>, <0, 3, 0>)", "forms no picture of it"),
            (eye + "tilt_lens { film_width Tilt_Lens_Film_Width(array[3] { 1, 2, 3 }) }", "an array of two lengths"),
            (eye + "tilt_lens { f_stop 4 tilt Tilt_Lens_Hinge_Tilt(50, 50) }", "nearer than the focal length"),
            (eye + "tilt_lens { f_stop 4 tilt Tilt_Lens_Hinge_Tilt(0, 50) }", "Focal_Length is 0.0000"),
            (eye + "tilt_lens { f_stop 4 tilt Tilt_Lens_Ground_Tilt(50, 340, 90) }", "Pitch is 90.00 degrees. Up to 89"),
            (eye + "tilt_lens { f_stop 4 tilt Tilt_Lens_Ground_Tilt(50, -3, 9) }", "Height is -3.0000"),
            (eye + "tilt_lens { f_stop 4 Tilt_Lens_Turned(90, 0) }", "Angle is 90.0000 degrees. It must be between"),
            (eye + "focal_point z*Tilt_Lens_Hyperfocal(50, 8, 0) tilt_lens {}", "Circle is 0.0000"),
            (eye + "tilt_lens { shift <0, Tilt_Lens_Rise(<0, 0, 0>, <0, 1, 0>, 24)> }", "straight up or down"),
            (eye + "tilt_lens { shift <0, Tilt_Lens_Rise(<0, 0, 0>, <0, 1, 1>, 0)> }", "Film_Distance is 0.0000"),
        ):
            code, said = refusal(camera)
            self.assertNotEqual(code, 0, f"{camera}\n{said}")
            self.assertIn(words, said, f"{camera}: {said}")
            self.assertIn("File 'scene.pov' line 4: Parse Error", said, "the place is that of the call")

    def test_wrong_kinds(self):
        for camera, words in (
            (
                "Tilt_Lens_Canon_TS_E_24(1000, 5.6, 0, 0, 8)",
                "Tilt_Lens_Canon_TS_E_24: Shift is a number. It must be a vector of two numbers; write for example <0, 8>.",
            ),
            ("Tilt_Lens_Glass(50, 0, 1000, 0, 0, 0, <0, 8>)", "Tilt_Lens_Glass: File is a number. It must be a text; write for example"),
            ("Tilt_Lens_Real(24, 1000, 5.6, 0, 0, <0, 8>)", "Tilt_Lens_Real: Lens is a number. It must be an array"),
            ("Tilt_Lens_Miniature(<0, 2, -6>, <0, 0, 0>, <1, 2, 3>)", "Strength is a point <x, y, z>. It must be a number"),
            ('Tilt_Lens_Upright("here", <0, 9, 0>, 50, 1000, 0)', "Tilt_Lens_Upright: Location is a text. It must be a point"),
            ("Tilt_Lens_On_Ground(0, 1000, Tilt_Lens_TS_24)", "Tilt_Lens_On_Ground: Stop is an array. It must be a number"),
            ("tilt_lens { film_width Tilt_Lens_Film_Width(36) }", "Tilt_Lens_Film_Width: Film is a number. It must be an array"),
        ):
            code, said = refusal("location <0, 2, -6> look_at 0 " + camera)
            self.assertNotEqual(code, 0, f"{camera}\n{said}")
            joined = " ".join(said.split())
            self.assertIn(words, joined, f"{camera}: {said}")
            self.assertIn("line 4", joined, f"{camera}: {said}")

    def test_miniature_from_below(self):
        view = "location <0, -60, 40> sky z look_at 0 angle 30 Tilt_Lens_Miniature(<0, -60, 40>, 0, 1)"
        said = report(view).said
        self.assertIn("Tilt_Lens_Miniature: from Location to Subject it goes up by 56.3 degrees", said)
        self.assertIn("The camera's sky is <0, 0, 1>, but Tilt_Lens_Sky", said)
        self.assertNotIn("Warning:", report(view, "#declare Tilt_Lens_Sky = z;").said)

    def test_facade(self):
        corners = "".join(
            f"sphere {{ <{x}, {y}, 3>, 0.3 pigment {{ rgb {colour} }} finish {{ emission 1 }} }}\n"
            for x, y, colour in ((-4, 1, "x"), (12, 1, "y"), (-4, 10, "z"))
        )
        rendering.SETTINGS.library = [povray_run.INCLUDE]
        for eye in ("<4, 5.5, -20>", "<-3, 1.7, -15>", "<10, 8, -12>"):
            camera = f"Tilt_Lens_Facade({eye}, <-4, 1, 3>, <12, 1, 3>, <-4, 10, 3>, 1000, 0)"
            picture = rendering.render(f"{INCLUDE}camera {{ {RIGHT}{camera} }}\n{corners}", "+A0.01", "+R3", width=160, height=90)
            for colour, place in enumerate(((0, 90), (160, 90), (0, 0))):
                lit = [(x, y) for x in range(160) for y in range(90) if picture.pixel(x, y)[colour] > 0.5]
                self.assertTrue(lit, f"{camera}: no corner {colour}")
                self.assertLess(min(math.dist((x + 0.5, y + 0.5), place) for x, y in lit), 1.5, f"{camera}: {colour}")
                self.assertLess(max(math.dist((x + 0.5, y + 0.5), place) for x, y in lit), 6, f"{camera}: {colour}")
        lens = report("Tilt_Lens_Facade(<-3, 1.7, -15>, <-4, 1, 3>, <12, 1, 3>, <-4, 10, 3>, 1000, 4)")
        for point in ((-4, 1, 3), (12, 10, 3)):
            self.assertLess(lens.off_plane(point), 1e-4, lens.said)
        for camera, words in (
            ("<0, 0, 3>, <-4, 1, 3>, <12, 1, 3>, <-4, 10, 3>", "Location is 0.0000 units before the facade"),
            ("<0, 0, 9>, <-4, 1, 3>, <12, 1, 3>, <-4, 10, 3>", "Lower_Left is to the right of Lower_Right"),
            ("<0, 0, -9>, <12, 1, 3>, <-4, 1, 3>, <12, 10, 3>", "Lower_Left is to the right of Lower_Right"),
            ("<0, 0, -9>, <-4, 1, 3>, <12, 1, 3>, <0, 10, 3>", "angle at Lower_Left is 66.038 degrees. It must be 90"),
            ("<0, 0, -9>, <-4, 1, 3>, <-4, 1, 3>, <-4, 10, 3>", "two of the corners are the same point"),
        ):
            said = " ".join(refusal(f"Tilt_Lens_Facade({camera}, 1000, 0)")[1].split())
            self.assertIn(words, said, f"{camera}: {said}")

    def test_facade_in_cameras_of_both_hands(self):
        rendering.SETTINGS.library = [povray_run.INCLUDE]
        for upward, forward, hand in (("y", "z", "x"), ("y", "-z", "-x"), ("z", "y", "-x"), ("z", "-y", "x")):

            def place(a, b, c, upward=upward, forward=forward):
                return f"({a}*x + {b}*{upward} + {c}*{forward})"

            marks = "".join(
                f"sphere {{ {place(a, b, 3)}, 0.3 pigment {{ rgb {colour} }} finish {{ emission 1 }} }}\n"
                for a, b, colour in ((-4, 1, "x"), (12, 1, "y"), (-4, 10, "z"))
            )
            corners = f"{place(-4, 1, 3)}, {place(12, 1, 3)}, {place(-4, 10, 3)}"
            for moved in ("", "rotate <10, 40, 20>"):
                camera = f"camera {{ right {hand}*image_width/image_height Tilt_Lens_Facade({place(-3, 1.7, -15)}, {corners}, 1000, 0) {moved} }}"
                scene = f"{INCLUDE}#declare Tilt_Lens_Sky = {upward};\n{camera}\nunion {{ {marks} {moved} }}\n"
                picture = rendering.render(scene, "+A0.01", "+R3", width=160, height=90)
                for colour, corner in enumerate(((0, 90), (160, 90), (0, 0))):
                    lit = [(a, b) for a in range(160) for b in range(90) if picture.pixel(a, b)[colour] > 0.5]
                    self.assertTrue(lit, f"{camera}: no corner {colour}")
                    self.assertLess(max(math.dist((a + 0.5, b + 0.5), corner) for a, b in lit), 6, f"{camera}: {colour}")

    def test_aperture(self):
        lens = report("location -6*z look_at 0 angle 40 aperture Tilt_Lens_Aperture(50, 2, 1000) tilt_lens { }")
        self.assertIn("diameter 25 mm", lens.said)

    def test_included_twice(self):
        said = report(self.VIEW + "tilt_lens {}", INCLUDE).said
        self.assertNotIn("Warning:", said)


if __name__ == "__main__":
    rendering.main()

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""The page's lens in transformed cameras."""

from tests.focus import harness
from tests.focus.harness import EXPORTED, SCENE, TOWERS, PageTest

SIZE = (160, 90)
FROM_HERE = "return String(focusPage.live.location) === String(focusPage.model.camera.location)"

CAMERAS = """#include "transforms.inc"
#macro Taken_Back(P) vtransform(P, transform { Move inverse }) #end
#macro Turned_Back(V) (Taken_Back(V) - Taken_Back(<0, 0, 0>)) #end
#macro Moved()
  location Taken_Back(<0, 3, -7>)
  direction Turned_Back(2.146*<0, -0.299706, 0.954030>)
  right Turned_Back(x*16/9)
  up Turned_Back(<0, 0.954030, 0.299706>)
  blur_samples 4
#end
"""
MOVES = {
    "rotate": "rotate y*60",
    "matrix": "matrix <0.685921, 0.727676, 0, -0.324013, 0.305421, 0.895396, 0.651558, -0.614170, 0.445271, 73588.9, -69257.9, 49583.1>",
    "scale": "scale 3 translate <1, 2, 3>",
    "uneven": "scale <1, 2, 0.5> rotate 20*x",
    "mirror": "scale <-1, 1, 1>",
}


def camera_of(move, more="", behind=""):
    return f"#declare Move = transform {{ {move} }}\ncamera {{\n  Moved()\n  {more}\n  {move}\n  {behind}\n}}\n"


class MovedPage(PageTest):
    def check(self, scene, places, size=SIZE):
        blur = harness.rendered(scene, self.folder, size, "+N")["blur"]
        for x, y in places:
            found = blur[int((0.5 - y) * size[1]), int((x + 0.5) * size[0])]
            self.assertLess(abs(found), 0.3, f"{x}, {y}")
        self.assertGreater(abs(blur).max(), 2, "nothing is blurred")


class Texts(MovedPage):
    def test_the_text_makes_the_lens_before_and_behind_transformations(self):
        parts = SCENE.partition("camera {")
        objects = parts[2].split("\n}\n", 1)[1]
        head = parts[0] + CAMERAS
        self.open(self.scene(head + "".join(map(camera_of, MOVES.values())) + objects))
        for index, (name, move) in enumerate(MOVES.items()):
            self.choose("camera", index)
            self.until("its preview", lambda: self.drawn() and self.run(FROM_HERE))
            self.pick_towers()
            self.set_number("fStop", 0.7)
            self.set_number("angle", 44)
            for form in ("points", "plane", "angles"):
                self.press(f"input[name=form][value={form}]")
                text = self.text("block")
                for camera in (camera_of(move, more=text), camera_of(move, behind=text)):
                    with self.subTest(name, form=form, text=camera):
                        self.check(self.scene(head + camera + objects, "pasted.pov"), TOWERS)
        self.assertEqual(self.console(), [])


class Written(MovedPage):
    def copy(self):
        self.press("#copy")
        self.until("the trial", lambda: "tried" in self.text("file-said"))
        return self.text("file-said")

    def test_a_scene_of_an_exporter(self):
        scene = self.scene(EXPORTED)
        self.open(scene)
        self.press("input[name=mode][value=three]")
        places = ((-0.1, -0.42), (0.15, -0.3), (0.25, -0.44))
        for x, y in places:
            self.click_at(x, y)
        self.set_number("fStop", 0.7)
        self.assertIn("tried there, it makes this lens", self.copy())
        self.assertEqual(scene.read_text(), EXPORTED)
        self.press("#write")
        self.until("the change", lambda: "ritten" in self.text("file-said"))
        self.assertIn("Written", self.text("file-said"))
        self.check(scene, places)
        self.assertEqual(self.console(), [])

    def test_declared_camera(self):
        text = SCENE.replace("camera {", "#declare Cam = camera {").replace(
            "light_source", "camera { Cam rotate 9*y scale 2 }\nlight_source"
        )
        scene = self.scene(text)
        self.open(scene)
        self.pick_towers()
        self.set_number("fStop", 0.7)
        self.assertIn("tried there, it makes this lens", self.copy())
        self.press("#write")
        self.until("the change", lambda: "ritten" in self.text("file-said"))
        self.assertIn("Written", self.text("file-said"))
        self.check(scene, TOWERS)

    def test_what_cannot_be_tried_is_said(self):
        (self.folder / "more.inc").write_text(SCENE)
        self.open(self.scene('#include "more.inc"\n'))
        self.assertIn("It could not be tried in the scene: the camera stands in another file, more.inc.", self.copy())


if __name__ == "__main__":
    harness.main()

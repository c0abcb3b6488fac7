# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Bits_Per_Color=32 with OpenEXR."""

import pathlib
import re
import subprocess
import tempfile

from tests.render import rendering, scenes

# values beyond half's range or digits
CAMERA = "camera { orthographic location -z look_at 0 right 4*x up y }\n"
VALUES = (123456.75, 1e-9, 0.7071067690849304, 1.0)
SQUARES = CAMERA + "".join(
    f"box {{ <{i - 2}, -1, 0>, <{i - 1}, 1, 1> pigment {{ rgb {v} }} finish {{ ambient 0 emission 1 diffuse 0 }} }}\n"
    for i, v in enumerate(VALUES)
)
SIZE = {"width": 8, "height": 2}


def picture(scene, *options, **how):
    with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
        job = rendering.Job(scene, options, extension="exr", **how)
        job.run(pathlib.Path(name))
        kinds = subprocess.run(["exrheader", f"{name}/picture.exr"], capture_output=True, check=True, text=True).stdout
        return job.result(pathlib.Path(name)), kinds


class FloatColour(rendering.RenderTest):
    def test_values_survive(self):
        for option in ("+FE32", "Bits_Per_Color=32"):
            seen, kinds = picture(SQUARES, option, **SIZE)
            self.assertEqual(kinds.count("32-bit floating-point"), 3, kinds)
            for i, value in enumerate(VALUES):
                for found in seen.pixel(2 * i, 0):
                    self.assertAlmostEqual(found / value, 1.0, delta=3e-7, msg=seen.told)

    def test_half_by_default(self):
        for options in ((), ("+FE16",), ("Bits_Per_Color=24",)):
            seen, kinds = picture(SQUARES, *options, **SIZE)
            self.assertEqual(kinds.count("16-bit floating-point"), 3, kinds)
            self.assertNotAlmostEqual(seen.pixel(0, 0)[0], VALUES[0], delta=1.0)

    def test_same_picture_as_half(self):
        for options in ((), ("+UA",), ("File_Gamma=2.2",)):
            scene = scenes.TILTED.replace("background { rgb <0.3, 0.5, 0.8> }", "")
            many, few = picture(scene, "+FE32", *options)[0], picture(scene, *options)[0]
            self.assertEqual(many.names, few.names)
            for a, b in zip(many.values, few.values):
                self.assertAlmostEqual(a, b, delta=1e-7 + 6e-4 * abs(a))

    def test_other_formats_are_unchanged(self):
        """Existing command lines rely on upstream's 16 bits."""
        wanted = rendering.render(SQUARES, "+FN16", **SIZE)
        self.assertEqual(rendering.render(SQUARES, "+FN32", **SIZE).values, wanted.values)
        for option in ("+FN32", "+FT32", "+FP32", "+FB32", "+FJ32", "+FH32"):
            with self.subTest(option=option), tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
                code, said = rendering.Job(SQUARES, (option,), **SIZE).attempt(pathlib.Path(name))
                said = re.sub(r"\s+", " ", said)
                self.assertEqual(code, 0, said)
                self.assertEqual(said.count("Bits_Per_Color=32 with a file type other than OpenEXR"), 1, said)

    def test_no_message_elsewhere(self):
        for options in (("+FE32",), ("+FN16",), ("+FN32", "-F")):
            with self.subTest(options=options), tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
                code, said = rendering.Job(SQUARES, options, **SIZE).attempt(pathlib.Path(name))
                self.assertEqual(code, 0, said)
                self.assertNotIn("Bits_Per_Color", said)


if __name__ == "__main__":
    rendering.main()

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Options that leave nothing to render are refused, at once and with the reason."""

import pathlib
import tempfile

from tests.render import rendering, scenes

STOCK = "camera { location -4*z look_at 0 } sphere { 0, 1 pigment { rgb 1 } finish { emission 0.5 } }\n"


def run(scene, *options):
    """Exit code and what POV-Ray said, in a folder of its own; a second run of it would find nothing left behind."""
    with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
        code, said = rendering.Job(scene, options).attempt(pathlib.Path(name))
        return code, said, sorted(path.name for path in pathlib.Path(name).iterdir())


class Refused(rendering.RenderTest):
    """With an aperture, where such options made the program wait for ever, and without the block."""

    def check(self, options, message):
        for scene in (scenes.TILTED, STOCK):
            with self.subTest(options=options, stock=scene is STOCK):
                code, said, files = run(scene, *options)
                self.assertEqual(code, 1, said)
                self.assertEqual(said.count(message), 1, said)
                self.assertEqual(files, ["none.ini", "scene.pov"], said)

    def test_end_before_start(self):
        self.check(("+SC50", "+EC20"), "Start_Column=50 and End_Column=20 mean columns 50 to 20 of 64.")
        self.check(("+SR40", "+ER10"), "Start_Row=40 and End_Row=10 mean rows 40 to 10 of 48.")
        self.check(("+SC0.9", "+EC0.1"), "Start_Column=0.9 and End_Column=0.1 mean columns 58 to 6 of 64.")

    def test_beyond_the_picture(self):
        self.check(("+EC65",), "Start_Column=1 and End_Column=65 mean columns 1 to 65 of 64.")
        self.check(("+SR-3",), "Start_Row=-3 and End_Row=48 mean rows -3 to 48 of 48.")
        self.check(("+ER0.001",), "Start_Row=1 and End_Row=0.001 mean rows 1 to 0 of 48.")

    def test_no_size(self):
        self.check(("+W-5",), "Width=-5 (+W-5). A whole number of at least 1 is allowed")
        self.check(("+H0",), "Height=0 (+H0). A whole number of at least 1 is allowed")

    def test_no_threads(self):
        self.check(("+WT0",), "Work_Threads=0 (+WT0). A whole number of at least 1 is allowed")


class Allowed(rendering.RenderTest):
    """Their neighbours are rendered."""

    def test_limits(self):
        for options in (("+SC64", "+EC64"), ("+SC0.99", "+EC1"), ("+SR48", "+ER48"), ("+SC0", "+EC0.02"), ("+WT1",)):
            with self.subTest(options=options):
                code, said, _ = run(STOCK, *options)
                self.assertEqual(code, 0, said)


if __name__ == "__main__":
    rendering.main()

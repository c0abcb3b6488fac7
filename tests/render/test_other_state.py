# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""+C continues only the render of the state file."""

import pathlib
import shutil
import struct
import tempfile

from tests.render import rendering, scenes
from tools.povray_run import STATE_HEADER, whole_messages

SIZE = {"width": 48, "height": 36}
TABLE = "#declare Red = 0.5;\n"
SCENE = '#include "table.inc"\n' + scenes.camera(samples="blur_samples 4 variance 0 ") + scenes.WORLD
STOCK = '#include "table.inc"\ncamera { ' + scenes.VIEW + "}\n" + scenes.WORLD


def run(folder, scene, *options, **size):
    code, said = rendering.Job(scene, ("+WT1", "+BS8", *options), **{**SIZE, **size}).attempt(folder)
    return code, " ".join(said.split())


class OtherState(rendering.RenderTest):
    def setUp(self):
        self.held = tempfile.TemporaryDirectory(prefix="tilt_lens.")
        self.addCleanup(self.held.cleanup)
        self.folder = pathlib.Path(self.held.name)
        (self.folder / "table.inc").write_text(TABLE)
        self.state = self.folder / "picture.pov-state"
        self.picture = self.folder / "picture.png"

    def begin(self, scene, *options, **size):
        # a folder of the picture's name keeps the state file
        self.picture.mkdir()
        (self.picture / "used").touch()
        code, said = run(self.folder, scene, *options, **size)
        self.assertNotEqual(code, 0, said)
        shutil.rmtree(self.picture)
        data = self.state.read_bytes()
        ends = whole_messages(data)
        self.state.write_bytes(data[: ends[len(ends) // 2]])

    def refused(self, scene, *options, reason, **size):
        before = self.state.read_bytes()
        code, said = run(self.folder, scene, "+C", *options, **size)
        self.assertEqual(code, 1, said)
        self.assertIn("The state file 'picture.pov-state'", said)
        self.assertIn(reason, said)
        self.assertIn("anew without +C", said)
        self.assertEqual(self.state.read_bytes(), before)
        self.assertFalse(self.picture.exists(), said)

    def continued(self, scene, *options, **size):
        code, said = run(self.folder, scene, "+C", *options, **size)
        self.assertEqual(code, 0, said)
        found = rendering.read_picture(self.picture, "continued\n")
        self.picture.unlink()
        self.assertEqual(run(self.folder, scene, *options, **size)[0], 0)
        self.assert_same(found, rendering.read_picture(self.picture, "whole\n"))
        self.picture.unlink()
        return said

    def test_same_render(self):
        self.begin(SCENE)
        self.assertIn("Skipped", self.continued(SCENE, "+WT2"))

    def test_size(self):
        for scene in (SCENE, STOCK):
            self.begin(scene)
            self.refused(scene, width=24, reason="Width was 48 and now is 24")
            self.refused(scene, height=18, reason="Height was 36 and now is 18")
        for size in ({"width": 96}, {"height": 72}):
            self.begin(SCENE)
            self.refused(SCENE, **size, reason="was")
            self.begin(STOCK)
            code, said = run(self.folder, STOCK, "+C", **size)
            self.assertEqual(code, 0, said)
            self.assertIn("Warning: The state file 'picture.pov-state' belongs to another render", said)
            self.picture.unlink()

    def test_options(self):
        self.begin(SCENE, "Declare=A=1")
        for options, reason in (
            (("+Q3", "Declare=A=1"), "Quality was not given and now is 3"),
            (("Declare=A=2",), "Declare A was 1 and now is 2"),
            ((), "its render had Declare A, which now is missing"),
            (("Declare=A=1", "+SR10"), "Start_Row was not given and now is 10"),
            (("Declare=A=1", "+BS16"), "Render_Block_Size was 8 and now is 16"),
        ):
            self.refused(SCENE, *options, reason=reason)
        self.continued(SCENE, "Declare=A=1")

    def test_scene(self):
        self.begin(SCENE)
        self.refused(SCENE + "// edited\n", reason="the contents of file scene.pov have changed")

    def test_include(self):
        self.begin(SCENE)
        (self.folder / "table.inc").write_text("#declare Red = 0.6;\n")
        self.refused(SCENE, reason="the contents of file table.inc have changed")
        (self.folder / "table.inc").write_text(TABLE)
        self.continued(SCENE)

    def test_garbage(self):
        for data in (b"no state file at all", b"x" * 2000):
            self.state.write_bytes(data)
            self.refused(SCENE, reason="is not one of POV-Ray's, or is damaged")
        self.begin(SCENE)
        self.state.write_bytes(self.state.read_bytes()[:STATE_HEADER] + b"x" * 900)
        self.refused(SCENE, reason="is not one of POV-Ray's, or is damaged")

    def test_without_a_key(self):
        self.begin(SCENE)
        data = self.state.read_bytes()
        self.state.write_bytes(data[:STATE_HEADER] + data[whole_messages(data)[1] :])
        self.refused(SCENE, reason="does not say which render it belongs to")

    def test_no_tile_yet(self):
        self.begin(SCENE)
        data = self.state.read_bytes()
        for length in (0, 20, STATE_HEADER, STATE_HEADER + 10, STATE_HEADER + 200):
            self.state.write_bytes(data[:length])
            self.continued(SCENE)

    def test_damaged_tile(self):
        for scene in (SCENE, STOCK):
            self.begin(scene)
            data = self.state.read_bytes()
            at = data.index(b"Righ", whole_messages(data)[2]) + 12
            self.state.write_bytes(data[:at] + struct.pack(">i", 5000) + data[at + 4 :])
            self.continued(scene)

    def test_stock_scene(self):
        self.begin(STOCK)
        code, said = run(self.folder, STOCK + "// edited\n", "+C")
        self.assertEqual(code, 0, said)
        self.assertIn("Warning: The state file 'picture.pov-state' belongs to another render: the contents of file scene.pov", said)
        self.picture.unlink()
        self.begin(STOCK)
        self.assertNotIn("Warning: The state", self.continued(STOCK))


if __name__ == "__main__":
    rendering.main()

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later

import pathlib
import re
import tempfile

from tests.render import rendering, scenes
from tools import povray_run

STOCK = f"camera {{ {scenes.VIEW}aperture 0.3 blur_samples 9 }}\n" + scenes.WORLD
FILM = scenes.camera("film_width 24 shift <3, -2>")
BEFORE = (
    "Tilt Lens\n",
    "Lens....",
    "Focal length....",
    "Film....",
    "angle of view....",
    "Aperture....",
    "Sharp plane",
    "Hinge line....",
    "Sharp on the axis....",
)
AFTER = ("Tilt Lens Sampling\n", "Samples per pixel....", "Standard error....")


class Report(rendering.RenderTest):
    def test_order(self):
        said = rendering.render_and_listen(scenes.TILTED, "-V")[1]
        at = 0
        for word in ("Render Options", "Tilt Lens\n", "Tilt Lens Sampling", "Render Statistics"):
            found = said.find(word, at)
            self.assertGreaterEqual(found, at, f"no '{word}' in its place\n{said}")
            at = found
        for word in BEFORE + AFTER:
            self.assertEqual(said.count(word), 1, f"'{word}' {said.count(word)} times\n{said}")

    def test_silenced(self):
        said = rendering.render_and_listen(scenes.TILTED, "-GA")[1]
        self.assertNotIn("Tilt Lens", said)

    def test_render_stream_alone(self):
        said = rendering.render_and_listen(scenes.TILTED, "-GS")[1]
        self.assertIn("Tilt Lens\n", said)
        self.assertNotIn("Tilt Lens Sampling", said)
        said = rendering.render_and_listen(scenes.TILTED, "-GR")[1]
        self.assertNotIn("Tilt Lens\n", said)
        self.assertIn("Tilt Lens Sampling", said)

    def test_redirected(self):
        with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
            folder = pathlib.Path(name)
            said = rendering.Job(scenes.TILTED, ("-GA", "-GRoptions.txt", "-GSstatistics.txt")).run(folder)
            options, statistics = ((folder / f"{stream}.txt").read_text() for stream in ("options", "statistics"))
        self.assertNotIn("Tilt Lens", said)
        for word in BEFORE:
            self.assertIn(word, options)
        for word in AFTER:
            self.assertIn(word, statistics)

    def test_film(self):
        said = rendering.render_and_listen(FILM + scenes.WORLD)[1]
        self.assertRegex(said, r"Film\.+24 by 18.045 mm, shift <3, -2> mm\n +angle of view\.+45 by 34.6 degrees\n")

    def test_one_thread(self):
        said = rendering.render_and_listen(scenes.TILTED, "+WT1")[1]
        self.assertRegex(said, r"of CPU on 1 thread\n")

    def test_help_lists_own_options(self):
        said = povray_run.run([rendering.SETTINGS.povray, "--help"]).succeeded().said
        for option in ("+N, Output_Layers=on", "+FE32, Bits_Per_Color=32"):
            self.assertIn(option, said)

    def test_no_negative_zeros(self):
        said = rendering.render_and_listen(scenes.camera("") + scenes.WORLD)[1]
        self.assertNotRegex(said, r"(?<![\w.])-0(?![\d.])")

    def test_stock_scenes_have_no_report(self):
        said = rendering.render_and_listen(STOCK)[1]
        self.assertNotRegex(said, re.compile("tilt[ _]lens", re.IGNORECASE))

    def test_samples_and_error(self):
        said = rendering.render_and_listen(scenes.camera(samples="blur_samples 16, 4096 variance 1/2000 ") + scenes.WORLD)[1]
        samples = re.search(r"Samples per pixel\.+mean ([\d.]+), 99% (\d+), most (\d+)", said)
        error = re.search(r"Standard error\.+([\d.e-]+) of white", said)
        self.assertTrue(samples and error, said)
        mean, quantile, most = (float(v) for v in samples.groups())
        self.assertTrue(16 <= mean <= quantile <= most <= 4096, samples[0])
        self.assertLessEqual(float(error[1]), (1 / 2000) ** 0.5, error[0])

    def test_variance_0_takes_all(self):
        said = rendering.render_and_listen(scenes.camera(samples="blur_samples 30 variance 0 ") + scenes.WORLD)[1]
        self.assertIn("mean 30.0, 99% 30, most 30", said)

    def test_one_sample_gives_no_error(self):
        for variance in "0", "1/1000":
            said = rendering.render_and_listen(scenes.camera(samples=f"blur_samples 1, 1 variance {variance} ") + scenes.WORLD)[1]
            self.assertIn("Standard error.......unknown", said)

    def test_anti_aliasing_warns_once(self):
        said = rendering.render_and_listen(scenes.TILTED, "+A0.3", "+WT2")[1]
        self.assertEqual(said.count("Anti-aliasing (+A) adds nothing"), 1, said)


if __name__ == "__main__":
    rendering.main()

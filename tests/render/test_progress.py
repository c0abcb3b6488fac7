# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later

import pathlib
import re
import signal
import tempfile

from tests.render import rendering, scenes

# fewest samples in the sky, hundreds on the floor
HALVES = (
    "camera { location y look_at <0, 1, 1> right 4/3*x angle 60 aperture 0.5 focal_point <0, 1, 9> "
    "blur_samples 8, 256 variance 1/20000 tilt_lens {} }\n"
    "plane { y, 0 pigment { checker rgb 0 rgb 1 scale 0.3 } finish { emission 1 diffuse 0 } }\n"
    "background { rgb <0.3, 0.5, 0.8> }\n"
)
SIZE = {"width": 128, "height": 96}
MESSAGE = re.compile(r"Rendered (\d+) of (\d+) pixels \((\d+)% of the work\)")


def shown(said):
    return [(int(done), int(percent)) for done, _, percent in MESSAGE.findall(said)]


class Progress(rendering.RenderTest):
    def test_counts_the_work(self):
        said = rendering.render_and_listen(HALVES, "+WT1", "+BS16", "+V", **SIZE)[1]
        messages = shown(said)
        self.assertGreater(len(messages), 20, said)
        half = [percent for pixels, percent in messages if pixels == 128 * 96 // 2]
        self.assertTrue(half, said)
        self.assertLess(half[0], 12, f"half of the pixels: {half[0]} %\n{said}")
        self.assertEqual(messages[-1], (128 * 96, 100), said)

    def test_never_falls(self):
        for options in (("+WT2", "+BS8"), ("+WT4", "+BS16", "+RP3"), ("+WT1", "+SP16", "+EP4")):
            with self.subTest(options=options):
                said = rendering.render_and_listen(HALVES, *options, "+V", **SIZE)[1]
                percentages = [percent for _, percent in shown(said)]
                self.assertEqual(percentages, sorted(percentages), said)
                self.assertEqual(percentages[-1], 100, said)

    def test_other_way_round(self):
        said = rendering.render_and_listen(HALVES.replace("right 4/3*x", "right 4/3*x sky -y"), "+WT1", "+BS16", "+V", **SIZE)[1]
        half = [percent for pixels, percent in shown(said) if pixels == 128 * 96 // 2]
        self.assertGreater(half[0], 88, said)

    def test_sub_image(self):
        said = rendering.render_and_listen(HALVES, "+V", "+SR41", "+ER77", "+SC3", "+EC100", **SIZE)[1]
        self.assertEqual(shown(said)[-1][1], 100, said)

    def test_other_pictures_show_pixels(self):
        for scene in (f"camera {{ {scenes.VIEW} }}\n", f"camera {{ {scenes.VIEW} tilt_lens {{}} }}\n"):
            said = rendering.render_and_listen(scene + scenes.WORLD, "+V")[1]
            self.assertRegex(said, r"Rendered \d+ of \d+ pixels \(100%\)")
            self.assertEqual(shown(said), [])

    def test_quiet_without_verbose(self):
        self.assertEqual(shown(rendering.render_and_listen(HALVES, "-V", **SIZE)[1]), [])

    def test_focus_aids_and_radiosity(self):
        """Pixels count: aids take one ray each, and test rays would change radiosity."""
        radiosity = "global_settings { radiosity { count 8 pretrace_start 0.2 pretrace_end 0.1 } }\n"
        for scene in (scenes.camera("focus_map") + scenes.WORLD, radiosity + HALVES):
            messages = shown(rendering.render_and_listen(scene, "+V", "+BS16", "+WT1", **SIZE)[1])
            self.assertTrue(messages)
            self.assertEqual([percent for _, percent in messages], [100 * i // 48 for i in range(1, 49)])

    def test_before_the_first_tile(self):
        """The search for lamps, and the trials for a budget."""
        scene = scenes.camera("scene_unit 100 budget 16", 2, "") + scenes.UNKNOWN_LIGHTS + scenes.painted()
        said = rendering.render_and_listen(scene, "+WT2", "+V", **SIZE)[1]
        searched = re.findall(r"Searching for lamps \((\d+)%\)", said)
        tried = re.findall(r"Choosing the variance for the budget \((\d+)%\)", said)
        for told in (list(map(int, searched)), list(map(int, tried))):
            self.assertGreater(len(told), 5, said)
            self.assertEqual(told, sorted(told), said)
            self.assertGreater(told[-1], 85, said)
        self.assertLess(said.rindex("Searching for"), said.index("Choosing the variance"))
        self.assertLess(said.rindex("Choosing the variance"), said.index("Rendered"))

    def test_continued(self):
        with tempfile.TemporaryDirectory(prefix="tilt_lens.") as name:
            folder = pathlib.Path(name)
            scene = HALVES.replace("sky -y", "").replace("8, 256 variance 1/20000", "600 variance 0")
            rendering.Job(scene, ("+WT1", "+BS8"), **SIZE).stop(folder, signal.SIGKILL, 100_000)
            said = rendering.Job(scene, ("+WT1", "+BS8", "+C", "+V"), **SIZE).run(folder)
        first = shown(said)[0][1]
        self.assertGreater(first, 15, said)
        self.assertEqual(shown(said)[-1][1], 100, said)
        skipped = re.search(r"Skipped\.+(\d+) pixels, done before the render was continued", said)
        self.assertIsNotNone(skipped, said)
        self.assertGreater(shown(said)[0][0], int(skipped[1]), said)
        self.assertEqual(shown(said)[-1][0], 128 * 96, said)
        rendered = re.search(r"^Pixels: +(\d+)", said, re.MULTILINE)
        self.assertEqual(int(skipped[1]) + int(rendered[1]), 128 * 96, said)


class Summary(rendering.RenderTest):
    def test_numbers_agree_with_the_statistics(self):
        said = rendering.render_and_listen(HALVES, "+WT2", **SIZE)[1]
        spent = re.search(r"Time\.+([\d.]+) seconds, ([\d.]+) of CPU on 2 threads", said)
        self.assertIsNotNone(spent, said)
        trace = re.search(r"Trace Time: .*\(([\d.]+) seconds\)\s+using 2 thread\(s\) with ([\d.]+) CPU", said)
        self.assertEqual(spent.groups(), trace.groups(), said)
        rays = re.search(r"Rays\.+(\d+), and (\d+) tests for shadow", said)
        self.assertIsNotNone(rays, said)
        self.assertEqual(rays[1], re.search(r"^Rays: +(\d+)", said, re.MULTILINE)[1], said)
        self.assertGreater(int(rays[1]), 8 * 128 * 96)

    def test_error_and_target(self):
        said = rendering.render_and_listen(HALVES, **SIZE)[1]
        self.assertRegex(said, r"Standard error\.+[\d.e-]+ of white \(estimated\), 0\.0071 asked for")
        said = rendering.render_and_listen(HALVES.replace("variance 1/20000", "variance 0").replace("8, 256", "9"), **SIZE)[1]
        self.assertRegex(said, r"of white \(estimated\), all samples asked for")

    def test_what_was_left_out(self):
        said = rendering.render_and_listen(HALVES.replace("8, 256", "8, 32"), **SIZE)[1]
        stopped = re.search(r"Stopped by MAX\.+(\d+) pixels \(([\d.]+)%\), at 32 samples", said)
        self.assertIsNotNone(stopped, said)
        self.assertAlmostEqual(100 * int(stopped[1]) / (128 * 96), float(stopped[2]), delta=0.06 * float(stopped[2]))
        samples = int(re.search(r"Samples: +(\d+)", said)[1])
        self.assertLessEqual(int(stopped[1]) * 32, samples)
        self.assertLessEqual(samples, int(stopped[1]) * 32 + (128 * 96 - int(stopped[1])) * 16)
        said = rendering.render_and_listen(HALVES.replace("variance 1/20000", "variance 1e-12").replace("8, 256", "4"), **SIZE)[1]
        self.assertRegex(said, r"Stopped by MAX\.+12288 pixels \(100%\), at 4 samples")
        for scene in (HALVES.replace("variance 1/20000", "variance 0"), HALVES.replace("variance 1/20000", "variance 1")):
            said = rendering.render_and_listen(scene, **SIZE)[1]
            self.assertNotRegex(said, r"Stopped by MAX|Skipped\.")


if __name__ == "__main__":
    rendering.main()

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""In random scenes, the default settings have no more error than fixed sampling with as many rays.

test_fixed_sampling.py --povray PROGRAM --compare TOOL [--scenes COUNT] [--seeds COUNT] [--scene NUMBER | --show NUMBER]

Pictures d and f share their first samples; R is an independent unbiased reference, whose noise mostly cancels in the sum of
(d - R)^2 - (f - R)^2. The excess is this sum over that of (d - R)^2 + (f - R)^2: positive if the default is worse.
The margin is Student's quantile times the standard error from the seeds and from R's noise. For equal errors, any scene fails with
probability 1 % (Sidak)."""

import argparse
import concurrent.futures
import math
import random
import re
import statistics
import sys

from tests.render import rendering, scenes
from tests.stress.pictures import students_quantile

WIDTH, HEIGHT = 64, 48
REFERENCE_SEEDS = (101, 102)
LEAST_REFERENCE, FINER = 512, 10  # samples of each picture of a reference: the least, and how many for each compared ray
CHANCE = 1e-2  # probability that any scene fails by chance
WHITE = 0.9  # brighter pixels are left out
SETTINGS = argparse.Namespace(scenes=4, seeds=8, scene=None, show=None, told=False)


def lamp(r, aperture, mirrored):
    z = r.uniform(28, 50) if mirrored else r.choice((r.uniform(-5, -1), r.uniform(1, 25)))
    far = (z + 10) / 10
    blur = aperture * abs(z) / (z + 10) * WIDTH / 7.28  # pixels
    pixels = math.exp(r.uniform(math.log(0.25), math.log(2)))
    emission = math.exp(r.uniform(math.log(0.05), math.log(0.8))) * max(1.0, (blur / pixels) ** 2)
    x, y, radius = 3.6 * far * r.uniform(-1, 1), 2.7 * far * r.uniform(-1, 1), pixels / 2 * 7.28 / WIDTH * far
    green, blue = r.uniform(0.3, 1), r.uniform(0.3, 1)
    look = f"pigment {{ rgb <1, {green:.3f}, {blue:.3f}> }} finish {{ emission {emission:.5g} diffuse 0 ambient 0 }}"
    if not mirrored and r.random() < 0.7:
        look = scenes.unknown_glow(emission, green * emission, blue * emission)
    return f"sphere {{ <{x:.4f}, {y:.4f}, {16 - z if mirrored else z:.4f}>, {radius:.6f} {look} }}\n"


def edge(r):
    return (
        f"box {{ <0, -9, 0>, <{r.uniform(0.3, 4):.3f}, 9, 0.02> pigment {{ rgb {r.uniform(0, 0.5):.3f} }} finish {{ emission 1 diffuse 0 }}"
        f" rotate {r.uniform(0, 360):.2f}*z translate <{r.uniform(-3, 3):.3f}, {r.uniform(-2, 2):.3f}, {r.uniform(-6, 0.9):.3f}> }}\n"
    )


def world(number):
    r = random.Random(number)
    aperture, mirrored = r.uniform(0.5, 3), r.random() < 0.3
    wall = (
        f"box {{ <-30, -30, {8 if mirrored else 40}>, <30, 30, 41> pigment {{ rgb {r.uniform(0, 0.2):.3f} }}"
        f" finish {{ emission 1 diffuse 0 {'reflection 0.9' if mirrored else ''} }} }}\n"
    )
    lamps = "".join(lamp(r, aperture, mirrored) for _ in range(r.randint(1, 24)))
    return wall + scenes.UNKNOWN_LIGHTS + lamps + "".join(edge(r) for _ in range(r.randint(0, 3))), aperture


def scene(number, seed, samples=""):
    things, aperture = world(number)
    return (
        f"camera {{ right x*image_width/image_height location -10*z look_at 0 angle 40 focal_point 0 aperture {aperture:.4f}"
        f" {samples} tilt_lens {{ sample_seed {seed} }} }}\n{things}"
    )


def picture(number, seed, samples=""):
    made, said = rendering.render_and_listen(scene(number, seed, samples), "+WT1", width=WIDTH, height=HEIGHT, extension="exr")
    rays = float(re.search(r"Samples per pixel\D+([\d.]+)", said).group(1))
    return [value for name in "RGB" for value in made.channel(name)], rays


class Reference:
    def __init__(self, number, rays):
        samples = max(LEAST_REFERENCE, FINER * rays)
        one, two = (picture(number, seed, f"blur_samples {samples}, {samples} variance 0")[0] for seed in REFERENCE_SEEDS)
        self.kept = [i for i, (a, b) in enumerate(zip(one, two)) if a + b < 2 * WHITE]
        self.truth = [(one[i] + two[i]) / 2 for i in self.kept]
        self.noise = [((one[i] - two[i]) / 2) ** 2 for i in self.kept]

    def shown(self, values):
        return [min(1.0, values[i]) for i in self.kept]

    def error(self, values):
        return statistics.fmean((a - b) ** 2 - noise for a, b, noise in zip(self.shown(values), self.truth, self.noise))

    def excess(self, values, others):
        pairs = list(zip(self.shown(values), self.shown(others), self.truth, self.noise))
        difference = sum((a - b) * (a + b - 2 * truth) for a, b, truth, _ in pairs)
        scale = sum((a - truth) ** 2 + (b - truth) ** 2 for a, b, truth, _ in pairs)
        return (difference / scale, sum(4 * (a - b) ** 2 * noise for a, b, _, noise in pairs) / scale**2) if scale > 0.0 else (0.0, 0.0)


class Excess:
    def __init__(self, reference, pictures, others, tests):
        excesses, given = zip(*map(reference.excess, pictures, others))
        self.errors = [statistics.fmean(map(reference.error, made)) for made in (pictures, others)]
        self.mean = statistics.fmean(excesses)
        count = len(excesses)
        # all seeds share the reference, so its part does not average out
        by_seeds, by_reference = statistics.variance(excesses) / count, statistics.fmean(given)
        variance = by_seeds + by_reference
        freedom = (count - 1) * (variance / by_seeds) ** 2 if by_seeds > 0.0 else math.inf
        self.margin = students_quantile((1 - CHANCE) ** (1 / tests), min(freedom, 1000.0)) * math.sqrt(variance)

    @property
    def is_found(self):
        return self.mean > self.margin

    def told(self):
        one, other = self.errors
        return f"MSE {one:.3g} against {other:.3g}, excess {self.mean:+.3f} with a margin of {self.margin:.3f}"


def seeds():
    return range(1, SETTINGS.seeds + 1)


def evenly(number, samples):
    return [picture(number, seed, f"blur_samples {samples}, {samples}")[0] for seed in seeds()]


def compare(number, tests):
    default, rays = zip(*[picture(number, seed) for seed in seeds()])
    samples = max(1, int(statistics.fmean(rays)))
    found = Excess(Reference(number, samples), default, evenly(number, samples), tests)
    return found, f"scene {number}, {statistics.fmean(rays):.1f} rays a pixel against {samples}: {found.told()}"


class FixedSampling(rendering.RenderTest):
    def test_default_settings_have_no_more_error(self):
        numbers = [SETTINGS.scene] if SETTINGS.scene is not None else range(1, SETTINGS.scenes + 1)
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            found = list(pool.map(lambda number: compare(number, SETTINGS.scenes), numbers))
        if SETTINGS.told:
            print("\n".join(words for _, words in found))
        worse = [words for excess, words in found if excess.is_found]
        self.assertFalse(
            worse,
            "more error than fixed sampling with as many rays:\n"
            + "\n".join(worse)
            + "\nA scene's text: add --show NUMBER to the command of this test",
        )

    def test_the_comparison_finds_an_eighth_of_the_rays(self):
        found = Excess(Reference(1, 16), evenly(1, 2), evenly(1, 16), SETTINGS.scenes)
        self.assertTrue(found.is_found, found.told())


def main():
    parser = argparse.ArgumentParser(add_help=False)
    parser.add_argument("--scenes", type=int, default=SETTINGS.scenes)
    parser.add_argument("--seeds", type=int, default=SETTINGS.seeds)
    parser.add_argument("--scene", type=int, help="this one alone, with the margin of so many scenes")
    parser.add_argument("--show", type=int)
    parser.add_argument("--told", action="store_true", help="print all comparisons")
    _, sys.argv[1:] = parser.parse_known_args(namespace=SETTINGS)
    if SETTINGS.show is not None:
        print(rendering.HEAD + scene(SETTINGS.show, 1))
    else:
        rendering.main()


if __name__ == "__main__":
    main()

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Prints whether a picture's noise prefers directions, or periods of 16 pixels, the sampler's blocks.

python3 run_module.py tests.tools.error_direction --compare build/tests/tools/compare FIRST.png SECOND.png

FIRST and SECOND have two values of `sample_seed`: their difference has the spectrum of the noise, times two."""

import argparse

import numpy

from tests.render import rendering

SIDE = 64  # of the windows whose spectra are averaged, in pixels
STEP = SIDE // 2
PERIOD = 16  # pixels: side of a block
LEAST = 1 / 16  # cycles per pixel: the eye takes slower changes for shades
HALF_SECTOR = 15  # degrees
FREQUENCY = numpy.fft.fftfreq(SIDE)


def values_of(picture):
    values = numpy.array(picture.values).reshape(picture.height, picture.width, len(picture.names))
    return numpy.clip(values[..., [picture.names.index(name) for name in "RGB"]], 0, 1)


def spectrum(difference):
    taper = 0.5 - 0.5 * numpy.cos(2 * numpy.pi * (numpy.arange(SIDE) + 0.5) / SIDE)
    window = numpy.outer(taper, taper)[..., None]
    height, width = difference.shape[:2]
    if min(height, width) < SIDE:
        raise ValueError(f"a picture of {width} by {height} pixels: at least {SIDE} by {SIDE} are needed")
    return sum(
        (abs(numpy.fft.fft2(window * difference[y : y + SIDE, x : x + SIDE], axes=(0, 1))) ** 2).sum(axis=2)
        for y in range(0, height - SIDE + 1, STEP)
        for x in range(0, width - SIDE + 1, STEP)
    )


def axes_over_diagonals(power):
    down, across = numpy.meshgrid(FREQUENCY, FREQUENCY, indexing="ij")
    radius = numpy.hypot(down, across)
    angle = numpy.degrees(numpy.arctan2(abs(down), abs(across)))
    ring = (radius >= LEAST) & (radius < 0.5)
    near_axis = numpy.minimum(angle, 90 - angle) <= HALF_SECTOR
    near_diagonal = abs(angle - 45) <= HALF_SECTOR
    return power[ring & near_axis].mean() / power[ring & near_diagonal].mean()


def blocks_over_surroundings(power):
    first = SIDE // PERIOD
    lines = numpy.arange(first, SIDE // 2, first)
    slow = abs(FREQUENCY) < LEAST
    both = (power[slow], power[:, slow].T)
    at_lines = sum(part[:, lines].sum() for part in both)
    between = sum(part[:, lines + shift].sum() for part in both for shift in (-first // 2, first // 2)) / 2
    return at_lines / between


def figures(first, second):
    """Ratios; 1 means no preference."""
    power = spectrum(values_of(first) - values_of(second))
    return axes_over_diagonals(power), blocks_over_surroundings(power)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--compare", required=True, help="the comparison tool of the tests, which decodes pictures")
    parser.add_argument("first")
    parser.add_argument("second")
    arguments = parser.parse_args()
    rendering.SETTINGS.compare = arguments.compare
    try:
        axes, blocks = figures(*(rendering.read_picture(path, path) for path in (arguments.first, arguments.second)))
    except (rendering.UnreadablePicture, ValueError) as error:
        parser.exit(1, f"{error}\n")
    print(f"power along rows and columns over diagonals {axes:.2f}, at periods of {PERIOD} pixels {blocks:.2f}")


if __name__ == "__main__":
    main()

// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/kernels/variant.h"
#include "tilt_lens/samples/lens_sampler.h"
#include "tilt_lens/samples/scramble.h"
#include "tilt_lens/samples/sequence.h"

namespace tilt_lens::TILT_LENS_VARIANT
{

namespace
{

/// Written as a loop that compilers vectorise.
TILT_LENS_INLINED void FindCoordinates(std::uint32_t first, std::uint32_t seed, const std::uint32_t* steps, double* coordinates)
{
    for (std::uint32_t i = 0; i < Settings::cameraRaysOfBatch; ++i)
        coordinates[i] = ToUnit(ReverseBits(Scramble(first ^ steps[i], seed)));
}

} // namespace

void FindPoints(const std::uint32_t* first, const std::uint32_t* seeds, const GroupTable& steps, SequencePoints& points)
{
    FindCoordinates(first[0], seeds[0], steps.value[0], points.lensU);
    FindCoordinates(first[1], seeds[1], steps.value[1], points.lensV);
    FindCoordinates(first[2], seeds[2], steps.value[2], points.pixelX);
    FindCoordinates(first[3], seeds[3], steps.value[3], points.pixelY);
}

void FindFilmPoints(double column, double row, double width, double height, const Quads& quads, const SequencePoints& points,
                    CameraSamples& samples)
{
    for (std::uint32_t i = quads.begin; i < quads.end; i += kVectorWidth<Doubles>)
    {
        Store(samples.x + i, (column + Load<Doubles>(points.pixelX + i)) / width - 0.5);
        Store(samples.y + i, 0.5 - (row + Load<Doubles>(points.pixelY + i)) / height);
        Store(samples.weight + i, Doubles() + 1.0);
        Store(samples.overPlain + i, Doubles() + 1.0);
        Store(samples.expectedEmission + i, Doubles());
    }
}

} // namespace tilt_lens::TILT_LENS_VARIANT

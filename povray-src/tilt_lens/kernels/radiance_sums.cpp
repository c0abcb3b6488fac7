// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/kernels/variant.h"
#include "tilt_lens/sampling/sample.h"

namespace tilt_lens::TILT_LENS_VARIANT
{

namespace
{

static_assert(sizeof(Radiance) == 5 * sizeof(double), "a vector or two of four channels, and one channel");

/// Keeps channels from number `first` on in registers.
template<class Channels>
struct ChannelSums
{
    Channels sum, squares;

    TILT_LENS_INLINED void Get(const double* allSum, const double* allSquares, std::size_t first)
    {
        sum = Load<Channels>(allSum + first), squares = Load<Channels>(allSquares + first);
    }
    TILT_LENS_INLINED void Put(double* allSum, double* allSquares, std::size_t first) const
    {
        Store(allSum + first, sum), Store(allSquares + first, squares);
    }
    TILT_LENS_INLINED void Add(const Channels& x)
    {
        sum += x;
        squares += x * x;
    }
};

} // namespace

bool AddRadiances(const SampleResult* results, std::uint32_t count, double* sum, double* allSquares, double& greatestEmission)
{
    constexpr std::size_t lanes = kVectorWidth<Doubles>, vectors = 4 / lanes;
    ChannelSums<Doubles> four[vectors];
    ChannelSums<double> last;
    for (std::size_t k = 0; k < vectors; k++)
        four[k].Get(sum, allSquares, k * lanes);
    last.Get(sum, allSquares, 4);
    double expectedEmission = 0.0;
    for (const SampleResult* result = results; result < results + count; result++)
    {
        const double* const radiance = reinterpret_cast<const double*>(&result->radiance);
        for (std::size_t k = 0; k < vectors; k++)
            four[k].Add(Load<Doubles>(radiance + k * lanes));
        last.Add(radiance[4]);
        expectedEmission = result->expectedEmission > expectedEmission ? result->expectedEmission : expectedEmission;
    }
    // a finite sum of squares has only finite terms
    double squares = last.squares;
    for (std::size_t k = 0; k < 4; k++)
        squares += four[k / lanes].squares[k % lanes];
    if (!IsFinite(squares))
        return false;
    for (std::size_t k = 0; k < vectors; k++)
        four[k].Put(sum, allSquares, k * lanes);
    last.Put(sum, allSquares, 4);
    greatestEmission = expectedEmission;
    return true;
}

} // namespace tilt_lens::TILT_LENS_VARIANT

// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include <cfloat>

#include "tilt_lens/kernels/variant.h"
#include "tilt_lens/stop_rule/pixel_statistics.h"

namespace tilt_lens::TILT_LENS_VARIANT
{

namespace
{

static_assert(sizeof(Radiance) == 5 * sizeof(double), "a vector or two of four channels, and one channel");

typedef float FewFloats __attribute__((vector_size(TILT_LENS_REGISTER / 2)));

template<class Channels>
TILT_LENS_INLINED Channels FromFloats(const float* from)
{
    if constexpr (std::is_same_v<Channels, double>)
        return *from;
    else
        return __builtin_convertvector(Load<FewFloats>(from), Channels);
}

template<class Channels>
TILT_LENS_INLINED void ToFloats(float* to, const Channels& value)
{
    if constexpr (std::is_same_v<Channels, double>)
        *to = float(value);
    else
        Store(to, __builtin_convertvector(value, FewFloats));
}

struct Batch
{
    bool emitters;
    double before, count;
};

/// Keeps channels from number `first` on in registers.
template<class Channels>
struct ChannelSums
{
    Channels shift;  ///< the stratum's mean before, or first sample
    Channels firstSum, sum, squares;  ///< squares of differences from `shift`

    TILT_LENS_INLINED void Begin(const PixelSums& pixel, const Batch& batch, const double* radiance, std::size_t first)
    {
        const Channels emitterMean = FromFloats<Channels>(pixel.emitterMean + first);
        const Channels all = Load<Channels>(pixel.sum[0] + first) + Load<Channels>(pixel.sum[1] + first);
        if (batch.before == 0.0)
            shift = Load<Channels>(radiance + first);
        else if (batch.emitters)
            shift = emitterMean;
        else
            shift = (all - double(pixel.emitterSamples) * emitterMean) / batch.before;
        firstSum = sum = squares = Channels{};
    }

    TILT_LENS_INLINED void Add(const double* radiance, std::size_t first)
    {
        const Channels x = Load<Channels>(radiance + first), difference = x - shift;
        sum += x;
        squares += difference * difference;
    }

    TILT_LENS_INLINED void EndFirstBuffer()
    {
        firstSum = sum;
        sum = Channels{};
    }

    TILT_LENS_INLINED void Put(PixelSums& pixel, const Batch& batch, std::size_t first) const
    {
        const Channels greatest = Channels{} + double(FLT_MAX), deviation = FromFloats<Channels>(pixel.deviation + first);
        const Channels differences = firstSum + sum - batch.count * shift, shiftOfMean = differences / (batch.before + batch.count);
        const Channels all = double(pixel.samples) * (deviation * deviation) + (squares - differences * shiftOfMean);
        const Channels variance = all / (pixel.samples + batch.count), notNegative = variance < 0.0 ? Channels{} : variance;
        ToFloats<Channels>(pixel.deviation + first, Min<Channels>(SquareRoot(notNegative), greatest));  // also if NaN
        if (batch.emitters)
            ToFloats<Channels>(pixel.emitterMean + first, Clamp<Channels>(shift + shiftOfMean, -greatest, greatest));
        Store(pixel.sum[0] + first, Load<Channels>(pixel.sum[0] + first) + firstSum);
        Store(pixel.sum[1] + first, Load<Channels>(pixel.sum[1] + first) + sum);
    }
};

struct AllSums
{
    static constexpr std::size_t kLanes = kVectorWidth<Doubles>, kVectors = 4 / kLanes;
    ChannelSums<Doubles> four[kVectors];
    ChannelSums<double> last;

    template<class Function>
    TILT_LENS_INLINED void ForEach(const Function& function)
    {
        for (std::size_t k = 0; k < kVectors; k++)
            function(four[k], k * kLanes);
        function(last, 4);
    }

    TILT_LENS_INLINED bool AreFinite() const
    {
        double zero = 0.0 * (last.firstSum + last.sum);
        for (std::size_t k = 0; k < 4; k++)
            zero += 0.0 * (four[k / kLanes].firstSum + four[k / kLanes].sum)[k % kLanes];
        return IsFinite(zero);
    }
};

} // namespace

bool AddRadiances(const SampleResult* results, std::uint32_t ofFirstBuffer, std::uint32_t count, bool emitters, PixelSums& pixel)
{
    const SampleResult *const middle = results + ofFirstBuffer, *const end = results + count;
    const auto isOther = [&](const SampleResult* result) TILT_LENS_INLINED_LAMBDA { return (result->expectedEmission > 0.0) != emitters; };
    const auto radiance = [&]() TILT_LENS_INLINED_LAMBDA { return reinterpret_cast<const double*>(&results->radiance); };
    while (results < end && isOther(results))
        results++;
    if (results == end)
        return true;
    Batch batch{emitters, double(emitters ? pixel.emitterSamples : pixel.samples - pixel.emitterSamples), 0.0};
    AllSums sums;
    sums.ForEach([&](auto& channels, std::size_t first) TILT_LENS_INLINED_LAMBDA { channels.Begin(pixel, batch, radiance(), first); });
    double expectedEmission = 0.0;
    const auto addUntil = [&](const SampleResult* until) TILT_LENS_INLINED_LAMBDA
    {
        for (; results < until; results++)
        {
            if (isOther(results))
                continue;
            sums.ForEach([&](auto& channels, std::size_t first) TILT_LENS_INLINED_LAMBDA { channels.Add(radiance(), first); });
            batch.count += 1.0;
            expectedEmission = results->expectedEmission;
        }
    };
    addUntil(middle);
    sums.ForEach([](auto& channels, std::size_t) TILT_LENS_INLINED_LAMBDA { channels.EndFirstBuffer(); });
    addUntil(end);
    if (!sums.AreFinite())
        return false;
    sums.ForEach([&](auto& channels, std::size_t first) TILT_LENS_INLINED_LAMBDA { channels.Put(pixel, batch, first); });
    pixel.samples += std::uint32_t(batch.count);
    pixel.emitterSamples += emitters ? std::uint32_t(batch.count) : 0;
    pixel.expectedEmission = emitters ? float(expectedEmission) : pixel.expectedEmission;
    return true;
}

} // namespace tilt_lens::TILT_LENS_VARIANT

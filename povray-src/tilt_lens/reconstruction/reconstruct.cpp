// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/reconstruction/reconstruction.h"

#include "tilt_lens/math/kernels.h"
#include "tilt_lens/reconstruction/filter_input.h"

namespace tilt_lens
{

namespace
{

FilterInput InputOf(const PaddedBlock& around, const Settings& settings, const Rows& rows, const SpreadInput* spread)
{
    FilterInput input{{},
                      around.Noise().data(),
                      around.Missed().data(),
                      around.Samples().data(),
                      around.IsTransparent() ? 5 : 3,
                      rows.begin,
                      rows.end,
                      spread,
                      settings};
    for (int c = 0; c < 5; c++)
        input.mean[c] = around.Mean(c).data();
    return input;
}

SpreadInput InputOf(const PaddedSpread& spread)
{
    return {{spread.mean[0].data(), spread.mean[1].data(), spread.mean[2].data()},
            spread.variance.data(),
            spread.share.data(),
            spread.samples.data(),
            spread.ownShare.data(),
            spread.ownWeight.data()};
}

FilterOutput OutputTo(ReconstructedBlock& block)
{
    FilterOutput output{{}, block.residualVarianceBound.data(), block.residualVarianceRatio.data(), &block.risk};
    for (int c = 0; c < 5; c++)
        output.mean[c] = block.mean[c].data();
    return output;
}

} // namespace

Radiance ReconstructedBlock::MeanOf(std::size_t pixel) const
{
    Radiance light;
    for (std::size_t c = 0; c < light.size(); c++)
        light[c] = mean[c][pixel];
    return light;
}

ReconstructedBlock Reconstruct(const PaddedBlock& around, const Settings& settings, const PaddedSpread* spread, const Rows& rows)
{
    const SpreadInput spreadInput = spread != nullptr ? InputOf(*spread) : SpreadInput{};
    ReconstructedBlock block{};
    kernels->filterBlock(InputOf(around, settings, rows, spread != nullptr ? &spreadInput : nullptr), OutputTo(block));
    return block;
}

ReconstructedBlock SpreadEstimates(const PaddedBlock& around, const Settings& settings, const PaddedSpread& spread)
{
    const SpreadInput spreadInput = InputOf(spread);
    ReconstructedBlock block{};
    kernels->estimateSpread(InputOf(around, settings, kAllRows, &spreadInput), OutputTo(block));
    return block;
}

} // namespace tilt_lens

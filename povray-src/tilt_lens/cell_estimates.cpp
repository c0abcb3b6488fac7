// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file cell_estimates.cpp
/// What a cell tells the reconstruction of its pixels, and what it may expect of it.

#include "cell.h"

#include <algorithm>

namespace tilt_lens
{

namespace
{

/// Whether a pixel's noise is less than half of its brightness.
bool IsKnown(const Estimate& estimate)
{
    double noise = 0.0, light = 0.0;
    for (std::size_t c = 0; c < estimate.mean.size(); c++)
    {
        noise += estimate.variance[c];
        light += double(estimate.mean[c]) * estimate.mean[c];
    }
    return noise <= 0.25 * light;
}

} // namespace

/// Takes from the variances of pixels what the reconstruction will take: of what their own samples
/// show, not of what is only feared because neighbours saw it.
void Cell::CreditReconstruction(const Neighbours& neighbours, std::vector<Judged>& judged) const
{
    const std::vector<Estimate> estimates = Estimates();
    const auto credited = [&](const Judged& one, std::size_t c, double share)
    {
        const Estimate& estimate = estimates[one.pixel - pixels.data()];
        // a few hits of something bright say little of how often it is hit
        if (!IsKnown(estimate))
            return one.variance[c];
        const double seen = estimate.variance[c] / Brightness(estimate.mean[c]);
        return one.variance[c] - share * std::min(seen, one.variance[c]);
    };
    // only where it makes a difference
    const bool matters = std::any_of(judged.begin(), judged.end(), [&](const Judged& one)
    {
        bool good = true, canBeGood = true;
        for (std::size_t c = 0; c < one.variance.size(); c++)
        {
            good = good && one.variance[c] <= one.allowed;
            canBeGood = canBeGood && credited(one, c, 1.0 - kLeastRemains) <= one.allowed;
        }
        return !good && canBeGood;
    });
    if (!matters)
        return;
    const std::array<float, kCell * kCell> remains = Remains(neighbours, estimates);
    for (Judged& one : judged)
    {
        const std::size_t i = one.pixel - pixels.data();
        const double share = 1.0 - remains[i / area.width * kCell + i % area.width];
        for (std::size_t c = 0; c < one.variance.size(); c++)
            one.variance[c] = credited(one, c, share);
    }
}

/// What is known of the pixels, for the reconstruction: the variance of the mean from the samples of a
/// pixel and of those around it in the cell.
std::vector<Estimate> Cell::Estimates() const
{
    std::vector<Estimate> estimates(pixels.size());
    std::vector<Radiance> spread;
    for (const Pixel& pixel : pixels)
        spread.push_back(Spread(pixel));
    for (std::uint32_t y = 0; y < area.height; y++)
        for (std::uint32_t x = 0; x < area.width; x++)
        {
            Radiance sum{};
            int count = 0;
            for (std::uint32_t v = y == 0 ? 0 : y - 1; v <= y + 1 && v < area.height; v++)
                for (std::uint32_t u = x == 0 ? 0 : x - 1; u <= x + 1 && u < area.width; u++, count++)
                    AddTo(sum, spread[v * area.width + u]);
            const Pixel& pixel = pixels[y * area.width + x];
            const Radiance mean = MeanOf(pixel);
            Estimate& estimate = estimates[y * area.width + x];
            estimate.samples = pixel.samples;
            for (std::size_t c = 0; c < sum.size(); c++)
            {
                estimate.mean[c] = mean[c];
                estimate.variance[c] = pixel.gain * sum[c] / count / pixel.samples;
                if (pixel.samples > 1)
                    estimate.halves[c] = pixel.half[0][c] / pixel.middle - pixel.half[1][c] / (pixel.samples - pixel.middle);
            }
        }
    return estimates;
}

/// What share of the pixels' variances the reconstruction will leave, as far as the first samples of
/// the neighbours tell.
std::array<float, kCell * kCell> Cell::Remains(const Neighbours& neighbours, const std::vector<Estimate>& own) const
{
    Surroundings around;
    for (int y = -Surroundings::kBorder; y < int(kCell) + Surroundings::kBorder; y++)
        for (int x = -Surroundings::kBorder; x < int(kCell) + Surroundings::kBorder; x++)
        {
            const std::int64_t u = std::int64_t(area.left) + x, v = std::int64_t(area.top) + y;
            const Cell* holder = Holder(neighbours, u, v);
            if (holder == this)
                around.Set(x, y, own[Index(u, v)]);
            else if (holder != nullptr && holder->area.Has(u, v))
                around.Set(x, y, holder->FirstEstimate(u, v));
        }
    if (around.Noiseless())
    {
        std::array<float, kCell * kCell> all;
        all.fill(1.0f);
        return all;
    }
    return Rebuild(around, false).remains;
}

} // namespace tilt_lens

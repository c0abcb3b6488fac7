// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/reconstruction/padded_spread.h"

#include <algorithm>
#include <memory>

namespace tilt_lens
{

std::shared_ptr<const PaddedSpread> PaddedSpread::Of(const Sent& sent, std::uint32_t samples)
{
    const bool any = std::any_of(sent.begin(), sent.end(), [](const SpreadSums* one) { return one != nullptr; });
    return any ? std::shared_ptr<const PaddedSpread>(new PaddedSpread(sent, samples)) : nullptr;
}

namespace
{

/// What pixels have received, in either buffer: red, green, blue, and the shares.
using Received = std::array<std::array<PaddedSpread::Plane, 4>, 2>;

void AddRow(const float* from, int count, float weight, float* to)
{
    int i = 0;
    for (; i + 4 <= count; i += 4)
        Store(to + i, Load<Float4>(to + i) + weight * Load<Float4>(from + i));
    for (; i < count; i++)
        to[i] += weight * from[i];
}

constexpr int kSide = int(settings.blockSide), kBorder = PaddedBlock::kBorder, kReach = SpreadSums::kReach;
static_assert(kBorder + kReach <= kSide, "samples of the neighbours must be all that reaches the border");

} // namespace

PaddedSpread::PaddedSpread(const Sent& sent, std::uint32_t samples)
{
    const auto received = std::make_unique<Received>();
    ownShare.fill(1.0f);
    for (int i = 0; i < 9; i++)
    {
        if (sent[i] == nullptr)
            continue;
        const float weight = samples / sent[i]->SamplesOfPixel();
        const int left = (i % 3 - 1) * kSide, top = (i / 3 - 1) * kSide;
        const int begin = std::max(-kBorder, left - kReach), end = std::min(kSide + kBorder, left + kSide + kReach);
        for (int y = std::max(-kBorder, top - kReach); y < std::min(kSide + kBorder, top + kSide + kReach); y++)
            for (int buffer = 0; buffer < 2; buffer++)
                for (int c = 0; c < 4; c++)
                    AddRow(sent[i]->From(buffer, c, begin - left, y - top), end - begin, weight, &(*received)[buffer][c][PaddedBlock::At(begin, y)]);
        for (int y = std::max(-kBorder, top); y < std::min(kSide + kBorder, top + kSide); y++)
            for (int x = std::max(-kBorder, left); x < std::min(kSide + kBorder, left + kSide); x++)
                if (sent[i]->OwnSamples(x - left, y - top) > 0.0f)
                    ownShare[PaddedBlock::At(x, y)] = sent[i]->OwnShare(x - left, y - top) / sent[i]->OwnSamples(x - left, y - top);
    }
    for (std::size_t at = 0; at < share.size(); at += 4)
        Finish((*received)[0], (*received)[1], at);
}

/// Of four pixels.
void PaddedSpread::Finish(const std::array<Plane, 4>& a, const std::array<Plane, 4>& b, std::size_t at)
{
    const Float4 none{}, shareA = Load<Float4>(&a[3][at]), shareB = Load<Float4>(&b[3][at]), both = shareA + shareB;
    const Mask4 known = (shareA > none) & (shareB > none);
    Store(&share[at], known ? both : none);
    for (int c = 0; c < 3; c++)
    {
        const Float4 sumA = Load<Float4>(&a[c][at]), sumB = Load<Float4>(&b[c][at]);
        Store(&mean[c][at], known ? (sumA + sumB) / both : none);
        Store(&dualBufferDifference[c][at], known ? sumA / shareA - sumB / shareB : none);
    }
}

} // namespace tilt_lens

// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/reconstruction/padded_spread.h"

#include <algorithm>
#include <vector>

namespace tilt_lens
{

std::shared_ptr<const PaddedSpread> PaddedSpread::Of(const Sent& sent)
{
    const bool any = std::any_of(sent.begin(), sent.end(), [](const SpreadSums* one) { return one != nullptr; });
    return any ? std::shared_ptr<const PaddedSpread>(new PaddedSpread(sent)) : nullptr;
}

PaddedSpread::PaddedSpread(const Sent& sent)
{
    constexpr int side = int(settings.blockSide), border = PaddedBlock::kBorder, reach = SpreadSums::kReach;
    static_assert(border + reach <= side, "samples of the neighbours must be all that reaches the border");
    std::vector<SpreadSum> received(PaddedBlock::kRows * PaddedBlock::kColumns);
    ownShare.fill(1.0f);
    for (int i = 0; i < 9; i++)
    {
        if (sent[i] == nullptr)
            continue;
        const int left = (i % 3 - 1) * side, top = (i / 3 - 1) * side;
        for (int y = std::max(-border, top - reach); y < std::min(side + border, top + side + reach); y++)
            for (int x = std::max(-border, left - reach); x < std::min(side + border, left + side + reach); x++)
                received[PaddedBlock::At(x, y)].Add(sent[i]->At(x - left, y - top));
        for (int y = std::max(-border, top); y < std::min(side + border, top + side); y++)
            for (int x = std::max(-border, left); x < std::min(side + border, left + side); x++)
                if (sent[i]->OwnSamples(x - left, y - top) > 0.0f)
                    ownShare[PaddedBlock::At(x, y)] = sent[i]->OwnShare(x - left, y - top) / sent[i]->OwnSamples(x - left, y - top);
    }
    for (int y = -border; y < side + border; y++)
        for (int x = -border; x < side + border; x++)
            Finish(x, y, received[PaddedBlock::At(x, y)]);
}

void PaddedSpread::Finish(int x, int y, const SpreadSum& sum)
{
    const Float4 &a = sum.buffer[0], &b = sum.buffer[1], both = a + b;
    const int at = PaddedBlock::At(x, y);
    if (!(a[3] > 0.0f && b[3] > 0.0f))
        return;
    share[at] = both[3];
    for (int c = 0; c < 3; c++)
    {
        mean[c][at] = both[c] / both[3];
        dualBufferDifference[c][at] = a[c] / a[3] - b[c] / b[3];
    }
}

} // namespace tilt_lens

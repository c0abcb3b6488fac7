// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/reconstruction/padded_spread.h"

#include <algorithm>
#include <memory>

namespace tilt_lens
{

std::shared_ptr<const PaddedSpread> PaddedSpread::Of(const Sent& sent, const PictureEdges& edges)
{
    const bool any = std::any_of(sent.begin(), sent.end(), [](const SpreadSums* one) { return one != nullptr; });
    return any ? std::shared_ptr<const PaddedSpread>(new PaddedSpread(sent, edges)) : nullptr;
}

namespace
{

void AddRow(const float* from, int count, float* to)
{
    int i = 0;
    for (; i + 4 <= count; i += 4)
        Store(to + i, Load<Float4>(to + i) + Load<Float4>(from + i));
    for (; i < count; i++)
        to[i] += from[i];
}

constexpr int kSide = int(Settings::blockSide), kBorder = PaddedBlock::kBorder, kReach = SpreadSums::kReach;
static_assert(kBorder + kReach <= kSide, "samples of the neighbours must be all that reaches the border");

/// Greatest rounding error of a received variance, relative to the mean square; even pictures showed at most 4e-5.
constexpr float kRounding = 1e-4f;

} // namespace

PaddedSpread::PaddedSpread(const Sent& sent, const PictureEdges& edges)
{
    const auto received = std::make_unique<Received>();
    ownShare.fill(1.0f);
    ownWeight.fill(0.0f);
    for (int i = 0; i < 9; i++)
    {
        if (sent[i] == nullptr)
            continue;
        const int left = (i % 3 - 1) * kSide, top = (i / 3 - 1) * kSide;
        const int begin = std::max(-kBorder, left - kReach), end = std::min(kSide + kBorder, left + kSide + kReach);
        for (int y = std::max(-kBorder, top - kReach); y < std::min(kSide + kBorder, top + kSide + kReach); y++)
            for (int sum = 0; sum < SpreadSums::kSums; sum++)
                AddRow(sent[i]->From(SpreadSums::Sum(sum), begin - left, y - top), end - begin,
                       &(*received)[sum][PaddedBlock::At(begin, y)]);
        for (int y = std::max(-kBorder, top); y < std::min(kSide + kBorder, top + kSide); y++)
            for (int x = std::max(-kBorder, left); x < std::min(kSide + kBorder, left + kSide); x++)
                if (const float weight = sent[i]->OwnWeight(x - left, y - top); weight > 0.0f)
                {
                    ownShare[PaddedBlock::At(x, y)] = sent[i]->OwnShare(x - left, y - top) / weight;
                    ownWeight[PaddedBlock::At(x, y)] = weight;
                }
    }
    for (std::size_t at = 0; at < share.size(); at += 4)
        Finish(*received, at);
    for (Plane* plane : {&mean[0], &mean[1], &mean[2], &variance, &share, &samples, &ownShare, &ownWeight})
        PaddedBlock::Mirror(edges, *plane);
}

void PaddedSpread::Finish(const Received& received, std::size_t at)
{
    const Float4 none{}, shares = Load<Float4>(&received[SpreadSums::kShare][at]);
    const Mask4 known = shares > none;
    Store(&share[at], shares);
    Store(&samples[at], known ? shares * shares / Load<Float4>(&received[SpreadSums::kSquaredShares][at]) : none);
    const Float4 squares = known ? Load<Float4>(&received[SpreadSums::kSquares][at]) / shares : none;
    Float4 difference = squares;
    for (int c = 0; c < 3; c++)
    {
        const Float4 average = known ? Load<Float4>(&received[c][at]) / shares : none;
        difference -= average * average;
        Store(&mean[c][at], average);
    }
    Store(&variance[at], difference > kRounding * squares ? difference : none);
}

} // namespace tilt_lens

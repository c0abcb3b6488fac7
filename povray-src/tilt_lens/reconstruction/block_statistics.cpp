// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/reconstruction/block_statistics.h"

#include <algorithm>

namespace tilt_lens
{

namespace
{

constexpr int kSide = int(Settings::blockSide);

/// @param place   -1 left of the middle block, 0, or 1 right of it
/// @param mirror  true if `from` is the middle block's row
void CopyRow(const float* from, int place, bool mirror, float* row)
{
    constexpr int border = PaddedBlock::kBorder;
    float* to = row + (place < 0 ? 0 : place == 0 ? border : border + kSide);
    if (place == 0)
        std::copy_n(from, kSide, to);
    else if (mirror)
        std::reverse_copy(place < 0 ? from : from + kSide - border, place < 0 ? from + border : from + kSide, to);
    else
        std::copy_n(place < 0 ? from + kSide - border : from, border, to);
    if (place > 0)
        std::fill(to + border, row + PaddedBlock::kColumns, 0.0f);
}

} // namespace

void BlockStatistics::Set(std::uint32_t x, std::uint32_t y, const Radiance& mean, double noise, double missed, std::uint32_t samples)
{
    const std::size_t i = y * Settings::blockSide + x;
    for (std::size_t c = 0; c < mean.size(); c++)
        planes[kMean + c][i] = mean[c];
    planes[kNoise][i] = noise;
    planes[kMissed][i] = missed;
    planes[kSamples][i] = samples;
    transparent = transparent || mean[3] != 0.0 || mean[4] != 0.0;
}

void BlockStatistics::RepeatEdges(std::uint32_t width, std::uint32_t height)
{
    if (width == Settings::blockSide && height == Settings::blockSide)
        return;
    for (BlockPlane& plane : planes)
        for (std::uint32_t y = 0; y < Settings::blockSide; y++)
            for (std::uint32_t x = 0; x < Settings::blockSide; x++)
                plane[y * Settings::blockSide + x] = plane[std::min(y, height - 1) * Settings::blockSide + std::min(x, width - 1)];
}

PaddedBlock::PaddedBlock(const std::array<const BlockStatistics*, 9>& blocks, const PictureEdges& edges)
{
    constexpr int begin[] = {-kBorder, 0, kSide, kSide + kBorder};
    for (int i = 0; i < 9; i++)
    {
        const int row = i / 3, column = i % 3;
        const bool sameRow = blocks[row * 3 + 1] != nullptr, sameColumn = blocks[3 + column] != nullptr;
        const bool mirrorX = blocks[i] == nullptr && (sameRow || !sameColumn);
        const bool mirrorY = blocks[i] == nullptr && !sameRow;
        const BlockStatistics& block = *blocks[(mirrorY ? 1 : row) * 3 + (mirrorX ? 1 : column)];
        transparent = transparent || block.IsTransparent();
        for (int y = begin[row]; y < begin[row + 1]; y++)
        {
            const int inside = y - (row - 1) * kSide, from = (mirrorY ? kSide - 1 - inside : inside) * kSide;
            for (std::size_t plane = 0; plane < planes.size(); plane++)
                CopyRow(&block[plane][from], column - 1, mirrorX, &planes[plane][At(-kBorder, y)]);
        }
    }
    for (Plane& plane : planes)
        Mirror(edges, plane);
}

void PaddedBlock::Mirror(const PictureEdges& edges, Plane& plane)
{
    constexpr int first = -kBorder, end = kSide + kBorder;
    const auto copyRow = [&](int from, int to) { std::copy_n(&plane[At(first, from)], end - first, &plane[At(first, to)]); };
    for (int y = edges.bottom; y < end; y++)
        copyRow(std::max(2 * edges.bottom - 1 - y, first), y);
    for (int y = edges.top - 1; y >= first; y--)
        copyRow(std::min(2 * edges.top - 1 - y, end - 1), y);
    for (int y = first; y < end; y++)
    {
        for (int x = edges.right; x < end; x++)
            plane[At(x, y)] = plane[At(std::max(2 * edges.right - 1 - x, first), y)];
        for (int x = edges.left - 1; x >= first; x--)
            plane[At(x, y)] = plane[At(std::min(2 * edges.left - 1 - x, end - 1), y)];
    }
}

} // namespace tilt_lens

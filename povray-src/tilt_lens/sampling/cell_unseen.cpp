// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file cell_unseen.cpp
/// What a cell's pixels may have missed: what those around them have met, and lamps that they aim at.

#include "tilt_lens/sampling/cell.h"

#include <algorithm>
#include <cmath>

namespace tilt_lens
{

namespace
{

/// Samples aimed at emitters that must have missed before they are believed hidden: an object fills only
/// part of the sphere around it, and that may lie over two pixels.
constexpr std::uint32_t kFewestAimed = 16;

/// A pixel that was good enough is opened again for an error of so many times what it may keep: what its neighbours meet
/// is as uncertain as their samples are few.
constexpr double kOpensAgain = 4.0;

/// Expected square error for something that leaves the mean of what a pixel sees by 1 and fills some share of it, after n
/// independent samples that all missed it: for a share q it is q^2 with probability exp(-q n). Pixels side by side see
/// different shares of a thing: any up to `share`, each as likely.
double Missed(double share, double n)
{
    const double x = share * n;
    if (x < 1e-2)  // where what follows is a difference of equal numbers
        return share * share / 3.0;
    return (2.0 - (2.0 + x * (2.0 + x)) * std::exp(-x)) / (x * n * n);
}

} // namespace

void Variation::Join(const Variation& other)
{
    for (std::size_t c = 0; c < leap.size(); c++)
    {
        variance[c] += other.variance[c];
        leap[c] = std::max(leap[c], other.leap[c]);
    }
}

const Cell* Holder(const Cell::Neighbours& neighbours, std::int64_t x, std::int64_t y)
{
    const Area& area = neighbours[4]->area;
    const int column = x < area.left ? 0 : x < area.Right() ? 1 : 2;
    const int row = y < area.top ? 0 : y < area.Bottom() ? 1 : 2;
    return neighbours[3 * row + column];
}

bool Cell::IsVaried() const
{
    return std::any_of(pixels.begin(), pixels.end(), [](const Pixel& pixel) { return IsAny(pixel.own.variance); });
}

/// Whether samples of the cell's pixels differ, or the first ones of its neighbours'. What is evenly lit needs no
/// closer look.
bool Cell::IsVariedAround(const Neighbours& neighbours) const
{
    return IsVaried() || std::any_of(neighbours.begin(), neighbours.end(), [this](const Cell* cell)
        { return cell != nullptr && cell != this && cell->varied; });
}

/// Of the 3 by 3 pixels around one of the cell's: mean variance, largest leap. Pixels outside the cell count by their
/// first samples, where there are neighbours.
Variation Cell::VariationAround(std::size_t pixel, const Neighbours& neighbours) const
{
    const std::int64_t left = pixel % area.width, top = pixel / area.width;
    Variation around;
    int count = 0;
    for (std::int64_t y = top - 1; y <= top + 1; y++)
        for (std::int64_t x = left - 1; x <= left + 1; x++)
        {
            if (x >= 0 && x < area.width && y >= 0 && y < area.height)
                around.Join(pixels[y * area.width + x].own);
            else if (const Cell* holder = Holder(neighbours, area.left + x, area.top + y))
                around.Join(holder->FirstOf(area.left + x, area.top + y).own);
            else
                continue;
            count++;
        }
    for (double& variance : around.variance)
        variance /= count;
    return around;
}

/// Notes for each pixel how the samples of the first round differ, over the cell and the pixels beside it, of what is
/// blurred far enough to lie over this pixel too: a point covers all pixels within its blur's radius, so two pixels
/// that see it are at most twice that apart.
void Cell::NoteBlurred(const Neighbours& neighbours)
{
    if (!IsVariedAround(neighbours))
        return;
    Variation everywhere;  // of what is blurred over the whole cell
    int count = 0;
    for (std::int64_t v = std::int64_t(area.top) - 1; v <= area.Bottom(); v++)
        for (std::int64_t u = std::int64_t(area.left) - 1; u <= area.Right(); u++)
        {
            const Cell* holder = Holder(neighbours, u, v);
            if (holder == nullptr || !holder->area.Has(u, v))
                continue;
            count++;
            const First& other = holder->FirstOf(u, v);
            if (2.0 * other.blur >= kCell)
                everywhere.Join(other.own);
            else
                NoteBlurredOver(u, v, 2.0 * other.blur, other.own);
        }
    for (Pixel& pixel : pixels)
    {
        pixel.blurred.Join(everywhere);
        for (double& variance : pixel.blurred.variance)
            variance /= count;
    }
}

/// For the cell's pixels that are no farther from (x, y) than `reach` columns and rows.
void Cell::NoteBlurredOver(std::int64_t x, std::int64_t y, double reach, const Variation& variation)
{
    if (!IsAny(variation.variance))
        return;
    const std::int64_t most = std::int64_t(reach);
    for (std::int64_t v = std::max<std::int64_t>(area.top, y - most); v <= y + most && v < area.Bottom(); v++)
        for (std::int64_t u = std::max<std::int64_t>(area.left, x - most); u <= x + most && u < area.Right(); u++)
            pixels[Index(u, v)].blurred.Join(variation);
}

/// Expected square error of the mean for what others met and the pixel's own samples show less of: of what is around
/// it or of what is blurred over it, whichever is more.
Radiance Cell::Unseen(const Pixel& pixel, const Variation& around)
{
    Radiance error{};
    for (const Variation* others : {&around, &pixel.blurred})
        for (std::size_t c = 0; c < error.size(); c++)
        {
            const double lacking = others->variance[c] - pixel.own.variance[c];
            if (!(lacking > 0.0))
                continue;
            const double leap = std::max(lacking, others->leap[c]);
            error[c] = std::max(error[c], leap * Missed(lacking / leap, pixel.samples));
        }
    return error;
}

/// Whether any of the 3 by 3 pixels around one, as far as they are in the cell, is open.
bool Cell::IsBesideOpen(std::size_t pixel) const
{
    const std::uint32_t left = pixel % area.width, top = pixel / area.width;
    for (std::uint32_t y = top - (top > 0); y <= top + 1 && y < area.height; y++)
        for (std::uint32_t x = left - (left > 0); x <= left + 1 && x < area.width; x++)
            if (pixels[y * area.width + x].open)
                return true;
    return false;
}

/// Opens pixels that were good enough until those beside them met what they may have missed.
void Cell::OpenAgain(const Neighbours& neighbours)
{
    for (std::size_t i = 0; i < pixels.size(); i++)
    {
        Pixel& pixel = pixels[i];
        if (pixel.open || !IsBesideOpen(i))  // nothing new there
            continue;
        const Radiance unseen = Unseen(pixel, VariationAround(i, neighbours)), mean = MeanOf(pixel);
        for (std::size_t c = 0; c < unseen.size(); c++)
            pixel.open |= unseen[c] > kOpensAgain * pixel.allowed * Brightness(mean[c]);
    }
}

/// Whether the pixel's samples have looked for the emitters it aims at as long as their light is worth.
bool Cell::HasSought(const Pixel& pixel, double allowed)
{
    const std::uint32_t aimed = pixel.aimedSamples;
    return aimed == 0 || aimed >= kFewestAimed ||
           std::min(1.0, pixel.sought * pixel.sought) * Missed(1.0, aimed) <= allowed;
}

} // namespace tilt_lens

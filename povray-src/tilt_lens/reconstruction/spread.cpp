// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/reconstruction/spread.h"

#include <algorithm>
#include <cmath>

namespace tilt_lens
{

LensFootprint::LensFootprint(const Lens& lens, const Aperture& aperture, double width, double height) :
    width(width), height(height), boundingRadius(float(aperture.BoundingRadius()))
{
    // right and up need not be at right angles: what has one of them alone is at right angles to the other
    const Vec3 rightAlone = Cross(lens.up, lens.axis), upAlone = Cross(lens.axis, lens.right);
    const auto axis = [&](const Vec3& of)
    {
        const double depth = Dot(of, lens.axis) / Dot(lens.direction, lens.axis);
        const Vec3 along = of - depth * lens.direction;
        return Axis{Dot(along, rightAlone) / Dot(lens.right, rightAlone), Dot(along, upAlone) / Dot(lens.up, upAlone), depth,
                    Dot(lens.focus, of)};
    };
    axisA = axis(lens.lensX);
    axisB = axis(lens.lensY);
    if (aperture.IsDisc())
        return;
    for (int row = 0; row < settings.densityCells; row++)
        for (int column = 0; column < settings.densityCells; column++)
            density.push_back(float(aperture.Density({boundingRadius * ((2.0 * column + 1.0) / settings.densityCells - 1.0),
                                                      boundingRadius * ((2.0 * row + 1.0) / settings.densityCells - 1.0)})));
}

float LensFootprint::DensityAt(float a, float b) const
{
    const float scale = 0.5f * settings.densityCells / boundingRadius;
    const int column = std::clamp(int((a + boundingRadius) * scale), 0, settings.densityCells - 1);
    const int row = std::clamp(int((b + boundingRadius) * scale), 0, settings.densityCells - 1);
    return density[row * settings.densityCells + column];
}

/// The hit lies along the chief ray's direction plus `vergence` times the lens point; M is the derivative by the lens point.
CircleOfConfusion LensFootprint::CircleOf(const FilmPoint& film, const AperturePoint& point, double vergence) const
{
    const double depth = 1.0 + vergence * (point.a * axisA.depth + point.b * axisB.depth);
    const double x = (film.x + vergence * (point.a * axisA.x + point.b * axisB.x)) / depth;
    const double y = (film.y + vergence * (point.a * axisA.y + point.b * axisB.y)) / depth;
    // the vergence that the point has for the ray through the lens centre
    const double central = vergence * (1.0 - point.a * axisA.focus - point.b * axisB.focus) / depth;
    const double across = width * central, down = -height * central;
    return {float((x + 0.5) * width), float((0.5 - y) * height),
            float(across * (axisA.x - x * axisA.depth)), float(across * (axisB.x - x * axisB.depth)),
            float(down * (axisA.y - y * axisA.depth)), float(down * (axisB.y - y * axisB.depth)), this};
}

namespace
{

/// A circle of confusion along one axis of the picture.
struct Extent
{
    float middle, half;  ///< pixels

    /// Pixels' sides of it from which samples reach a pixel: those at most kReach away that lie in the picture.
    float SendersTo(int pixel, const PictureSpan& picture) const
    {
        const float from = std::max({middle - half, float(pixel - SpreadSums::kReach), picture.begin});
        return std::max(1.0f, std::min({middle + half, float(pixel + SpreadSums::kReach + 1), picture.end}) - from);
    }
};

/// The pixels of a circle of confusion that are at most kReach away from the sample's own, row by row.
class CirclePixels
{
  public:
    static constexpr int kRows = 2 * SpreadSums::kReach + 1;

    CirclePixels(const CircleOfConfusion& circle, int column, int row)
    {
        if (circle.lens == nullptr)
            return;
        // the ellipse's matrix
        const float scale = circle.lens->BoundingRadius() * circle.lens->BoundingRadius();
        const float xx = scale * (circle.xa * circle.xa + circle.xb * circle.xb);
        const float xy = scale * (circle.xa * circle.ya + circle.xb * circle.yb);
        const float yy = scale * (circle.ya * circle.ya + circle.yb * circle.yb);
        const float determinant = xx * yy - xy * xy;
        // smaller than a pixel: it serves its own alone
        if (!(std::min(xx, yy) >= 1.0f && determinant >= 1.0f && std::isfinite(determinant + circle.x)))
            return;
        for (int i = 0; i < kRows; i++)
        {
            const float below = row + i - SpreadSums::kReach + 0.5f - circle.y, left = 1.0f - below * below / yy;
            if (!(left > 0.0f))
                continue;
            const float middle = circle.x + xy / yy * below - 0.5f, half = std::sqrt(determinant / yy * left);
            const float first = float(column - SpreadSums::kReach), last = float(column + SpreadSums::kReach);
            begin[i] = int(std::ceil(std::clamp(middle - half, first, last + 1.0f)));
            end[i] = std::max(begin[i], int(std::floor(std::clamp(middle + half, first - 1.0f, last))) + 1);
            count += end[i] - begin[i];
        }
        across = {circle.x, std::sqrt(xx)};
        down = {circle.y, std::sqrt(yy)};
    }

    int begin[kRows] = {}, end[kRows] = {}, count = 0;
    Extent across{}, down{};
};

/// The densities of a lens that is not the unit disc, of the pixels of a circle; their sum is left in `sum`.
std::vector<float> DensitiesOf(const CircleOfConfusion& circle, const CirclePixels& pixels, int row, float& sum)
{
    std::vector<float> densities;
    const float determinant = circle.xa * circle.yb - circle.xb * circle.ya;
    sum = 0.0f;
    for (int i = 0; i < CirclePixels::kRows; i++)
        for (int x = pixels.begin[i]; x < pixels.end[i]; x++)
        {
            const float dx = circle.x - x - 0.5f, dy = circle.y - (row + i - SpreadSums::kReach) - 0.5f;
            densities.push_back(circle.lens->DensityAt((circle.yb * dx - circle.xb * dy) / determinant,
                                               (circle.xa * dy - circle.ya * dx) / determinant));
            sum += densities.back();
        }
    return densities;
}

/// Shares of the pixels of a row, from kReach before the sample's own to kReach behind it, relative to its own.
std::array<float, CirclePixels::kRows> SharesAlong(const Extent& across, int column, const PictureSpan& columns)
{
    std::array<float, CirclePixels::kRows> shares;
    const float sendersToItself = across.SendersTo(column, columns);
    for (int i = 0; i < CirclePixels::kRows; i++)
        shares[i] = sendersToItself / across.SendersTo(column + i - SpreadSums::kReach, columns);
    return shares;
}

} // namespace

SpreadSums::SpreadSums(const Area& block, double width, double height) :
    columns{-float(block.left), float(width - block.left)}, rows{-float(block.top), float(height - block.top)}
{
}

void SpreadSums::Add(int column, int row, std::uint32_t number, const CircleOfConfusion& circle, const Radiance& radiance)
{
    Own& itself = own[row * int(settings.blockSide) + column];
    itself.samples += 1.0f;
    const Float4 value = {float(radiance[0]), float(radiance[1]), float(radiance[2]), 1.0f};
    const bool finite = std::isfinite(value[0]) && std::isfinite(value[1]) && std::isfinite(value[2]);
    const CirclePixels pixels(finite ? circle : CircleOfConfusion(), column, row);
    const bool shaped = pixels.count > 1 && !circle.lens->IsDisc();
    float sum = float(pixels.count);
    const std::vector<float> densities = shaped ? DensitiesOf(circle, pixels, row, sum) : std::vector<float>();
    if (pixels.count <= 1 || !(sum > 0.0f))
    {
        itself.share += 1.0f;
        return;
    }
    spread = true;
    const int buffer = (column + row + number) % 2;  // so that the only sample of each pixel serves both
    const std::array<float, CirclePixels::kRows> shares = SharesAlong(pixels.across, column, columns);
    const float sendersToItsRow = pixels.down.SendersTo(row, rows);
    std::size_t next = 0;
    for (int i = 0; i < CirclePixels::kRows; i++)
    {
        const Float4 ofRow = sendersToItsRow / (sum * pixels.down.SendersTo(row + i - kReach, rows)) * value;
        for (int x = pixels.begin[i]; x < pixels.end[i]; x++)
        {
            const Float4 sent = (shaped ? densities[next++] : 1.0f) * shares[x - column + kReach] * ofRow;
            if (i == kReach && x == column)
                itself.share += sent[3];
            else
                sums[(row + i) * kSide + x + kReach].buffer[buffer] += sent;
        }
    }
}

} // namespace tilt_lens

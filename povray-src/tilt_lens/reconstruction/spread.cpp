// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/reconstruction/spread.h"

#include <cmath>

#include "tilt_lens/math/kernels.h"
#include "tilt_lens/reconstruction/blur_ellipse.h"

namespace tilt_lens
{

LensFootprint::LensFootprint(const Lens& lens, const Aperture& aperture, double width, double height) :
    width(width), height(height), boundingRadius(float(aperture.BoundingRadius())), isDisc(aperture.IsDisc())
{
    // right and up need not be perpendicular
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
    if (isDisc)
        return;
    for (int row = 0; row < Settings::densityCells; row++)
        for (int column = 0; column < Settings::densityCells; column++)
            density.push_back(float(aperture.Density({boundingRadius * ((2.0 * column + 1.0) / Settings::densityCells - 1.0),
                                                      boundingRadius * ((2.0 * row + 1.0) / Settings::densityCells - 1.0)})));
}

DensityTable LensFootprint::Density() const
{
    return {density.data(), 0.5f * Settings::densityCells / boundingRadius};
}

namespace
{

/// @param place  pixels
double FromPixelCentre(double place)
{
    return place - std::floor(place) - 0.5;
}

} // namespace

/// The hit lies along the chief ray plus `vergence` times the lens point; M is the derivative by the lens point.
CircleOfConfusion LensFootprint::CircleOf(const FilmPoint& film, const AperturePoint& point, double vergence) const
{
    const double depth = 1.0 + vergence * (point.a * axisA.depth + point.b * axisB.depth);
    const double x = (film.x + vergence * (point.a * axisA.x + point.b * axisB.x)) / depth;
    const double y = (film.y + vergence * (point.a * axisA.y + point.b * axisB.y)) / depth;
    const double central = vergence * (1.0 - point.a * axisA.focus - point.b * axisB.focus) / depth;
    const double across = width * central, down = -height * central;
    return {float((x + 0.5) * width - FromPixelCentre((film.x + 0.5) * width)),
            float((0.5 - y) * height - FromPixelCentre((0.5 - film.y) * height)),
            float(across * (axisA.x - x * axisA.depth)),
            float(across * (axisB.x - x * axisB.depth)),
            float(down * (axisA.y - y * axisA.depth)),
            float(down * (axisB.y - y * axisB.depth)),
            this};
}

bool ServesOthers(const CircleOfConfusion& circle)
{
    return BlurEllipse(circle).IsWide();
}

SpreadSums::SpreadSums(const Area& block, double width, double height) :
    SpreadPlanes{{-float(block.left), float(width - block.left)}, {-float(block.top), float(height - block.top)}, {}, {}, false}
{
}

void SharpSamples::Add(const Radiance& radiance, float weight)
{
    const float colours[] = {float(radiance[0]), float(radiance[1]), float(radiance[2])};
    const float square = colours[0] * colours[0] + colours[1] * colours[1] + colours[2] * colours[2];
    count++;
    weights += weight;
    if (!IsFinite(square))
        return;
    squares += square;
    for (int c = 0; c < 3; c++)
        light[c] += colours[c];
}

void SpreadSums::Add(int column, int row, const SharpSamples& sharp, float weight)
{
    Own& itself = own[row * int(Settings::blockSide) + column];
    itself.share += weight * sharp.count;
    itself.weight += weight * sharp.count;
    const int at = PlaceOf(column, row);
    for (int c = 0; c < 3; c++)
        sums[c][at] += weight * sharp.light[c];
    sums[kShare][at] += weight * sharp.weights;
    sums[kSquares][at] += weight * sharp.squares;
    sums[kSquaredShares][at] += weight * weight * sharp.count;
}

void SpreadSums::Add(int column, int row, const CircleOfConfusion& circle, const Radiance& radiance, float weight)
{
    if (kernels->spreadSample(*this, column, row, circle, radiance.data(), weight))
        return;
    SharpSamples alone;
    alone.Add(radiance, circle.weight);
    Add(column, row, alone, weight);
}

} // namespace tilt_lens

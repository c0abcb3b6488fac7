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

/// Rows or columns that a sample reaches, from kReach before its own to kReach behind it.
constexpr int kRows = 2 * SpreadSums::kReach + 1;
/// As many numbers fill vectors: one more, which nobody uses.
constexpr int kLanes = kRows + 1;
static_assert(kLanes % 8 == 0, "a vector has eight");

struct alignas(32) LaneNumbers
{
    float of[kLanes];
};

constexpr LaneNumbers Numbered()
{
    LaneNumbers numbers{};
    for (int i = 0; i < kLanes; i++)
        numbers.of[i] = float(i - SpreadSums::kReach);
    return numbers;
}

constexpr LaneNumbers kOffsets = Numbered();

template<class Vector>
constexpr int kWidth = sizeof(Vector) / sizeof(float);

/// A circle of confusion along one axis of the picture.
struct Extent
{
    float middle, half;  ///< pixels

    /// Pixels' sides of it from which samples reach a pixel: those at most kReach away that lie in the picture. Of the pixels that a
    /// sample of `own` reaches.
    template<class Vector>
    TILT_LENS_INLINED void FindSenders(int own, const PictureSpan& picture, LaneNumbers& senders) const
    {
        const float reach = SpreadSums::kReach, from = std::max(middle - half, picture.begin), to = std::min(middle + half, picture.end);
        for (int i = 0; i < kLanes; i += kWidth<Vector>)
        {
            const Vector pixel = Load<Vector>(kOffsets.of + i) + float(own);
            const Vector begin = pixel - reach, end = pixel + (reach + 1.0f);
            const Vector length = Min<Vector>(end, to - Vector()) - Max<Vector>(begin, from - Vector());
            Store(senders.of + i, Max<Vector>(length, 1.0f - Vector()));
        }
    }
};

} // namespace

/// The pixels of a circle of confusion that are at most kReach away from the sample's own, row by row.
struct CirclePixels
{
    int begin[kLanes], end[kLanes], count = 0;
    Extent across{}, down{};

    template<class Vector>
    TILT_LENS_INLINED void Find(const CircleOfConfusion& circle, int column, int row)
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
        for (int i = 0; i < kLanes; i += kWidth<Vector>)
            FindRows<Vector>(i, circle, column, float(row), {xy / yy, yy, determinant});
        begin[kRows] = end[kRows] = 0;
        for (int i = 0; i < kRows; i++)
            count += end[i] - begin[i];
        across = {circle.x, std::sqrt(xx)};
        down = {circle.y, std::sqrt(yy)};
    }

  private:
    struct Ellipse
    {
        float lean, yy, determinant;
    };

    template<class Vector>
    TILT_LENS_INLINED void FindRows(int i, const CircleOfConfusion& circle, int column, float row, const Ellipse& ellipse)
    {
        using Whole = std::conditional_t<std::is_same_v<Vector, Float8>, Mask8, Mask4>;
        const Vector none = Vector(), below = Load<Vector>(kOffsets.of + i) + row + 0.5f - circle.y;
        const Vector left = 1.0f - below * below / ellipse.yy;
        const Whole met = left > none;
        const Vector middle = circle.x + ellipse.lean * below - 0.5f, half = SquareRoot(ellipse.determinant / ellipse.yy * (met ? left : none));
        const float first = float(column - SpreadSums::kReach), last = float(column + SpreadSums::kReach);
        const Vector least = Clamp(middle - half, first, last + 1.0f), most = Clamp(middle + half, first - 1.0f, last);
        Whole from = __builtin_convertvector(least, Whole), to = __builtin_convertvector(most, Whole);
        // a comparison that holds is -1: rounded up, and down
        from -= __builtin_convertvector(from, Vector) < least;
        to += __builtin_convertvector(to, Vector) > most;
        Store(begin + i, from & met);
        Store(end + i, Max<Whole>(to + 1, from) & met);
    }

    template<class Vector>
    static TILT_LENS_INLINED Vector Clamp(const Vector& value, float least, float most)
    {
        return Min<Vector>(most - Vector(), Max<Vector>(least - Vector(), value));
    }
};

namespace
{

/// The densities of a lens that is not the unit disc, of the pixels of a circle; their sum is left in `sum`.
std::vector<float> DensitiesOf(const CircleOfConfusion& circle, const CirclePixels& pixels, int row, float& sum)
{
    std::vector<float> densities;
    const float determinant = circle.xa * circle.yb - circle.xb * circle.ya;
    sum = 0.0f;
    for (int i = 0; i < kRows; i++)
        for (int x = pixels.begin[i]; x < pixels.end[i]; x++)
        {
            const float dx = circle.x - x - 0.5f, dy = circle.y - (row + i - SpreadSums::kReach) - 0.5f;
            densities.push_back(circle.lens->DensityAt((circle.yb * dx - circle.xb * dy) / determinant,
                                               (circle.xa * dy - circle.ya * dx) / determinant));
            sum += densities.back();
        }
    return densities;
}

/// Adds a share of the same value to pixels that lie side by side.
template<class Vector>
TILT_LENS_INLINED void AddShares(Float4* sums, const Float4* shares, const Float4& value, int count)
{
    constexpr int together = sizeof(Vector) / sizeof(Float4);
    Vector values = Vector();
    for (int i = 0; i < kWidth<Vector>; i++)
        values[i] = value[i % 4];
    int i = 0;
    for (; i + together <= count; i += together)
        Store(sums + i, Load<Vector>(sums + i) + Load<Vector>(shares + i) * values);
    for (; i < count; i++)
        sums[i] += shares[i] * value;
}

} // namespace

SpreadSums::SpreadSums(const Area& block, double width, double height) :
    columns{-float(block.left), float(width - block.left)}, rows{-float(block.top), float(height - block.top)}
{
}

template<class Vector>
TILT_LENS_INLINED void SpreadSums::AddBy(int column, int row, std::uint32_t number, const CircleOfConfusion& circle,
                                         const Radiance& radiance)
{
    Own& itself = own[row * int(settings.blockSide) + column];
    itself.samples += 1.0f;
    const Float4 value = {float(radiance[0]), float(radiance[1]), float(radiance[2]), 1.0f};
    CirclePixels pixels;
    if (std::isfinite(value[0]) && std::isfinite(value[1]) && std::isfinite(value[2]))
        pixels.Find<Vector>(circle, column, row);
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
    Send<Vector>(pixels, shaped ? densities.data() : nullptr, sum, value, column, row, buffer);
}

template<class Vector>
TILT_LENS_INLINED void SpreadSums::Send(const CirclePixels& pixels, const float* density, float sum, const Float4& value, int column,
                                        int row, int buffer)
{
    LaneNumbers sendersToColumn, sendersToRow;
    pixels.across.FindSenders<Vector>(column, columns, sendersToColumn);
    pixels.down.FindSenders<Vector>(row, rows, sendersToRow);
    Float4 shares[kRows];  // of the pixels of a row, relative to its own
    for (int i = 0; i < kRows; i++)
        shares[i] = sendersToColumn.of[kReach] / sendersToColumn.of[i] - Float4();
    for (int i = 0; i < kRows; i++)
    {
        const int begin = pixels.begin[i], count = pixels.end[i] - begin;
        if (count == 0)
            continue;
        const Float4 ofRow = sendersToRow.of[kReach] / (sum * sendersToRow.of[i]) * value;
        const Float4* ofPixels = shares + begin - column + kReach;
        Float4 changed[kRows];  // where the lens is not even, and where nothing is sent to the sample's own pixel
        if (density != nullptr || i == kReach)
        {
            for (int x = 0; x < count; x++)
                changed[x] = (density != nullptr ? *density++ : 1.0f) * ofPixels[x];
            ofPixels = changed;
        }
        if (i == kReach && column >= begin && column < pixels.end[i])
        {
            own[row * int(settings.blockSide) + column].share += (changed[column - begin] * ofRow)[3];
            changed[column - begin] = Float4();
        }
        AddShares<Vector>(&sums[buffer][(row + i) * kSide + begin + kReach], ofPixels, ofRow, count);
    }
}

void SpreadSums::AddPlain(int column, int row, std::uint32_t number, const CircleOfConfusion& circle, const Radiance& radiance)
{
    AddBy<Float4>(column, row, number, circle, radiance);
}

void SpreadSums::AddByAvx2(int column, int row, std::uint32_t number, const CircleOfConfusion& circle, const Radiance& radiance)
{
    AddBy<Float8>(column, row, number, circle, radiance);
}

void SpreadSums::Add(int column, int row, std::uint32_t number, const CircleOfConfusion& circle, const Radiance& radiance)
{
    if (HasAvx2())
        AddByAvx2(column, row, number, circle, radiance);
    else
        AddPlain(column, row, number, circle, radiance);
}

} // namespace tilt_lens

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
    // project along vectors perpendicular to the other axes, since right and up need not be perpendicular
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

void LensFootprint::FindDensities(const AperturePoints& first, const AperturePoints& step, int count, float* densities) const
{
    // table positions in units of 2^-kShift cells; kReach pixels on either side cannot overflow
    constexpr int kShift = 16, kMost = 1024, last = settings.densityCells - 1;
    const float scale = 0.5f * settings.densityCells / boundingRadius;
    const auto places = [](float cells) { return int(std::min(std::max(cells, float(-kMost)), float(kMost)) * (1 << kShift)); };
    int column = places((first.a + boundingRadius) * scale), row = places((first.b + boundingRadius) * scale);
    const int columnStep = places(step.a * scale), rowStep = places(step.b * scale);
    for (int i = 0; i < count; i++, column += columnStep, row += rowStep)
        densities[i] = density[std::clamp(row >> kShift, 0, last) * settings.densityCells + std::clamp(column >> kShift, 0, last)];
}

/// The hit lies in the direction of the chief ray plus `vergence` times the lens point; M is the derivative by the lens point.
CircleOfConfusion LensFootprint::CircleOf(const FilmPoint& film, const AperturePoint& point, double vergence) const
{
    const double depth = 1.0 + vergence * (point.a * axisA.depth + point.b * axisB.depth);
    const double x = (film.x + vergence * (point.a * axisA.x + point.b * axisB.x)) / depth;
    const double y = (film.y + vergence * (point.a * axisA.y + point.b * axisB.y)) / depth;
    // vergence of the point for the ray through the lens centre
    const double central = vergence * (1.0 - point.a * axisA.focus - point.b * axisB.focus) / depth;
    const double across = width * central, down = -height * central;
    return {float((x + 0.5) * width), float((0.5 - y) * height),
            float(across * (axisA.x - x * axisA.depth)), float(across * (axisB.x - x * axisB.depth)),
            float(down * (axisA.y - y * axisA.depth)), float(down * (axisB.y - y * axisB.depth)), this};
}

namespace
{

/// Rows or columns within reach of a sample: kReach before its own to kReach behind it.
constexpr int kRows = 2 * SpreadSums::kReach + 1;
/// kRows, padded to whole vectors.
constexpr int kLanes = kRows + 1;
static_assert(kLanes % SpreadSums::kMostLanes == 0, "vectors hold them without a rest");

/// Numbers with padding: a row's last vector may read beyond it.
struct alignas(32) LaneNumbers
{
    float of[kLanes + SpreadSums::kMostLanes]{};
};

constexpr LaneNumbers Numbered()
{
    LaneNumbers numbers{};
    for (int i = 0; i < kLanes; i++)
        numbers.of[i] = float(i - SpreadSums::kReach);
    return numbers;
}

constexpr LaneNumbers kOffsets = Numbered();

/// Distance, in pixels, at which the window of a sample ends.
constexpr float kWindowRadius = SpreadSums::kReach + 1;

/// Window along rows and columns, 1 - (distance / kWindowRadius)^2: without it, samples of a highlight would show as squares.
constexpr LaneNumbers WindowOf(const LaneNumbers& offsets)
{
    LaneNumbers window{};
    for (int i = 0; i < kLanes; i++)
        window.of[i] = 1.0f - offsets.of[i] * offsets.of[i] / (kWindowRadius * kWindowRadius);
    return window;
}

constexpr LaneNumbers kWindow = WindowOf(kOffsets);

/// Integral of the window from 0 to each distance, at most its radius.
template<class Vector>
TILT_LENS_INLINED Vector WindowUpTo(const Vector& distance)
{
    const Vector most = kWindowRadius - Vector(), limited = Max<Vector>(-most, Min<Vector>(most, distance));
    return limited - limited * limited * limited * (1.0f / (3.0f * kWindowRadius * kWindowRadius));
}

/// The difference for the end and the begin of a row of pixels, as distances from the middle of the sample's own, is the sum of the window
/// over them.
template<class Vector>
TILT_LENS_INLINED Vector WindowSumUpTo(const Vector& distance)
{
    constexpr float inverse = 1.0f / (kWindowRadius * kWindowRadius);
    return distance * ((1.0f + inverse / 12.0f) - distance * distance * (inverse / 3.0f));
}

/// Mask of a row's last vector: loaded from index kMostLanes - count, it starts with `count` ones.
constexpr float kInRow[2 * SpreadSums::kMostLanes] = {1, 1, 1, 1, 1, 1, 1, 1};

template<class Vector>
constexpr int kWidth = kVectorWidth<Vector>;

/// Extent of a circle of confusion along one axis of the picture.
struct Extent
{
    float middle, half;  ///< pixels

    /// For each pixel within reach of a sample of pixel `own`: integral of its window over the part of the extent that lies in the picture.
    template<class Vector>
    TILT_LENS_INLINED void FindSenders(int own, const PictureSpan& picture, LaneNumbers& senders) const
    {
        const float from = std::max(middle - half, picture.begin), to = std::min(middle + half, picture.end);
        for (int i = 0; i < kLanes; i += kWidth<Vector>)
        {
            const Vector centre = Load<Vector>(kOffsets.of + i) + (float(own) + 0.5f);
            const Vector integral = WindowUpTo<Vector>(to - centre) - WindowUpTo<Vector>(from - centre);
            Store(senders.of + i, Max<Vector>(integral, 1.0f - Vector()));
        }
    }
};

/// The matrix of a circle of confusion, in squared pixels.
struct Ellipse
{
    float xx = 0.0f, yy = 0.0f, lean = 0.0f, determinant = 0.0f;

    explicit Ellipse(const CircleOfConfusion& circle)
    {
        if (circle.lens == nullptr)
            return;
        const float scale = circle.lens->BoundingRadius() * circle.lens->BoundingRadius();
        xx = scale * (circle.xa * circle.xa + circle.xb * circle.xb);
        yy = scale * (circle.ya * circle.ya + circle.yb * circle.yb);
        const float xy = scale * (circle.xa * circle.ya + circle.xb * circle.yb);
        lean = xy / yy;
        determinant = std::isfinite(circle.x) ? xx * yy - xy * xy : 0.0f;
    }

    /// True if the circle is wider than a pixel.
    bool IsWide() const { return std::min(xx, yy) >= 1.0f && determinant >= 1.0f && std::isfinite(determinant); }
};

} // namespace

bool ServesOthers(const CircleOfConfusion& circle)
{
    return Ellipse(circle).IsWide();
}

/// The pixels of a circle of confusion at most kReach away from the sample's own, row by row.
struct CirclePixels
{
    int begin[kLanes], end[kLanes], count = 0;
    float windowOf[kLanes], windowed = 0.0f;  ///< sums of the window: along each row, over all pixels
    unsigned int rows = 0;  ///< a bit for each row that is not empty
    Extent across{}, down{};

    template<class Vector>
    TILT_LENS_INLINED void Find(const CircleOfConfusion& circle, int column, int row)
    {
        const Ellipse ellipse(circle);
        if (!ellipse.IsWide())
            return;
        for (int i = 0; i < kLanes; i += kWidth<Vector>)
            FindRows<Vector>(i, circle, column, float(row), ellipse);
        begin[kRows] = end[kRows] = 0;
        rows &= (1u << kRows) - 1;
        for (int i = 0; i < kRows; i++)
            count += end[i] - begin[i];
        Float4 sums{};  // in the same order for all vectors
        for (int i = 0; i < kLanes; i += kWidth<Float4>)
            sums += Load<Float4>(kWindow.of + i) * Load<Float4>(windowOf + i);
        windowed = (sums[0] + sums[1]) + (sums[2] + sums[3]);
        across = {circle.x, std::sqrt(ellipse.xx)};
        down = {circle.y, std::sqrt(ellipse.yy)};
    }

  private:
    template<class Vector>
    TILT_LENS_INLINED void FindRows(int i, const CircleOfConfusion& circle, int column, float row, const Ellipse& ellipse)
    {
        using Whole = std::conditional_t<std::is_same_v<Vector, Float8>, Mask8, Mask4>;
        const Vector none = Vector(), below = Load<Vector>(kOffsets.of + i) + row + 0.5f - circle.y;
        const Vector open = 1.0f - below * below / ellipse.yy;  // remaining fraction of the squared half width
        const Whole met = open > none;
        const Vector middle = circle.x + ellipse.lean * below - 0.5f, half = SquareRoot(ellipse.determinant / ellipse.yy * (met ? open : none));
        const float left = float(column - SpreadSums::kReach), right = float(column + SpreadSums::kReach);
        const Vector least = Clamp(middle - half, left, right + 1.0f), most = Clamp(middle + half, left - 1.0f, right);
        Whole from = __builtin_convertvector(least, Whole), to = __builtin_convertvector(most, Whole);
        // a true comparison is -1: round up, and down
        from -= __builtin_convertvector(from, Vector) < least;
        to += __builtin_convertvector(to, Vector) > most;
        const Whole first = from & met, last = Max<Whole>(to + 1, from) & met;
        const float own = float(column) + 0.5f;
        Store(windowOf + i, WindowSumUpTo<Vector>(__builtin_convertvector(last, Vector) - own) -
                            WindowSumUpTo<Vector>(__builtin_convertvector(first, Vector) - own));
        rows |= SignBits(first < last) << i;
        Store(begin + i, first);
        Store(end + i, last);
    }

    template<class Vector>
    static TILT_LENS_INLINED Vector Clamp(const Vector& value, float least, float most)
    {
        return Min<Vector>(most - Vector(), Max<Vector>(least - Vector(), value));
    }
};

namespace
{

/// Densities of a lens that is not the unit disc, at the pixels of a circle, row by row.
struct Densities
{
    float of[kRows * kRows + SpreadSums::kMostLanes];  ///< padding: read, not used
    float sum = 0.0f;  ///< over the pixels, times the window

    void Find(const CircleOfConfusion& circle, const CirclePixels& pixels, int column, int row)
    {
        const float inverse = 1.0f / (circle.xa * circle.yb - circle.xb * circle.ya);
        const AperturePoints step{-circle.yb * inverse, circle.ya * inverse};
        float* to = of;
        for (int i = 0; i < kRows; i++)
        {
            const float dx = circle.x - pixels.begin[i] - 0.5f, dy = circle.y - (row + i - SpreadSums::kReach) - 0.5f;
            const AperturePoints first{(circle.yb * dx - circle.xb * dy) * inverse, (circle.xa * dy - circle.ya * dx) * inverse};
            const int count = pixels.end[i] - pixels.begin[i];
            circle.lens->FindDensities(first, step, count, to);
            const int place = pixels.begin[i] - column + SpreadSums::kReach;
            for (int k = 0; k < count; k++)
                sum += kWindow.of[i] * kWindow.of[place + k] * to[k];
            to += count;
        }
        std::fill_n(to, SpreadSums::kMostLanes, 0.0f);
    }
};

/// Squared length of a colour.
TILT_LENS_INLINED float SquareOf(const Float4& value) { return value[0] * value[0] + value[1] * value[1] + value[2] * value[2]; }

/// One row of a circle's pixels, with their shares relative to the sample's own pixel.
struct RowShares
{
    const float* ofColumns;
    int begin, end;
    const float* density;  ///< of the lens, from the first pixel on; null: uniform

    float DensityAt(int column) const { return density != nullptr ? density[column - begin] : 1.0f; }

    /// Shares of a vector of pixels; zero beyond the row.
    template<class Vector>
    TILT_LENS_INLINED Vector From(int column) const
    {
        const int count = std::min(end - column, SpreadSums::kMostLanes);
        const Vector shares = Load<Vector>(kInRow + SpreadSums::kMostLanes - count) * Load<Vector>(ofColumns + column);
        return density != nullptr ? Load<Vector>(density + (column - begin)) * shares : shares;
    }
};

/// @param planes  the sums, in the order of SpreadSums::Sum
/// @param first  index of column 0 in a plane
/// @param value  red, green, blue and 1, times the sample's weight
/// @param square  squared colour, summed over the channels
template<class Vector, class Planes>
TILT_LENS_INLINED void AddRow(Planes& planes, int first, const RowShares& shares, const Float4& value, float square)
{
    const auto add = [first](auto& plane, int x, const Vector& part) TILT_LENS_INLINED_LAMBDA
        { Store(&plane[first + x], Load<Vector>(&plane[first + x]) + part); };
    for (int x = shares.begin; x < shares.end; x += kWidth<Vector>)
    {
        const Vector share = shares.From<Vector>(x);
        for (int c = SpreadSums::kRed; c < SpreadSums::kShare; c++)
            add(planes[c], x, share * value[c]);
        const Vector weighted = share * value[int(SpreadSums::kShare)];
        add(planes[SpreadSums::kShare], x, weighted);
        add(planes[SpreadSums::kSquaredShares], x, weighted * weighted);
        add(planes[SpreadSums::kSquares], x, share * square);
    }
}

} // namespace

SpreadSums::SpreadSums(const Area& block, double width, double height) :
    columns{-float(block.left), float(width - block.left)}, rows{-float(block.top), float(height - block.top)}
{
}

template<class Vector>
TILT_LENS_INLINED void SpreadSums::AddBy(int column, int row, const CircleOfConfusion& circle,
                                         const Radiance& radiance, float weight)
{
    const Float4 value = {float(radiance[0]), float(radiance[1]), float(radiance[2]), 1.0f};
    CirclePixels pixels;
    if (std::isfinite(SquareOf(value)))
        pixels.Find<Vector>(circle, column, row);
    const bool shaped = pixels.count > 1 && !circle.lens->IsDisc();
    float sum = pixels.windowed;
    Densities densities;
    if (shaped)
    {
        densities.Find(circle, pixels, column, row);
        sum = densities.sum;
    }
    if (pixels.count <= 1 || !(sum > 0.0f))
        return AddSharp(column, row, weight);
    spread = true;
    own[row * int(settings.blockSide) + column].weight += weight;
    Send<Vector>(pixels, shaped ? densities.of : nullptr, sum, value, weight, column, row);
}

template<class Vector>
TILT_LENS_INLINED void SpreadSums::Send(const CirclePixels& pixels, const float* density, float sum, const Float4& value, float weight,
                                        int column, int row)
{
    LaneNumbers ofColumns, ofRows;  // shares: of columns relative to the sample's own, of rows absolute
    pixels.across.FindSenders<Vector>(column, columns, ofColumns);
    pixels.down.FindSenders<Vector>(row, rows, ofRows);
    const float toColumn = ofColumns.of[kReach], toRow = ofRows.of[kReach];
    for (int i = 0; i < kLanes; i += kWidth<Vector>)
    {
        const Vector window = Load<Vector>(kWindow.of + i);
        Store(ofColumns.of + i, toColumn * window / Load<Vector>(ofColumns.of + i));
        Store(ofRows.of + i, toRow * window / (sum * Load<Vector>(ofRows.of + i)));
    }
    LaneNumbers ofOthers = ofColumns;  // nothing is sent to the sample's own pixel
    ofOthers.of[kReach] = 0.0f;
    for (unsigned int rest = pixels.rows; rest != 0; rest &= rest - 1)
    {
        const int i = __builtin_ctz(rest);
        const RowShares shares{(i == kReach ? ofOthers : ofColumns).of - (column - kReach), pixels.begin[i], pixels.end[i], density};
        if (i == kReach && column >= shares.begin && column < shares.end)
            own[row * int(settings.blockSide) + column].share += weight * shares.DensityAt(column) * ofRows.of[i];
        const float weighted = weight * ofRows.of[i];
        AddRow<Vector>(sums, PlaceOf(0, row + i - kReach), shares, weighted * value, weighted * SquareOf(value));
        if (density != nullptr)
            density += shares.end - shares.begin;
    }
}

void SpreadSums::AddSharp(int column, int row, float weight)
{
    Own& itself = own[row * int(settings.blockSide) + column];
    itself.share += weight;
    itself.weight += weight;
}

void SpreadSums::AddPlain(int column, int row, const CircleOfConfusion& circle, const Radiance& radiance, float weight)
{
    AddBy<Float4>(column, row, circle, radiance, weight);
}

void SpreadSums::AddByAvx2(int column, int row, const CircleOfConfusion& circle, const Radiance& radiance, float weight)
{
    AddBy<Float8>(column, row, circle, radiance, weight);
}

void SpreadSums::Add(int column, int row, const CircleOfConfusion& circle, const Radiance& radiance, float weight)
{
    if (HasAvx2())
        AddByAvx2(column, row, circle, radiance, weight);
    else
        AddPlain(column, row, circle, radiance, weight);
}

} // namespace tilt_lens

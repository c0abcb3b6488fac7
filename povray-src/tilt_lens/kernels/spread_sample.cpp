// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/kernels/variant.h"
#include "tilt_lens/reconstruction/blur_ellipse.h"

namespace tilt_lens::TILT_LENS_VARIANT
{

namespace
{

using Planes = SpreadPlanes;

constexpr int kReach = Planes::kReach, kMostLanes = Planes::kMostLanes;

constexpr int kRows = 2 * kReach + 1;
constexpr int kLanes = kRows + 1;
static_assert(kLanes % kMostLanes == 0, "vectors hold them without a rest");

/// Padded, since a row's last vector reads beyond it.
struct alignas(32) LaneNumbers
{
    float of[kLanes + kMostLanes]{};
};

constexpr LaneNumbers Numbered()
{
    LaneNumbers numbers{};
    for (int i = 0; i < kLanes; i++)
        numbers.of[i] = float(i - kReach);
    return numbers;
}

constexpr LaneNumbers kOffsets = Numbered();

constexpr float kWindowRadius = kReach + 1;

/// 1 - (distance / kWindowRadius)^2: without it, samples of a highlight would show as squares.
constexpr LaneNumbers WindowOf(const LaneNumbers& offsets)
{
    LaneNumbers window{};
    for (int i = 0; i < kLanes; i++)
        window.of[i] = 1.0f - offsets.of[i] * offsets.of[i] / (kWindowRadius * kWindowRadius);
    return window;
}

constexpr LaneNumbers kWindow = WindowOf(kOffsets);

TILT_LENS_INLINED Floats WindowUpTo(const Floats& distance)
{
    const Floats most = kWindowRadius - Floats(), limited = Max<Floats>(-most, Min<Floats>(most, distance));
    return limited - limited * limited * limited * (1.0f / (3.0f * kWindowRadius * kWindowRadius));
}

/// A row's window sum is the difference of this at its end and begin.
TILT_LENS_INLINED Floats WindowSumUpTo(const Floats& distance)
{
    constexpr float inverse = 1.0f / (kWindowRadius * kWindowRadius);
    return distance * ((1.0f + inverse / 12.0f) - distance * distance * (inverse / 3.0f));
}

constexpr float kInRow[2 * kMostLanes] = {1, 1, 1, 1, 1, 1, 1, 1};

/// A mask of kMostLanes: ones for the first `left` lanes, then zeros.
TILT_LENS_INLINED const float* InRow(int left)
{
    return kInRow + kMostLanes - Min(kMostLanes, left);
}

constexpr int kWidth = kVectorWidth<Floats>;

struct Extent
{
    float middle, half;  ///< pixels

    /// For each pixel within reach of `own`: integral of its window over the extent inside the picture.
    TILT_LENS_INLINED void FindSenders(int own, const PictureSpan& picture, LaneNumbers& senders) const
    {
        const float from = Max(picture.begin, middle - half), to = Min(picture.end, middle + half);
        for (int i = 0; i < kLanes; i += kWidth)
        {
            const Floats centre = Load<Floats>(kOffsets.of + i) + (float(own) + 0.5f);
            const Floats integral = WindowUpTo(to - centre) - WindowUpTo(from - centre);
            Store(senders.of + i, Max<Floats>(integral, 1.0f - Floats()));
        }
    }
};

/// Pixels at most kReach away from the sample's own, row by row.
struct CirclePixels
{
    int begin[kLanes], end[kLanes], count = 0;
    float windowOf[kLanes], windowed = 0.0f;  ///< window sums of each row, and of all
    unsigned int rows = 0;  ///< one bit per row with pixels
    Extent across{}, down{};

    TILT_LENS_INLINED void Find(const CircleOfConfusion& circle, int column, int row)
    {
        const BlurEllipse ellipse(circle);
        if (!ellipse.IsWide())
            return;
        for (int i = 0; i < kLanes; i += kWidth)
            FindRows(i, circle, column, float(row), ellipse);
        begin[kRows] = end[kRows] = 0;
        rows &= (1u << kRows) - 1;
        for (int i = 0; i < kRows; i++)
            count += end[i] - begin[i];
        Float4 sums{};
        for (int i = 0; i < kLanes; i += 4)
            sums += Load<Float4>(kWindow.of + i) * Load<Float4>(windowOf + i);
        windowed = (sums[0] + sums[1]) + (sums[2] + sums[3]);
        across = {circle.x, SquareRoot(ellipse.xx)};
        down = {circle.y, SquareRoot(ellipse.yy)};
    }

  private:
    TILT_LENS_INLINED void FindRows(int i, const CircleOfConfusion& circle, int column, float row, const BlurEllipse& ellipse)
    {
        const Floats none = Floats(), below = Load<Floats>(kOffsets.of + i) + row + 0.5f - circle.y;
        const Floats open = 1.0f - below * below / ellipse.yy;
        const Ints met = open > none;
        const Floats middle = circle.x + ellipse.lean * below - 0.5f,
                     half = SquareRoot(ellipse.determinant / ellipse.yy * (met ? open : none));
        const float left = float(column - kReach), right = float(column + kReach);
        const Floats least = Clamp(middle - half, left, right + 1.0f), most = Clamp(middle + half, left - 1.0f, right);
        Ints from = __builtin_convertvector(least, Ints), to = __builtin_convertvector(most, Ints);
        // a true comparison is -1: rounds up, and down
        from -= __builtin_convertvector(from, Floats) < least;
        to += __builtin_convertvector(to, Floats) > most;
        const Ints first = from & met, last = Max<Ints>(to + 1, from) & met;
        const float own = float(column) + 0.5f;
        Store(windowOf + i,
              WindowSumUpTo(__builtin_convertvector(last, Floats) - own) - WindowSumUpTo(__builtin_convertvector(first, Floats) - own));
        rows |= SignBits(first < last) << i;
        Store(begin + i, first);
        Store(end + i, last);
    }

    static TILT_LENS_INLINED Floats Clamp(const Floats& value, float least, float most)
    {
        return Min<Floats>(most - Floats(), Max<Floats>(least - Floats(), value));
    }
};

/// A place in the table of densities, in units of 2^-kShift cells: a row of pixels from it on cannot overflow.
constexpr int kShift = 16, kMostCells = 1024;

TILT_LENS_INLINED int FixedPlace(float cells)
{
    return int(Max(-float(kMostCells), Min(cells, float(kMostCells))) * (1 << kShift));
}

constexpr int kCountedLanes[kMostLanes] = {0, 1, 2, 3, 4, 5, 6, 7};

/// Densities along rows of pixels, from left to right.
struct CellWalk
{
    const DensityTable table;
    const int columnStep, rowStep;
    Ints columns{}, rows{};

    /// @param stepA, stepB  from pixel to pixel, in aperture coordinates
    TILT_LENS_INLINED CellWalk(const DensityTable& table, float stepA, float stepB) :
        table(table), columnStep(FixedPlace(stepA * table.scale)), rowStep(FixedPlace(stepB * table.scale))
    {
    }

    TILT_LENS_INLINED void StartAt(float a, float b)
    {
        const Ints lanes = Load<Ints>(kCountedLanes);
        columns = FixedPlace(table.PlaceOf(a)) + lanes * columnStep;
        rows = FixedPlace(table.PlaceOf(b)) + lanes * rowStep;
    }

    TILT_LENS_INLINED Floats Next()
    {
        const Ints cells = Cell(rows) * int(Settings::densityCells) + Cell(columns);
        columns += kWidth * columnStep;
        rows += kWidth * rowStep;
        Floats densities{};
        for (int lane = 0; lane < kWidth; lane++)
            densities[lane] = table.cells[cells[lane]];
        return densities;
    }

  private:
    static TILT_LENS_INLINED Ints Cell(const Ints& places)
    {
        return Max<Ints>(Ints(), Min<Ints>(int(Settings::densityCells) - 1 - Ints(), places >> kShift));
    }
};

/// For lenses other than the unit disc.
struct Densities
{
    float of[kRows * kRows + kMostLanes];  ///< of the pixels of one row after another
    float sum = 0.0f;

    TILT_LENS_INLINED void Find(const CircleOfConfusion& circle, const CirclePixels& pixels, int column, int row)
    {
        const float inverse = 1.0f / (circle.xa * circle.yb - circle.xb * circle.ya);
        CellWalk walk(circle.lens->Density(), -circle.yb * inverse, circle.ya * inverse);
        Floats sums[kMostLanes / kWidth]{};  // kMostLanes sums in all variants: the same result to the last bit
        float* to = of;
        for (unsigned int rest = pixels.rows; rest != 0; rest &= rest - 1)
        {
            const int i = __builtin_ctz(rest), begin = pixels.begin[i], count = pixels.end[i] - begin;
            const float dx = circle.x - begin - 0.5f, dy = circle.y - (row + i - kReach) - 0.5f;
            walk.StartAt((circle.yb * dx - circle.xb * dy) * inverse, (circle.xa * dy - circle.ya * dx) * inverse);
            const float* const window = kWindow.of + (begin - column + kReach);
            for (int k = 0; k < count; k += kMostLanes)
            {
                const float* const inRow = InRow(count - k);
                for (int j = 0; j < kMostLanes; j += kWidth)
                {
                    const Floats densities = walk.Next();
                    Store(to + k + j, densities);
                    sums[j / kWidth] += kWindow.of[i] * Load<Floats>(inRow + j) * Load<Floats>(window + k + j) * densities;
                }
            }
            to += count;
        }
        float lanes[kMostLanes];
        for (int j = 0; j < kMostLanes; j += kWidth)
            Store(lanes + j, sums[j / kWidth]);
        for (const float lane : lanes)
            sum += lane;
    }
};

TILT_LENS_INLINED float SquareOf(const Float4& value)
{
    return value[0] * value[0] + value[1] * value[1] + value[2] * value[2];
}

/// Shares are relative to the sample's own pixel.
struct RowShares
{
    const float* ofColumns;
    int begin, end;
    const float* density;  ///< null: uniform

    float DensityAt(int column) const { return density != nullptr ? density[column - begin] : 1.0f; }

    TILT_LENS_INLINED Floats From(int column) const
    {
        const Floats shares = Load<Floats>(InRow(end - column)) * Load<Floats>(ofColumns + column);
        return density != nullptr ? Load<Floats>(density + (column - begin)) * shares : shares;
    }
};

/// @param first    index of column 0 in a plane
/// @param value    as in Send()
TILT_LENS_INLINED void AddRow(Planes& planes, int first, const RowShares& shares, const Float4& value, float weight)
{
    const Float4 weighted = weight * value;
    const float square = weight * SquareOf(value);
    const auto add = [&planes, first](int sum, int x, const Floats& part) TILT_LENS_INLINED_LAMBDA
    {
        float* const to = planes.sums[sum] + first + x;
        Store(to, Load<Floats>(to) + part);
    };
    for (int x = shares.begin; x < shares.end; x += kWidth)
    {
        const Floats share = shares.From(x);
        for (int c = Planes::kRed; c < Planes::kShare; c++)
            add(c, x, share * weighted[c]);
        add(Planes::kShare, x, share * weighted[int(Planes::kShare)]);
        const Floats alone = share * weight;
        add(Planes::kSquaredShares, x, alone * alone);
        add(Planes::kSquares, x, share * square);
    }
}

/// @param density  null: uniform
/// @param value    red, green, blue, and CircleOfConfusion::weight
TILT_LENS_INLINED void Send(Planes& planes, const CirclePixels& pixels, const float* density, float sum, const Float4& value, float weight,
                            int column, int row)
{
    LaneNumbers ofColumns, ofRows;
    pixels.across.FindSenders(column, planes.columns, ofColumns);
    pixels.down.FindSenders(row, planes.rows, ofRows);
    const float toColumn = ofColumns.of[kReach], toRow = ofRows.of[kReach];
    for (int i = 0; i < kLanes; i += kWidth)
    {
        const Floats window = Load<Floats>(kWindow.of + i);
        Store(ofColumns.of + i, toColumn * window / Load<Floats>(ofColumns.of + i));
        Store(ofRows.of + i, toRow * window / (sum * Load<Floats>(ofRows.of + i)));
    }
    for (unsigned int rest = pixels.rows; rest != 0; rest &= rest - 1)
    {
        const int i = __builtin_ctz(rest);
        const RowShares shares{ofColumns.of - (column - kReach), pixels.begin[i], pixels.end[i], density};
        if (i == kReach && column >= shares.begin && column < shares.end)
            planes.own[row * int(Settings::blockSide) + column].share += weight * shares.DensityAt(column) * ofRows.of[i];
        const float weighted = weight * ofRows.of[i];
        AddRow(planes, Planes::PlaceOf(0, row + i - kReach), shares, value, weighted);
        if (density != nullptr)
            density += shares.end - shares.begin;
    }
}

} // namespace

bool SpreadSample(Planes& planes, int column, int row, const CircleOfConfusion& circle, const double* radiance, float weight)
{
    const Float4 value = {float(radiance[0]), float(radiance[1]), float(radiance[2]), circle.weight};
    CirclePixels pixels;
    if (IsFinite(SquareOf(value)))
        pixels.Find(circle, column, row);
    const bool shaped = pixels.count > 1 && !circle.lens->IsDisc();
    float sum = pixels.windowed;
    Densities densities;
    if (shaped)
    {
        densities.Find(circle, pixels, column, row);
        sum = densities.sum;
    }
    if (pixels.count <= 1 || !(sum > 0.0f))
        return false;
    planes.spread = true;
    planes.own[row * int(Settings::blockSide) + column].weight += weight;
    Send(planes, pixels, shaped ? densities.of : nullptr, sum, value, weight, column, row);
    return true;
}

} // namespace tilt_lens::TILT_LENS_VARIANT

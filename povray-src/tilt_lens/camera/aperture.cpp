// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/camera/aperture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace tilt_lens
{

namespace
{

constexpr double pi = 3.14159265358979323846;

/// @name Sine and cosine for |x| <= pi/4, by their Taylor series; the first term left out is below
/// 3e-14. In place of the C library's: faster, and the same on every machine.
/// @{
inline double SmallSin(double x)
{
    const double s = x * x;
    return x * (1 + s * (-1.0 / 6 +
                         s * (1.0 / 120 + s * (-1.0 / 5040 + s * (1.0 / 362880 +
                                                                  s * (-1.0 / 39916800 +
                                                                       s * (1.0 / 6227020800)))))));
}

inline double SmallCos(double x)
{
    const double s = x * x;
    return 1 + s * (-1.0 / 2 +
                    s * (1.0 / 24 + s * (-1.0 / 720 + s * (1.0 / 40320 +
                                                           s * (-1.0 / 3628800 +
                                                                s * (1.0 / 479001600 +
                                                                     s * (-1.0 / 87178291200)))))));
}
/// @}

/// The concentric map in polar form. The square [-1, 1]^2 consists of concentric squares, which
/// become concentric circles, in four quarters: right and left of the diagonals, above and below.
struct Concentric
{
    bool sideways;  ///< in the right or left quarter
    double radius;  ///< its sign is that of the main coordinate
    double slope;  ///< in [-1, 1]: 4/pi of the angle from the quarter's axis towards the other axis
};

inline Concentric ToConcentric(double u, double v)
{
    const double x = 2 * u - 1, y = 2 * v - 1;
    const bool sideways = std::fabs(x) > std::fabs(y);
    const double main = sideways ? x : y, other = sideways ? y : x;
    return {sideways, main, main != 0 ? other / main : 0.0};
}

inline AperturePoint OnDisc(double u, double v)
{
    const Concentric c = ToConcentric(u, v);
    const double angle = pi / 4 * c.slope;
    const double along = c.radius * SmallCos(angle), across = c.radius * SmallSin(angle);
    return c.sideways ? AperturePoint{along, across} : AperturePoint{across, along};
}

}  // namespace

struct Aperture::Outline
{
    int blades;
    std::vector<AperturePoint> corner;  ///< one more than blades: the first one again at the end

    AperturePoint Map(double u, double v) const
    {
        const Concentric c = ToConcentric(u, v);
        double turns = c.sideways ? c.slope / 8 : 0.25 - c.slope / 8;
        if (c.radius < 0)
            turns += 0.5;
        if (turns < 0)
            turns += 1;

        // Rounding may reach a whole turn: that is the end of the last edge.
        const double position = turns * blades;
        const int edge = std::min(static_cast<int>(position), blades - 1);
        const double t = position - edge, radius = std::fabs(c.radius);
        const AperturePoint &p = corner[edge], &q = corner[edge + 1];
        return {radius * (p.a + t * (q.a - p.a)), radius * (p.b + t * (q.b - p.b))};
    }

    double Density(const AperturePoint& point) const
    {
        const double first = std::atan2(corner[0].b, corner[0].a);
        double turns = (std::atan2(point.b, point.a) - first) / (2 * pi);
        turns -= std::floor(turns);
        const int edge = std::min(static_cast<int>(turns * blades), blades - 1);
        const AperturePoint &p = corner[edge], &q = corner[edge + 1];
        const double side = (q.a - p.a) * (point.b - p.b) - (q.b - p.b) * (point.a - p.a);
        return side >= 0 ? 2 / (blades * std::sin(2 * pi / blades)) : 0.0;
    }
};

namespace
{

constexpr int cells = 256;

/// A piecewise constant distribution over [0, 1] in equal cells, inverted in constant expected time
/// with H.-C. Chen and Y. Asau's index table (1974).
class CellDistribution
{
  public:
    /// @return the total weight; 0 leaves a distribution that must not be sampled
    double Build(const double* weight)
    {
        double total = 0;
        for (int i = 0; i < cells; ++i)
            total += weight[i];
        double sum = 0;  // ends exactly at total, so cells without weight at the end begin at 1
        for (int i = 0; i < cells; ++i)
        {
            bound[i] = total > 0 ? static_cast<float>(sum / total) : 0.0f;
            sum += weight[i];
        }
        bound[cells] = 1.0f;

        int cell = 0;
        for (int i = 0; i < cells; ++i)
        {
            while (bound[cell + 1] <= static_cast<float>(i) / cells)
                ++cell;
            first[i] = static_cast<std::uint8_t>(cell);
        }
        return total;
    }

    struct Place
    {
        int cell;
        double position;  ///< in [0, 1]
    };

    /// The value below which lies the part u, in [0, 1), of the weight.
    Place Invert(double u) const
    {
        int cell = first[static_cast<int>(u * cells)];
        while (bound[cell + 1] <= u)
            ++cell;
        const double low = bound[cell], high = bound[cell + 1];
        return {cell, (cell + (u - low) / (high - low)) * (1.0 / cells)};
    }

    /// Density at a position, 1 being that of an even distribution.
    double Density(double position) const
    {
        const int cell = std::min(static_cast<int>(position * cells), cells - 1);
        return (double(bound[cell + 1]) - bound[cell]) * cells;
    }

  private:
    /// Part of the weight below each cell. Single precision keeps a picture within the processor's
    /// second cache; a cell with less than 1e-7 of its column is lost in black anyway.
    std::array<float, cells + 1> bound;
    std::array<std::uint8_t, cells> first;  ///< cell where the search for i/cells begins
};

/// Mean weight of every cell: columns of constant u, v along each column.
class Tabulation
{
  public:
    explicit Tabulation(const std::function<double(double u, double v)>& itsWeight)
        : weight(itsWeight), coarse(cells * cells), mean(cells * cells)
    {
        for (int i = 0; i < cells; ++i)
            for (int j = 0; j < cells; ++j)
                coarse[i * cells + j] = Survey(i, j, 2);
        for (const Range& range : coarse)
            brightest = std::max(brightest, range.high);
        for (int i = 0; i < cells; ++i)
            for (int j = 0; j < cells; ++j)
                mean[i * cells + j] =
                    Varies(i, j) ? Survey(i, j, 4).mean : coarse[i * cells + j].mean;
    }

    const double* Column(int i) const { return &mean[i * cells]; }

    /// Scales the greatest mean to 1, so that no sum overflows.
    /// @return false if there is none above 0
    bool Normalize()
    {
        const double greatest = *std::max_element(mean.begin(), mean.end());
        if (!(greatest > 0))
            return false;
        for (double& m : mean)
            m /= greatest;
        return true;
    }

  private:
    struct Range
    {
        double low, high, mean;
    };

    double Sanitized(double u, double v) const
    {
        const double w = weight(u, v);
        return std::isfinite(w) && w > 0 ? w : 0.0;
    }

    /// The weights at side x side places spread evenly over a cell.
    Range Survey(int i, int j, int side) const
    {
        Range range{HUGE_VAL, 0, 0};
        for (int k = 0; k < side; ++k)
            for (int l = 0; l < side; ++l)
            {
                const double w =
                    Sanitized((i + (k + 0.5) / side) / cells, (j + (l + 0.5) / side) / cells);
                range.low = std::min(range.low, w);
                range.high = std::max(range.high, w);
                range.mean += w / (side * side);
            }
        return range;
    }

    /// Whether the weights in a cell and the cells around it differ by more than 1/16 of the
    /// brightest: an edge runs near.
    bool Varies(int i, int j) const
    {
        double low = HUGE_VAL, high = 0;
        for (int k = std::max(i - 1, 0); k <= std::min(i + 1, cells - 1); ++k)
            for (int l = std::max(j - 1, 0); l <= std::min(j + 1, cells - 1); ++l)
            {
                low = std::min(low, coarse[k * cells + l].low);
                high = std::max(high, coarse[k * cells + l].high);
            }
        return high - low > brightest / 16;
    }

    const std::function<double(double u, double v)>& weight;
    std::vector<Range> coarse;
    double brightest = 0;
    std::vector<double> mean;
};

}  // namespace

struct Aperture::Table
{
    CellDistribution marginal;
    std::vector<CellDistribution> conditional;  ///< of each column

    AperturePoint Map(double u, double v) const
    {
        const CellDistribution::Place column = marginal.Invert(u);
        const CellDistribution::Place row = conditional[column.cell].Invert(v);
        return {2 * column.position - 1, 1 - 2 * row.position};
    }

    double Density(const AperturePoint& point) const
    {
        const double u = (point.a + 1) / 2, v = (1 - point.b) / 2;
        if (!(u >= 0 && u <= 1 && v >= 0 && v <= 1))
            return 0.0;
        const int column = std::min(static_cast<int>(u * cells), cells - 1);
        return marginal.Density(u) * conditional[column].Density(v) / 4;
    }
};

Aperture Aperture::Disc()
{
    return Aperture(Shape::Disc);
}

Aperture Aperture::Polygon(int blades, double angleRadians)
{
    if (blades < 3 || blades > maxBlades)
        throw std::invalid_argument(
            "The number of diaphragm blades makes no opening. Found: " + std::to_string(blades) +
            ". Allowed: 3 to " + std::to_string(maxBlades) +
            ". Give another number, or none for a round opening.");
    if (!std::isfinite(angleRadians))
        throw std::invalid_argument(
            "The angle of the diaphragm blades is not a finite number. Found: " +
            std::to_string(angleRadians) + ". Allowed: any finite angle. Correct or omit it.");

    auto outline = std::make_shared<Outline>();
    outline->blades = blades;
    for (int i = 0; i < blades; ++i)
    {
        const double angle = angleRadians + 2 * pi * i / blades;
        outline->corner.push_back({std::cos(angle), std::sin(angle)});
    }
    outline->corner.push_back(outline->corner.front());

    Aperture aperture(Shape::Polygon);
    aperture.outline = std::move(outline);
    return aperture;
}

Aperture Aperture::Picture(const std::function<double(double u, double v)>& weight)
{
    Tabulation tabulation(weight);
    if (!tabulation.Normalize())
        throw std::invalid_argument(
            "The picture of the lens opening lets no light through. Found: 0, negative or not "
            "finite at every place. Allowed: brightness above 0 somewhere between <0,0> and <1,1>. "
            "Use a pigment that is not black there, or none for a round opening.");

    auto table = std::make_shared<Table>();
    table->conditional.resize(cells);
    std::array<double, cells> total;
    for (int i = 0; i < cells; ++i)
        total[i] = table->conditional[i].Build(tabulation.Column(i));
    table->marginal.Build(total.data());

    Aperture aperture(Shape::Picture);
    aperture.table = std::move(table);
    return aperture;
}

AperturePoint Aperture::operator()(double u, double v) const
{
    switch (shape)
    {
    case Shape::Disc:
        break;
    case Shape::Polygon:
        return outline->Map(u, v);
    case Shape::Picture:
        return table->Map(u, v);
    }
    return OnDisc(u, v);
}

double Aperture::Density(const AperturePoint& point) const
{
    switch (shape)
    {
    case Shape::Disc:
        break;
    case Shape::Polygon:
        return outline->Density(point);
    case Shape::Picture:
        return table->Density(point);
    }
    return point.a * point.a + point.b * point.b <= 1 ? 1 / pi : 0.0;
}

double Aperture::BoundingRadius() const
{
    return shape == Shape::Picture ? std::sqrt(2.0) : 1.0;
}

}  // namespace tilt_lens

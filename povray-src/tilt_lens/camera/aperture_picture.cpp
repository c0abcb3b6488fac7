// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/camera/aperture_picture.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace tilt_lens
{

namespace
{

constexpr int cells = CellDistribution::cells;

/// Means, column by column.
class Tabulation
{
  public:
    explicit Tabulation(const std::function<double(double u, double v)>& itsWeight) :
        weight(itsWeight), coarse(cells * cells), mean(cells * cells)
    {
        for (int i = 0; i < cells; ++i)
            for (int j = 0; j < cells; ++j)
                coarse[i * cells + j] = Survey(i, j, 2);
        for (const Range& range : coarse)
            brightest = std::max(brightest, range.high);
        for (int i = 0; i < cells; ++i)
            for (int j = 0; j < cells; ++j)
                mean[i * cells + j] = Varies(i, j) ? Survey(i, j, 4).mean : coarse[i * cells + j].mean;
    }

    const double* Column(int i) const { return &mean[i * cells]; }

    /// Keeps sums from overflow; false if no mean is positive.
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

    Range Survey(int i, int j, int side) const
    {
        Range range{HUGE_VAL, 0, 0};
        for (int k = 0; k < side; ++k)
            for (int l = 0; l < side; ++l)
            {
                const double w = Sanitized((i + (k + 0.5) / side) / cells, (j + (l + 0.5) / side) / cells);
                range.low = std::min(range.low, w);
                range.high = std::max(range.high, w);
                range.mean += w / (side * side);
            }
        return range;
    }

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

} // namespace

double CellDistribution::Build(const double* weight)
{
    double total = 0;
    for (int i = 0; i < cells; ++i)
        total += weight[i];
    double sum = 0;  // ends as total, so that trailing cells without weight begin at 1
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

CellDistribution::Place CellDistribution::Invert(double u) const
{
    int cell = first[static_cast<int>(u * cells)];
    while (bound[cell + 1] <= u)
        ++cell;
    const double low = bound[cell], high = bound[cell + 1];
    return {cell, (cell + (u - low) / (high - low)) * (1.0 / cells)};
}

double CellDistribution::Density(double position) const
{
    const int cell = std::min(static_cast<int>(position * cells), cells - 1);
    return (double(bound[cell + 1]) - bound[cell]) * cells;
}

AperturePicture::AperturePicture(const std::function<double(double u, double v)>& weight) : conditional(cells)
{
    Tabulation tabulation(weight);
    if (!tabulation.Normalize())
        throw std::invalid_argument("The picture of the lens opening lets no light through. Found: 0, negative or not "
                                    "finite at every place. Allowed: brightness above 0 somewhere between <0,0> and <1,1>. "
                                    "Use a pigment that is not black there, or none for a round opening.");
    std::array<double, cells> total;
    for (int i = 0; i < cells; ++i)
        total[i] = conditional[i].Build(tabulation.Column(i));
    marginal.Build(total.data());
}

AperturePoint AperturePicture::Map(double u, double v) const
{
    const CellDistribution::Place column = marginal.Invert(u);
    const CellDistribution::Place row = conditional[column.cell].Invert(v);
    return {2 * column.position - 1, 1 - 2 * row.position};
}

double AperturePicture::Density(const AperturePoint& point) const
{
    const double u = (point.a + 1) / 2, v = (1 - point.b) / 2;
    if (!(u >= 0 && u <= 1 && v >= 0 && v <= 1))
        return 0.0;
    const int column = std::min(static_cast<int>(u * cells), cells - 1);
    return marginal.Density(u) * conditional[column].Density(v) / 4;
}

} // namespace tilt_lens

// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "measure.h"

#include <algorithm>
#include <cmath>

namespace witness
{

namespace
{

const int kLocalBox = 8;

template<class Visit>
void ForEachBox(const Picture& picture, int box, Visit visit)
{
    std::vector<std::size_t> indices;
    for (int top = 0; top < picture.height; top += box)
        for (int left = 0; left < picture.width; left += box)
            for (int channel = 0; channel < 3; ++channel)
            {
                indices.clear();
                for (int y = top; y < std::min(top + box, picture.height); ++y)
                    for (int x = left; x < std::min(left + box, picture.width); ++x)
                        indices.push_back((static_cast<std::size_t>(y) * picture.width + x) * 3 + channel);
                visit(indices);
            }
}

} // namespace

bool IsFinite(const Picture& picture)
{
    return std::all_of(picture.values.begin(), picture.values.end(), [](double v) { return std::isfinite(v); });
}

Figures Measure(const Picture& picture, const Picture& reference, std::size_t worstCount)
{
    Figures figures;
    double squares = 0.0, sum = 0.0;
    for (std::size_t pixel = 0; pixel < picture.Size() / 3; ++pixel)
    {
        PixelDifference worst{static_cast<int>(pixel % picture.width), static_cast<int>(pixel / picture.width), 0.0};
        for (std::size_t i = 3 * pixel; i < 3 * pixel + 3; ++i)
        {
            const double difference = picture.values[i] - reference.values[i];
            squares += difference * difference;
            sum += difference;
            if (std::fabs(difference) > std::fabs(worst.difference))
                worst.difference = difference;
        }
        if (worst.difference != 0.0)
        {
            ++figures.different;
            figures.worst.push_back(worst);
        }
    }
    const double count = static_cast<double>(picture.Size());
    figures.rootMeanSquare = std::sqrt(squares / count);
    figures.signedMean = sum / count;

    const std::size_t kept = std::min(worstCount, figures.worst.size());
    std::partial_sort(figures.worst.begin(), figures.worst.begin() + kept, figures.worst.end(),
                      [](const PixelDifference& a, const PixelDifference& b) { return std::fabs(a.difference) > std::fabs(b.difference); });
    figures.worst.resize(kept);
    figures.largest = figures.worst.empty() ? 0.0 : std::fabs(figures.worst.front().difference);

    ForEachBox(picture, kLocalBox, [&](const std::vector<std::size_t>& box)
    {
        double local = 0.0;
        for (const std::size_t i : box)
            local += picture.values[i] - reference.values[i];
        figures.largestLocalMean = std::max(figures.largestLocalMean, std::fabs(local) / box.size());
    });
    return figures;
}

double SidakLimit(double significance, double count)
{
    // 1 - (1 - p)^(1/n) accurately, then bisection
    const double each = -std::expm1(std::log1p(-significance) / count);
    double low = 0.0, high = 40.0;
    while (high - low > 1e-10)
    {
        const double middle = 0.5 * (low + high);
        (std::erfc(middle / std::sqrt(2.0)) > each ? low : high) = middle;
    }
    return high;
}

ZTest TestNoisy(const Picture& picture, const Reference& reference, const ZTestSettings& settings)
{
    // one sample has `batches` times the variance of the mean
    std::vector<double> deviation(picture.Size());
    for (std::size_t i = 0; i < picture.Size(); ++i)
        deviation[i] = std::max(settings.floor, reference.error.values[i] * std::sqrt(1.0 + reference.batches));

    ZTest result;
    const double pixels = static_cast<double>(picture.Size() / 3);
    result.pixelLimit = SidakLimit(settings.significance, static_cast<double>(picture.Size()));
    std::size_t passing = 0;
    for (std::size_t pixel = 0; pixel < picture.Size() / 3; ++pixel)
    {
        double z = 0.0;
        for (std::size_t i = 3 * pixel; i < 3 * pixel + 3; ++i)
            z = std::max(z, std::fabs(picture.values[i] - reference.mean.values[i]) / deviation[i]);
        result.largest = std::max(result.largest, z);
        passing += z <= result.pixelLimit ? 1 : 0;
    }
    result.passing = static_cast<double>(passing) / pixels;

    double boxes = 0.0;
    ForEachBox(picture, settings.box, [&](const std::vector<std::size_t>& box)
    {
        double sum = 0.0, variance = 0.0;
        for (const std::size_t i : box)
        {
            sum += picture.values[i] - reference.mean.values[i];
            variance += deviation[i] * deviation[i];
        }
        result.largestBox = std::max(result.largestBox, std::fabs(sum) / std::sqrt(variance));
        boxes += 1.0;
    });
    result.boxLimit = SidakLimit(settings.significance, boxes);
    result.passed = result.passing >= settings.passing && result.largestBox <= result.boxLimit;
    return result;
}

} // namespace witness

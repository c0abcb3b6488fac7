// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file sampler.cpp
/// `stress_sampler LOG2_SAMPLES` writes JSON: quality of 2-D projections up to 2^LOG2_SAMPLES samples, repeats, the index's end, the
/// lens pair's star discrepancy, correlation of neighbours.
///
/// Bounds: a (0, m, 2)-net in base 2 has N D* <= m/2 + 3/2 (H. Niederreiter, "Random Number Generation and Quasi-Monte Carlo Methods",
/// 1992, theorem 4.7); Hammersley's N = 2^m points have N D* = m/3 + 13/9 - (-1)^m 4/(9 N) (J. H. Halton, S. K. Zaremba, "The extreme and
/// L2 discrepancies of some plane sets", 1969).

#include <algorithm>
#include <cmath>
#include <iostream>
#include <random>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "tilt_lens/samples/sequence.h"

namespace
{

using nlohmann::json;
using tilt_lens::PixelSampler;

struct Point
{
    double x, y;
};

double Coordinate(const tilt_lens::SequencePoint& s, int dimension)
{
    const double all[] = {s.lensU, s.lensV, s.pixelX, s.pixelY};
    return all[dimension];
}

std::vector<Point> Projection(const PixelSampler& sampler, int d, int e, std::uint32_t count)
{
    std::vector<Point> points;
    points.reserve(count);
    for (std::uint32_t i = 0; i < count; i++)
    {
        const tilt_lens::SequencePoint s = sampler(i);
        points.push_back({Coordinate(s, d), Coordinate(s, e)});
    }
    return points;
}

bool IsEven(const std::vector<Point>& points, int i, int j)
{
    std::vector<std::uint32_t> count(std::size_t(1) << (i + j));
    for (const Point& p : points)
        count[(std::size_t(std::ldexp(p.x, i)) << j) + std::size_t(std::ldexp(p.y, j))]++;
    const std::uint32_t each = std::uint32_t(points.size() / count.size());
    return std::all_of(count.begin(), count.end(), [each](std::uint32_t c) { return c == each; });
}

/// The least t of a (t, m, 2)-net in base 2.
int Quality(const std::vector<Point>& points, int m)
{
    for (int t = 0; t < m; t++)
    {
        bool even = true;
        for (int i = 0; even && i <= m - t; i++)
            even = IsEven(points, i, m - t - i);
        if (even)
            return t;
    }
    return m;
}

/// Exact, over open and closed boxes with corners at coordinates of points.
double StarDiscrepancy(std::vector<Point> points)
{
    std::sort(points.begin(), points.end(), [](const Point& a, const Point& b) { return a.x < b.x; });
    const double n = double(points.size());
    std::vector<double> ys = {0.0, 1.0};
    double worst = 0.0;
    for (std::size_t i = 0; i <= points.size(); i++)
    {
        const double right = i < points.size() ? points[i].x : 1.0, left = i > 0 ? points[i - 1].x : 0.0;
        for (std::size_t j = 0; j + 1 < ys.size(); j++)
        {
            // j points lie below ys[j + 1] in the open box, at most j at or below ys[j]
            worst = std::max(worst, ys[j + 1] * right - double(j) / n);
            worst = std::max(worst, double(j) / n - ys[j] * left);
        }
        if (i < points.size())
            ys.insert(std::upper_bound(ys.begin(), ys.end() - 1, points[i].y), points[i].y);
    }
    return worst;
}

std::vector<Point> Hammersley(int m)
{
    std::vector<Point> points;
    for (std::uint32_t i = 0; i < (1u << m); i++)
    {
        double y = 0.0;
        for (int bit = 0; bit < m; bit++)
            y += (i >> bit & 1) * std::ldexp(1.0, -bit - 1);
        points.push_back({std::ldexp(double(i), -m), y});
    }
    return points;
}

json Discrepancies(int most)
{
    json rows = json::array();
    std::mt19937_64 engine(5);
    for (int m = 4; m <= most; m += 2)
    {
        const double n = std::ldexp(1.0, m);
        double worst = 0.0, mean = 0.0, random = 0.0;
        const int pixels = m <= 10 ? 16 : 4;
        for (int p = 0; p < pixels; p++)
        {
            const double d = StarDiscrepancy(Projection(PixelSampler(p * 7919, p * 104729, 3), 0, 1, 1u << m)) * n;
            worst = std::max(worst, d);
            mean += d / pixels;
            std::vector<Point> points;
            for (int i = 0; i < (1 << m); i++)
            {
                const double x = double(engine() >> 11) * 0x1p-53, y = double(engine() >> 11) * 0x1p-53;
                points.push_back({x, y});
            }
            random += StarDiscrepancy(points) * n / pixels;
        }
        const double known = m / 3.0 + 13.0 / 9.0 - (m % 2 ? -1.0 : 1.0) * 4.0 / (9.0 * n);
        rows.push_back({{"m", m},
                        {"mean", mean},
                        {"worst", worst},
                        {"bound", m / 2.0 + 1.5},
                        {"random", random},
                        {"hammersley", StarDiscrepancy(Hammersley(m)) * n},
                        {"hammersley_known", known}});
    }
    return rows;
}

std::uint64_t Repeated(const PixelSampler& sampler, int dimension, std::uint32_t count)
{
    std::vector<double> values;
    for (std::uint32_t i = 0; i < count; i++)
        values.push_back(Coordinate(sampler(i), dimension));
    std::sort(values.begin(), values.end());
    return count - std::uint64_t(std::unique(values.begin(), values.end()) - values.begin());
}

std::uint64_t OverflowFaults(const PixelSampler& sampler)
{
    std::uint64_t wrong = 0;
    for (std::uint32_t middle : {1u << 20, 1u << 31, 0u})
        for (std::uint32_t i = middle - 1000; i != middle + 1000; i++)
            for (int d = 0; d < 4; d++)
            {
                const double c = Coordinate(sampler(i), d);
                wrong += !(c > 0.0 && c < 1.0) || c == Coordinate(sampler(i + 1), d);
            }
    return wrong;
}

/// Largest correlation, in standard errors.
double NeighbourCorrelation(int samples, std::uint32_t dx, std::uint32_t dy, std::uint32_t side)
{
    double worst = 0.0;
    for (int kind = 0; kind < 3; kind++)
    {
        const auto error = [&](std::uint32_t x, std::uint32_t y)
        {
            const PixelSampler sampler(x, y, 11);
            double sum = 0.0;
            for (int i = 0; i < samples; i++)
            {
                const tilt_lens::SequencePoint s = sampler(std::uint32_t(i));
                const double value = kind == 0   ? double(s.pixelX + s.pixelY > 1.0) - 0.5
                                     : kind == 1 ? double(s.lensU + s.pixelX > 1.0) - 0.5
                                                 : s.lensU * s.lensV - 0.25;
                sum += value;
            }
            return sum;
        };
        double sum = 0.0, squares = 0.0;
        for (std::uint32_t y = 0; y < side; y++)
            for (std::uint32_t x = 0; x < side; x++)
            {
                const double product = error(3 * x, 3 * y) * error(3 * x + dx, 3 * y + dy);
                sum += product;
                squares += product * product;
            }
        worst = std::max(worst, std::fabs(sum) / std::sqrt(squares));
    }
    return worst;
}

} // namespace

int main(int argc, char** argv)
{
    const int most = argc == 2 ? std::stoi(argv[1]) : 0;
    if (most < 8 || most > 24)
    {
        std::cerr << "usage: stress_sampler LOG2_SAMPLES, 8 to 24\n";
        return 2;
    }
    const char* const names[] = {"lens u", "lens v", "pixel x", "pixel y"};
    json projections = json::array(), repeated = json::array();
    const PixelSampler sampler(123, 456, 0);
    for (int d = 0; d < 4; d++)
    {
        repeated.push_back(Repeated(sampler, d, 1u << most));
        for (int e = d + 1; e < 4; e++)
        {
            json quality = json::object();
            for (int m = 4; m <= most; m += 4)
                quality[std::to_string(m)] = Quality(Projection(sampler, d, e, 1u << m), m);
            projections.push_back({{"pair", std::string(names[d]) + ", " + names[e]}, {"t", quality}});
        }
    }
    json correlation = json::array();
    for (int samples : {1, 8, 64})
        correlation.push_back({{"samples", samples},
                               {"right", NeighbourCorrelation(samples, 1, 0, most * 5u)},
                               {"below", NeighbourCorrelation(samples, 0, 1, most * 5u)},
                               {"diagonal", NeighbourCorrelation(samples, 1, 1, most * 5u)}});
    std::cout << json({{"log2_samples", most},
                       {"projections", projections},
                       {"repeated", repeated},
                       {"overflow_faults", OverflowFaults(sampler)},
                       {"correlation", correlation},
                       {"discrepancy", Discrepancies(std::min(most, 12))}})
                     .dump(1)
              << '\n';
    return 0;
}

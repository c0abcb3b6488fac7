// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file sharp_plane_test.cpp
/// Compares the least greatest blur with brute force.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "random_cameras.h"
#include "tilt_lens/camera/sharp_plane.h"

namespace tilt_lens
{

namespace
{

using Equations = std::vector<VergenceEquation>;

Equations EquationsOf(const std::vector<Vec3>& points)
{
    std::vector<RealVec> exact;
    for (const Vec3& p : points)
        exact.push_back({p.x, p.y, p.z});
    return VergenceEquations(exact, points, {});
}

std::string Listed(const std::vector<Vec3>& points)
{
    std::ostringstream text;
    text << std::setprecision(17);
    for (const Vec3& p : points)
        text << p << ' ';
    return text.str();
}

Real Volume(const RealVec& a, const RealVec& b, const RealVec& c)
{
    return Dot(Cross(a, b), c);
}

Real DeviationOf(const Equations& e, const std::size_t (&at)[4])
{
    const RealVec &a = e[at[0]].direction, &b = e[at[1]].direction, &c = e[at[2]].direction, &d = e[at[3]].direction;
    const Real weights[4] = {Volume(b, c, d), -Volume(a, c, d), Volume(a, b, d), -Volume(a, b, c)};
    Real sum = 0, scale = 0;
    for (int i = 0; i < 4; i++)
    {
        sum += weights[i] * e[at[i]].vergence;
        scale += abs(weights[i]);
    }
    return scale > 0 ? Real(abs(sum) / scale) : Real(0);
}

/// By duality, the greatest deviation of a set of four.
Real BruteForce(const Equations& e)
{
    Real greatest = 0;
    for (std::size_t i = 0; i < e.size(); i++)
        for (std::size_t j = i + 1; j < e.size(); j++)
            for (std::size_t k = j + 1; k < e.size(); k++)
                for (std::size_t l = k + 1; l < e.size(); l++)
                    greatest = std::max<Real>(greatest, DeviationOf(e, {i, j, k, l}));
    return greatest;
}

double Relative(const Real& a, const Real& b)
{
    return double(abs(a - b) / b);
}

std::vector<Vec3> RandomPoints(Random& random, int count, double width, double farthest)
{
    std::vector<Vec3> points;
    for (int i = 0; i < count; i++)
    {
        const double z = random(1.0, farthest);
        points.push_back({random(-width, width) * z, random(-width, width) * z, z});
    }
    return points;
}

void ExpectLocalMinimum(Random& random, const Equations& equations, const RealVec& k)
{
    const Real least = GreatestResidual(equations, k);
    for (int i = 0; i < 50; i++)
    {
        const Vec3 way = random.Direction();
        const double size = random.Power(-12.0, -1.0) * double(Length(k));
        const RealVec moved = k + size * RealVec{way.x, way.y, way.z};
        EXPECT_GE(double(GreatestResidual(equations, moved) / least), 1.0);
    }
}

} // namespace

TEST(SharpPlane, HasLeastGreatestBlurOfRandomSets)
{
    Random random(1);
    for (int i = 0; i < 2400; i++)
    {
        const std::vector<Vec3> points = RandomPoints(random, i % 100 == 0 ? 12 : 4 + i % 3, 0.5, random.Power(0.1, 3.0));
        const Equations equations = EquationsOf(points);
        const RealVec k = LeastGreatestBlur(equations);
        ASSERT_LT(Relative(GreatestResidual(equations, k), BruteForce(equations)), 1e-20) << Listed(points);
        if (i % 50 == 0)
            ExpectLocalMinimum(random, equations, k);
    }
}

TEST(SharpPlane, HasLeastGreatestBlurOfManyPoints)
{
    Random random(2);
    for (int i = 0; i < 3; i++)
    {
        const Equations equations = EquationsOf(RandomPoints(random, 40, 0.5, 20.0));
        ASSERT_LT(Relative(GreatestResidual(equations, LeastGreatestBlur(equations)), BruteForce(equations)), 1e-20);
    }
    const Equations equations = EquationsOf(RandomPoints(random, 100, 0.5, 20.0));
    ExpectLocalMinimum(random, equations, LeastGreatestBlur(equations));
}

TEST(SharpPlane, HoldsFromAMillionToOneOn)
{
    // almost in a plane, within a microradian, almost on a line, far and near at once
    Random random(3);
    for (int i = 0; i < 1200; i++)
    {
        std::vector<Vec3> points = RandomPoints(random, 4 + i % 3, i % 4 == 1 ? 1e-6 : 0.5, i % 4 == 3 ? 1e6 : 10.0);
        for (Vec3& p : points)
            if (i % 4 == 0)
                p = p / (0.1 * p.x + 0.05 * p.y + p.z) * (5.0 + 5e-6 * random(-1.0, 1.0));
            else if (i % 4 == 2)
                p.y = 0.3 * p.x + 0.1 * p.z + 1e-6 * p.y;
        const Equations equations = EquationsOf(points);
        ASSERT_LT(Relative(GreatestResidual(equations, LeastGreatestBlur(equations)), BruteForce(equations)), 1e-10) << Listed(points);
    }
}

TEST(SharpPlane, DoesNotDependOnOrderOrDuplicates)
{
    Random random(4);
    for (int i = 0; i < 300; i++)
    {
        std::vector<Vec3> points = RandomPoints(random, 5, 0.5, 10.0);
        const RealVec k = LeastGreatestBlur(EquationsOf(points));
        std::reverse(points.begin(), points.end());
        points.push_back(points[i % 5]);
        points.push_back(points[2]);
        const RealVec other = LeastGreatestBlur(EquationsOf(points));
        ASSERT_LT(double(Length(k - other) / Length(k)), 1e-20) << Listed(points);
    }
}

TEST(SharpPlane, PassesThroughAllPointsOfAPlane)
{
    Random random(5);
    for (int i = 0; i < 300; i++)
    {
        const RealVec k{random(-0.1, 0.1), random(-0.1, 0.1), random(0.05, 1.0)};
        Equations equations;
        for (int j = 0; j < 3 + i % 5; j++)
        {
            const RealVec direction{random(-0.5, 0.5), random(-0.5, 0.5), 1};
            equations.push_back({direction, Dot(k, direction)});
        }
        ASSERT_LT(double(Length(LeastGreatestBlur(equations) - k)), 1e-25) << i;
    }
}

/// Three points on a line leave a choice of planes to the others.
TEST(SharpPlane, ServesOtherPointsWhereThreeBind)
{
    Random random(6);
    for (int i = 0; i < 300; i++)
    {
        Equations equations;
        for (int j = 0; j < 3; j++)
            equations.push_back({{j - 1.0, 0, 1}, j == 1 ? 2 : 1});
        const int others = 1 + i % 3;
        for (int j = 0; j < others; j++)
            equations.push_back({{random(-0.5, 0.5), random(0.1, 0.5), 1}, Real(1.5) + random(-0.2, 0.2)});
        const RealVec k = LeastGreatestBlur(equations);
        ASSERT_EQ(double(GreatestResidual(equations, k)), 0.5);
        ASSERT_LT(double(abs(k.x)) + double(abs(k.z - Real(1.5))), 1e-25);
        // an optimum of k.y alone, over pairs
        const Equations rest(equations.begin() + 3, equations.end());
        Real least = 0;
        for (const VergenceEquation& a : rest)
            for (const VergenceEquation& b : rest)
            {
                const Real va = a.vergence - Real(1.5), vb = b.vergence - Real(1.5);
                least = std::max<Real>(least, abs(va * b.direction.y - vb * a.direction.y) / (a.direction.y + b.direction.y));
            }
        ASSERT_NEAR(double(GreatestResidual(rest, k)), double(least), 1e-25) << i;
    }
}

TEST(SharpPlane, TakesTheMiddleOfPointsOnOneRay)
{
    Equations equations{{{0, 0, 1}, 1}, {{0, 0, 1}, 2}, {{0, 0, 1}, Real(1.25)}, {{0.5, 0, 1}, 1}, {{0, 0.5, 1}, 1}};
    const RealVec k = LeastGreatestBlur(equations);
    EXPECT_EQ(double(k.z), 1.5);
    EXPECT_EQ(double(k.x), -1.0);
    EXPECT_EQ(double(k.y), -1.0);
}

TEST(SharpPlane, RefusesPointsThatLeaveAChoice)
{
    const auto error = [](const std::vector<Vec3>& points) -> std::string
    {
        try
        {
            EquationsOf(points);
            return "";
        }
        catch (const OpticsError& e)
        {
            return e.what();
        }
    };
    const auto says = [&](const std::vector<Vec3>& points, const char* part)
    { EXPECT_NE(error(points).find(part), std::string::npos) << Listed(points) << ": " << error(points); };
    says({}, "lie on one line");
    says({{1, 2, 3}, {3, 2, 1}}, "lie on one line, from <1, 2, 3> to <3, 2, 1>");
    says({{1, 2, 3}, {1, 2, 3}, {1, 2, 3}, {1, 2, 3}}, "lie on one line");
    says({{0.1, 0.2, 0.3}, {0.2, 0.3, 0.4}, {0.3, 0.4, 0.5}, {0.7, 0.8, 0.9}}, "lie on one line");
    says({{0, 0, 1}, {0, 0, 2}, {0, 0, 3}}, "lie on one line");
    says({{0, 1, 5}, {0, 2, 4}, {0, -1, 7}, {0, 3, 3.5}}, "in one plane with the lens centre");
    says({{1, 0, 5}, {0, 1, 5}, {0, 0, 0}}, "<0, 0, 0>, which is not in front of the lens");
    says({{1, 0, 5}, {0, 1, 5}, {3, 2, 0}}, "<3, 2, 0>, which is not in front of the lens");
    says({{1, 0, 5}, {0, 1, 5}, {0, 0, -2}}, "it lies -2 units");
    says({{1, 0, 5}, {0, 1, 5}, {0, 0, NAN}}, "finite");
    says({{1, 0, 5}, {0, 1, 5}, {0, 0, INFINITY}}, "finite");
    EXPECT_EQ(error({{1, 0, 5}, {0, 1, 5}, {0, 0, 1e-9}}), "");
}

} // namespace tilt_lens

// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include <cmath>

#include <gtest/gtest.h>

#include "double_gauss.h"

namespace
{

using paper::GlassLens;

paper::Ray Out(const GlassLens& lens, const paper::Vector& film, double x, double y)
{
    const paper::Vector direction = witness::Unit(paper::Vector{x, y, lens.ExitPupil()} - film);
    const auto ray = lens.Trace({film, direction});
    EXPECT_TRUE(ray.has_value()) << "x " << x << " y " << y;
    return ray.value_or(paper::Passage{}).out;
}

TEST(GlassLens, SendsTheFocalPointToInfinity)
{
    const GlassLens lens(50.0, 8.0);
    const paper::Vector focus{0.0, 0.0, -lens.Separation() - 50.0};
    for (const double height : {0.01, 0.5, 1.0})
    {
        const paper::Ray ray = Out(lens, focus, height, 0.0);
        // spherical aberration grows with the cube of the height
        EXPECT_NEAR(ray.direction.x / ray.direction.z, 0.0, 1e-7 + 2e-5 * std::pow(height, 3));
    }
}

TEST(GlassLens, HasTheRowsOfALensOf50Millimetres)
{
    EXPECT_NEAR(GlassLens(50.0, 8.0).PrintedFocalLength(), 50.0, 0.5);
}

TEST(GlassLens, HasItsFocalLength)
{
    const GlassLens lens(50.0, 8.0);
    const double h = 0.01;
    const paper::Ray ray = Out(lens, {h, 0.0, -lens.Separation() - 50.0}, 0.0, 0.0);
    EXPECT_NEAR(ray.direction.x / ray.direction.z / (-h / 50.0), 1.0, 1e-5);
}

TEST(GlassLens, PassesItsPrincipalPointsUnbent)
{
    // towards H', out of H, in one direction
    const GlassLens lens(50.0, 8.0);
    ASSERT_NEAR(lens.ExitPupil(), -lens.Separation(), 0.05);
    ASSERT_NEAR(lens.EntrancePupil(), 0.0, 0.05);
    const paper::Vector film{0.2, 0.1, -lens.Separation() - 55.0};
    const paper::Vector direction = witness::Unit(paper::Vector{0.0, 0.0, -lens.Separation()} - film);
    const auto ray = lens.Trace({film, direction});
    ASSERT_TRUE(ray.has_value());
    const paper::Ray& out = ray->out;
    EXPECT_NEAR(out.direction.x / out.direction.z, direction.x / direction.z, 1e-6);
    const double x = out.origin.x - out.origin.z * out.direction.x / out.direction.z;
    EXPECT_NEAR(x, 0.0, 1e-4);
}

TEST(GlassLens, HasItsFNumber)
{
    const GlassLens lens(50.0, 8.0);
    const paper::Vector focus{0.0, 0.0, -lens.Separation() - 50.0};
    double widest = 0.0;
    for (double x = 0.0; x < 2.0 * lens.PupilRadius(); x += 0.001)
        if (const auto ray = lens.Trace({focus, witness::Unit(paper::Vector{x, 0.0, lens.ExitPupil()} - focus)}))
            widest = std::fabs(ray->out.origin.x);
    EXPECT_NEAR(2.0 * widest, 50.0 / 8.0, 0.03);
}

} // namespace

// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// Skipped on processors that know one variant.

#include "tilt_lens/math/kernels.h"

#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "double_gauss_rows.h"
#include "random_cameras.h"
#include "tile_results.h"
#include "tilt_lens/samples/sample_tracer.h"
#include "with_kernels.h"

namespace tilt_lens
{
namespace
{

constexpr std::uint32_t kWidth = 40, kHeight = 36;

struct Stripes : RayTracer
{
    double transparency, scale;

    Stripes(double transparency, double scale) : transparency(transparency), scale(scale) {}

    void Trace(const CameraRays& rays, const RayRange& range, Hit* hits) override
    {
        for (std::uint32_t i = range.place; i < range.place + range.count; i++)
        {
            const double* const toZ = rays.direction[2];
            const auto at = [&](double depth, int axis) { return rays.origin[axis][i] + depth * rays.direction[axis][i] / toZ[i]; };
            const bool post = std::sin(at(4.0 * scale, 0) * 6.0 / scale) > 0.6;
            const double depth = (post ? 4.0 : 12.0) * scale;
            const double light = std::sin(at(depth, 0) * 9.0 / scale) * std::sin(at(depth, 1) * 7.0 / scale) > 0.5 ? 20.0 : 0.2;
            *hits++ = {{light, 0.5 * light, 0.1, 0.0, post ? 0.0 : transparency}, depth / toZ[i]};
        }
    }
};

struct Case
{
    std::string name;
    Statement statement;
    Aperture aperture = Aperture::Disc();
    double transparency = 0.0;
};

std::vector<Result> PictureOf(const Case& one)
{
    const SolvedLens lens = Solve({{}, {0.0, 0.0, 1.0}, {4.0 / 3.0, 0.0, 0.0}, {0.0, 1.0, 0.0}}, one.statement);
    const double scale = one.statement.focalPoint.z / 10.0;
    const Emitter lamp{{0.2 * scale, 0.3 * scale, 20.0 * scale}, 0.2 * scale, 50.0};
    const SampledCamera camera(std::make_shared<const LensCamera>(Shared(lens), one.aperture, one.statement.character, false),
                               Limits(0, 64, 1e-3), {kWidth, kHeight, {lamp}}, 3);
    Stripes stripes(one.transparency, scale);
    SampleTracer tracer(camera, stripes);
    return ResultsOf(camera.limits, {0, 0, kWidth, kHeight}, kWidth, kHeight,
                     Tracer([&](const SampleRun& run, SampleResult* results) { tracer.Trace(run, results); }));
}

std::vector<Case> Cases()
{
    Statement thin;
    thin.focalPoint = {0.0, 0.0, 10.0};
    thin.aperture = 1.0;
    thin.tilt = 5.0;
    Statement curved = thin;
    curved.character.fieldCurvature = 0.3;
    Statement glass;
    glass.prescription = std::make_shared<const Prescription>(ReadPrescription(kDoubleGauss));
    glass.sceneUnit = 1.0;
    glass.focalPoint = {0.0, 0.0, 3000.0};
    Statement conic = glass;
    Prescription hyperbolic = ReadPrescription("100 3 1.5 24\n-100 1 1 24\n0 0 0 20\n");
    hyperbolic.rows[0].conic = -2.0;
    conic.prescription = std::make_shared<const Prescription>(hyperbolic);
    return {{"disc", thin},
            {"blades", thin, Aperture::Polygon(5, 0.3, 0.4)},
            {"curved field, transparent", curved, Aperture::Disc(), 0.5},
            {"glass", glass},
            {"conic glass, blades", conic, Aperture::Polygon(6, 0.1)}};
}

TEST(Kernels, AllVariantsGiveTheSamePicture)
{
    if (!HasSeveralVariants())
        GTEST_SKIP() << "This processor knows one variant.";
    for (const Case& one : Cases())
    {
        const std::vector<Result> best = PictureOf(one), plain = WithPlainKernels([&] { return PictureOf(one); });
        ASSERT_EQ(best.size(), std::size_t(kWidth * kHeight));
        for (std::size_t i = 0; i < best.size(); i++)
            ASSERT_EQ(best[i], plain[i]) << one.name << ", pixel " << i;
    }
}

/// Comparisons and rounding differ most easily at these numbers.
TEST(Kernels, AllVariantsMapTheEdgesOfTheUnitSquareAlike)
{
    if (!HasSeveralVariants())
        GTEST_SKIP() << "This processor knows one variant.";
    const double edges[] = {0.0, 0x1p-33, 0.25, 0.5 - 0x1p-54, 0.5, 0.5 + 0x1p-53, 0.75, 1.0 - 0x1p-53};
    for (const Aperture& aperture : {Aperture::Disc(), Aperture::Polygon(3, 0.0), Aperture::Polygon(8, 1.0, 0.7)})
        for (const double v : edges)
        {
            const double vs[] = {v, v, v, v, v, v, v, v};
            double a[2][8], b[2][8];
            aperture.Map(edges, vs, a[0], b[0], 8);
            WithPlainKernels([&] { aperture.Map(edges, vs, a[1], b[1], 8); });
            for (int i = 0; i < 8; i++)
            {
                EXPECT_EQ(a[0][i], a[1][i]) << edges[i] << ", " << v;
                EXPECT_EQ(b[0][i], b[1][i]) << edges[i] << ", " << v;
            }
        }
}

TEST(Kernels, AllVariantsRefuseRadiancesThatAreNotFinite)
{
    for (const double bad : {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
        for (std::size_t channel = 0; channel < 5; channel++)
        {
            SampleResult results[2];
            results[0] = Grey(1.0), results[1] = Grey(2.0);
            results[1].radiance[channel] = bad;
            const auto refuse = [&]
            {
                const PixelSums before{{{1, 2, 3, 4, 5}, {6, 7, 8, 9, 10}}, {11, 12, 13, 14, 15}, {}, 16};
                PixelSums sums = before;
                EXPECT_FALSE(kernels->addRadiances(results, 1, 2, false, sums));
                EXPECT_EQ(std::memcmp(sums.sum, before.sum, sizeof sums.sum), 0);
                EXPECT_EQ(std::memcmp(sums.deviation, before.deviation, sizeof sums.deviation), 0);
                EXPECT_EQ(sums.samples, before.samples);
            };
            refuse();
            WithPlainKernels(refuse);
        }
}

} // namespace
} // namespace tilt_lens

// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/lens_camera/glass_sight.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "double_gauss_rows.h"
#include "tilt_lens/lens_camera/film_search.h"

namespace tilt_lens
{
namespace
{

/// 36 by 24 mm; 1 unit is 1 mm.
GlassCamera CameraOf(double tilt, bool dispersion)
{
    Statement given;
    given.prescription = std::make_shared<const Prescription>(ReadPrescription(kDispersiveDoubleGauss));
    given.dispersion = dispersion;
    given.sceneUnit = 1.0;
    given.focalPoint = {0.0, 0.0, 1000.0};
    given.tilt = tilt;
    const auto solved = Solve({{}, {0.0, 0.0, 1.0}, {1.5, 0.0, 0.0}, {0.0, 1.0, 0.0}}, given);
    return {std::make_shared<const SolvedLens>(solved), Aperture::Disc(), 0.0};
}

/// Distance at which a ray through a point of the pupil passes the target; infinite if there is no ray.
double MissOf(const GlassCamera& camera, const FilmPoint& film, const AperturePoint& pupil, double hue, const Vec3& target)
{
    FourGlassPoints points{};
    points.x[0] = film.x, points.y[0] = film.y, points.u[0] = pupil.a, points.v[0] = pupil.b;
    points.wanted = points.aimed = 1;
    FourGlassSamples rays;
    if ((camera.Aim(points, hue, rays) & 1u) == 0)
        return HUGE_VAL;
    const LensRay ray = rays.RayOf(0);
    const Vec3 direction = Normalized(ray.direction), way = target - ray.origin;
    return Length(way - Dot(way, direction) * direction);
}

const Vec3 kTargets[] = {{30.0, -20.0, 4000.0}, {-900.0, 500.0, 4000.0}, {60.0, 40.0, 500.0}, {-80.0, -40.0, 400.0}};

class GlassSights : public testing::TestWithParam<bool>
{
};

TEST_P(GlassSights, RaysOfFilmPointsFoundMeetTheTarget)
{
    for (const double tilt : {0.0, 4.0})
    {
        const GlassCamera camera = CameraOf(tilt, GetParam());
        for (const Vec3& target : kTargets)
        {
            SCOPED_TRACE(target.x);
            const FilmSearch search(camera, target);
            const double across = 36.0 / 50.0 * target.z;  // width of the scene that the film shows there, about
            for (int i = 0; i < 100; i++)
            {
                const auto pupil = [i](int j) { return Aperture::Disc()(i / 99.0, j / 3.0); };
                const FourApertures pupils{pupil(0), pupil(1), pupil(2), pupil(3)};
                const FourFilms start{search.Start(pupils[0]), search.Start(pupils[1]), search.Start(pupils[2]), search.Start(pupils[3])};
                for (const double hue : GetParam() ? std::vector<double>{-1.0, 0.0, 1.0} : std::vector<double>{0.0})
                {
                    const FourFilms films = search.FilmsOf(pupils, hue, start);
                    for (int j = 0; j < 4; j++)
                        EXPECT_LT(MissOf(camera, films[j], pupils[j], hue, target), 1e-5 * across) << i << ", " << j << ", " << hue;
                }
            }
        }
    }
}

TEST(FilmSearch, FindsNothingWithoutAPlaceToStart)
{
    const GlassCamera camera = CameraOf(0.0, false);
    const FilmSearch search(camera, kTargets[0]);
    const FilmPoint none{NAN, NAN}, start = search.Start({0.5, 0.0});
    const FourFilms films = search.FilmsOf({{{0.5, 0.0}, {0.5, 0.0}, {0.5, 0.0}, {0.5, 0.0}}}, 0.0, {none, start, none, start});
    EXPECT_TRUE(std::isnan(films[0].x) && std::isnan(films[2].y));
    EXPECT_DOUBLE_EQ(films[1].x, films[3].x);
}

/// Every ray that meets the target goes through a cell found for its film point, and not many others do.
TEST_P(GlassSights, CellsHoldTheRaysThatMeetTheTarget)
{
    const bool dispersion = GetParam();
    std::mt19937 random(5);
    std::uniform_real_distribution<double> part(0.0, 1.0);
    for (const double tilt : {0.0, 4.0})
    {
        const GlassCamera camera = CameraOf(tilt, dispersion);
        for (const Vec3& target : kTargets)
        {
            SCOPED_TRACE(target.x);
            const GlassSight sight(camera, target);
            const FilmBox box = sight.Box();
            ASSERT_LT(box.left, box.right);
            ASSERT_EQ(sight.Thirds(), dispersion ? 3u : 1u);
            const double width = box.right - box.left, height = box.top - box.bottom, image = 0.03 * std::min(width, height);
            const double radius = image * 36.0 / 50.0 * target.z;  // of an object with this image, about
            int met = 0, found = 0, cells = 0, aimed = 0;
            for (int i = 0; i < 2000; i++)
            {
                const FilmPoint film{box.left + part(random) * width, box.bottom + part(random) * height};
                const double hue = dispersion ? 2.0 * part(random) - 1.0 : 0.0;
                const auto third = std::size_t(dispersion ? std::min(2.0, 1.5 * (hue + 1.0)) : 0.0);
                const GlassSight::Cells seen = sight.CellsOf({film.x - image, film.x + image, film.y - image, film.y + image}, third);
                EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
                for (int j = 0; j < 50; j++)
                    if (const AperturePoint pupil = Aperture::Disc()(part(random), part(random));
                        MissOf(camera, film, pupil, hue, target) < 0.5 * radius)
                    {
                        met++;
                        found += std::binary_search(seen.begin(), seen.end(), GlassSight::CellAt(pupil));
                    }
                if (seen.empty())
                    continue;
                cells += int(seen.size());
                const AperturePoint aim = GlassSight::PointOf(seen[std::size_t(part(random) * seen.size())], part(random), part(random));
                aimed += MissOf(camera, film, aim, hue, target) < radius;
            }
            EXPECT_GT(met, 30);
            EXPECT_GE(found, 0.98 * met) << "of " << met;
            EXPECT_GT(aimed, 300);
            EXPECT_LT(cells, 2000 * 0.03 * GlassSight::kCount);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Dispersion, GlassSights, testing::Bool());

TEST(GlassSight, FindsThePointsOfACellInIt)
{
    for (int cell = 0; cell < GlassSight::kCount; cell++)
        for (const double u : {0.0, 0.3, 1.0})
            for (const double v : {0.0, 0.7, 1.0})
                ASSERT_EQ(GlassSight::CellAt(GlassSight::PointOf(std::uint16_t(cell), u, v)), cell) << u << ", " << v;
}

}  // namespace
}  // namespace tilt_lens

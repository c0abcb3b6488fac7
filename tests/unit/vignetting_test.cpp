// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/camera/vignetting.h"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tilt_lens/samples/sequence.h"

namespace tilt_lens
{
namespace
{

/// 36 by 24 mm, 50 mm away; rays of a film point are parallel.
std::shared_ptr<const Lens> LensOf(double tilt = 0.0, double shiftRight = 0.0, double fStop = 2.0)
{
    Statement given;
    given.focalLength = 50.0;
    given.sceneUnit = 1.0;
    given.tilt = tilt;
    given.shiftRight = shiftRight;
    given.focalPoint = {0.0, 0.0, 1e9};
    given.fStop = fStop;
    return std::make_shared<const Lens>(SolveThinLens({{}, {0.0, 0.0, 1.0}, {1.5, 0.0, 0.0}, {0.0, 1.0, 0.0}}, given));
}

Character Natural(double amount)
{
    Character character;
    character.naturalVignetting = amount;
    return character;
}

Character Optical(double amount, std::optional<double> rimStop = {})
{
    Character character;
    character.opticalVignetting = amount;
    character.rimStop = rimStop;
    return character;
}

Aperture Window()
{
    return Aperture::Picture([](double u, double v) { return u < 0.4 || v > 0.7 ? 1.0 : 0.2; });
}

TEST(NaturalVignetting, IsTheFourthPowerOfTheCosine)
{
    const Vignetting vignetting(LensOf(), Aperture::Disc(), Natural(1.0)), half(LensOf(), Aperture::Disc(), Natural(0.5));
    EXPECT_EQ(vignetting.Brightness({0.0, 0.0}), 1.0);
    for (const FilmPoint& film : {FilmPoint{0.5, 0.5}, FilmPoint{-0.3, 0.2}})
    {
        const double square = std::pow(36.0 * film.x, 2) + std::pow(24.0 * film.y, 2), cosine = 50.0 / std::hypot(50.0, std::sqrt(square));
        EXPECT_NEAR(vignetting.Brightness(film), std::pow(cosine, 4), 1e-7);
        EXPECT_NEAR(half.Brightness(film), 0.5 + 0.5 * std::pow(cosine, 4), 1e-7);
    }
}

/// A small patch's light: cosines at both ends over the squared distance.
TEST(NaturalVignetting, HasTheTrueAnglesAndDistances)
{
    const auto lens = LensOf(8.0, 10.0);
    const Vignetting vignetting(lens, Aperture::Disc(), Natural(1.0));
    const double s = lens->filmDistance, sine = std::sin(8.0 * M_PI / 180.0), cosine = std::cos(8.0 * M_PI / 180.0);
    const auto light = [&](const FilmPoint& film)
    {
        const Vec3 way{36.0 * film.x + 10.0, 24.0 * film.y, s}, filmNormal{0.0, 0.0, 1.0}, lensNormal{0.0, -sine, cosine};
        const double distance = Length(way);
        return Dot(way, filmNormal) / distance * Dot(way, lensNormal) / distance / (distance * distance);
    };
    for (const FilmPoint& film : {FilmPoint{0.5, 0.5}, FilmPoint{-0.5, 0.3}, FilmPoint{0.0, -0.5}})
        EXPECT_NEAR(vignetting.Brightness(film), light(film) / light({0.0, 0.0}), 1e-9);
    EXPECT_GT(vignetting.Brightness({-0.2, 0.0}), 1.0) << "nearer to the axis than the middle of the shifted frame";
}

/// Common area of unit circles over that of one.
double Overlap(double apart)
{
    const double half = 0.5 * apart;
    return half >= 1.0 ? 0.0 : 2.0 / M_PI * (std::acos(half) - half * std::sqrt(1.0 - half * half));
}

TEST(OpticalVignetting, OpenShareIsTheOverlapOfTwoCircles)
{
    for (const double amount : {0.2, 0.5, 1.2})
    {
        const Vignetting vignetting(LensOf(), Aperture::Disc(), Optical(amount));
        const double corner = std::hypot(18.0, 12.0);
        EXPECT_EQ(vignetting.RimRadius(), 12.5);
        EXPECT_NEAR(vignetting.RimDistance(), amount * 25.0 * 50.0 / corner, 1e-5);
        for (int i = -4; i <= 4; i++)
            for (int j = -4; j <= 4; j++)
            {
                const FilmPoint film{i / 8.0, j / 8.0};
                const double apart = 2.0 * amount * std::hypot(36.0 * film.x, 24.0 * film.y) / corner;
                EXPECT_NEAR(vignetting.OpenShare(film), Overlap(apart), 1e-3) << amount << " at " << film.x << ", " << film.y;
            }
        EXPECT_NEAR(vignetting.OpenShare({0.2577, 0.1234}), Overlap(2.0 * amount * std::hypot(36.0 * 0.2577, 24.0 * 0.1234) / corner),
                    1e-3);
    }
}

TEST(OpticalVignetting, PassesRaysWithinTheRim)
{
    const auto lens = LensOf(6.0, 4.0);
    const Vignetting vignetting(lens, Aperture::Disc(), Optical(0.6));
    int through = 0, covered = 0;
    for (int i = 0; i < 4000; i++)
    {
        const SequencePoint p = PixelSampler(i, 0, 0)(0);
        const FilmPoint film{p.pixelX - 0.5, p.pixelY - 0.5};
        const AperturePoint point = Aperture::Disc()(p.lensU, p.lensV);
        const LensRay ray = MakeRay(*lens, film.x, film.y, point.a, point.b);
        const Vec3 way = vignetting.RimDistance() / Dot(ray.direction, lens->normal) * ray.direction;
        const Vec3 at = ray.origin + way - vignetting.RimDistance() * lens->normal;
        const bool within = Length(at) <= vignetting.RimRadius();
        EXPECT_EQ(vignetting.Passes(film, point), within);
        (within ? through : covered)++;
    }
    EXPECT_GT(through, 1000);
    EXPECT_GT(covered, 300);
}

TEST(OpticalVignetting, SamplesAreUnbiased)
{
    const auto f = [](const AperturePoint& p) { return 1.0 + p.a + 0.5 * p.b * p.b; };
    for (const Aperture& aperture : {Aperture::Disc(), Aperture::Polygon(5, 0.3, 0.4), Window(), Aperture::Squeezed(Aperture::Disc(), 2.0),
                                     Aperture::Graded(Aperture::Disc(), 0.5)})
    {
        const Vignetting vignetting(LensOf(5.0), aperture, Optical(0.7));
        for (const FilmPoint& film : {FilmPoint{0.0, 0.0}, FilmPoint{0.4, 0.3}, FilmPoint{-0.5, 0.5}})
        {
            const int n = 1 << 16;
            double drawn = 0.0, all = 0.0, weights = 0.0;
            for (int i = 0; i < n; i++)
            {
                const SequencePoint p = PixelSampler(3, 5, 0)(i);
                AperturePoint point;
                const double weight = vignetting.DrawPoint(aperture, film, p.lensU, p.lensV, PixelHash(3, 5, 1, i), point);
                ASSERT_TRUE(weight == 0.0 || vignetting.Passes(film, point));
                drawn += weight * f(point) / n;
                weights += weight / n;
                const AperturePoint plain = aperture(p.lensU, p.lensV);
                all += vignetting.Passes(film, plain) ? vignetting.Brightness(film) * f(plain) / n : 0.0;
            }
            EXPECT_NEAR(drawn, all, 4e-3 * all + 1e-3) << film.x << ", " << film.y;
            EXPECT_NEAR(weights, vignetting.Brightness(film) * vignetting.OpenShare(film), 1e-3) << film.x << ", " << film.y;
        }
        EXPECT_NEAR(vignetting.Brightness({0.0, 0.0}) * vignetting.OpenShare({0.0, 0.0}), 1.0, 1e-6) << "as bright as without";
    }
}

TEST(OpticalVignetting, UniformSurfaceHasNoNoise)
{
    const Vignetting vignetting(LensOf(), Aperture::Disc(), Optical(0.5));
    const FilmPoint film{0.5, 0.5};
    for (int i = 0; i < 64; i++)
    {
        const SequencePoint p = PixelSampler(1, 2, 0)(i);
        AperturePoint point;
        const double weight = vignetting.DrawPoint(Aperture::Disc(), film, p.lensU, p.lensV, i + 1, point);
        EXPECT_NEAR(weight, Overlap(1.0), 1e-3);
    }
}

TEST(OpticalVignetting, StoppingDownOpensTheCorners)
{
    const Vignetting wide(LensOf(), Aperture::Disc(), Optical(0.3, 2.0)),
        narrow(LensOf(0.0, 0.0, 8.0), Aperture::Disc(), Optical(0.3, 2.0));
    EXPECT_NEAR(wide.OpenShare({0.5, 0.5}), Overlap(0.6), 1e-3);
    EXPECT_EQ(narrow.OpenShare({0.5, 0.5}), 1.0);
    EXPECT_NEAR(wide.RimDistance(), narrow.RimDistance(), 1e-9);
}

TEST(OpticalVignetting, RefusesADarkCentre)
{
    EXPECT_THROW(Vignetting(LensOf(30.0), Aperture::Disc(), Optical(2.0)), OpticsError);
    EXPECT_NO_THROW(Vignetting(LensOf(8.0), Aperture::Disc(), Optical(0.5)));
}

TEST(Vignetting, OffChangesNothing)
{
    const Vignetting none, off(LensOf(), Aperture::Disc(), Character());
    for (const Vignetting* vignetting : {&none, &off})
    {
        EXPECT_TRUE(vignetting->None());
        EXPECT_EQ(vignetting->Brightness({0.5, 0.5}), 1.0);
        EXPECT_EQ(vignetting->OpenShare({0.5, 0.5}), 1.0);
        EXPECT_TRUE(vignetting->Passes({0.5, 0.5}, {1.0, 0.0}));
    }
}

} // namespace
} // namespace tilt_lens

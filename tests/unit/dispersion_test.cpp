// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/glass/dispersion.h"

#include <cmath>
#include <memory>

#include <gtest/gtest.h>

#include "double_gauss_rows.h"
#include "tilt_lens/lens_camera/lens_camera.h"

namespace tilt_lens
{
namespace
{

constexpr double kWavelengths[] = {405.0, 450.0, 486.1327, 550.0, 587.5618, 650.0, 695.0};

/// A biconvex lens of BK7 far before its stop.
const char* const kSinglet = "50 6 1.5168 20 64.17\n-70 10 1 20\n0 0 0 8\n";

TEST(Dispersion, ReproducesTheAbbeNumber)
{
    for (const double index : {1.45, 1.62, 2.0})
        for (const double abbe : {20.0, 47.1, 95.0})
        {
            EXPECT_DOUBLE_EQ(IndexAt(index, abbe, kLineD), index);
            const double FC = IndexAt(index, abbe, kLineF) - IndexAt(index, abbe, kLineC);
            EXPECT_NEAR((index - 1.0) / FC, abbe, 1e-9 * abbe);
            EXPECT_NEAR((IndexAt(index, abbe, kLineG) - IndexAt(index, abbe, kLineF)) / FC, 0.6438 - 0.001682 * abbe, 1e-9);
        }
    EXPECT_EQ(IndexAt(1.7, 0.0, 400.0), 1.7);
}

/// Lines r, C, F', e, g, h in Schott's catalogue.
TEST(Dispersion, MatchesRealGlasses)
{
    const double lines[] = {706.5188, 656.2725, 479.9914, 546.0740, 435.8343, 404.6561};
    const double bk7[] = {1.51289, 1.51432, 1.52283, 1.51872, 1.52668, 1.53024};
    const double f2[] = {1.61227, 1.61503, 1.63310, 1.62408, 1.64202, 1.65064};
    for (int i = 0; i < 6; i++)
    {
        EXPECT_NEAR(IndexAt(1.51680, 64.17, lines[i]), bk7[i], 2e-4) << lines[i];
        EXPECT_NEAR(IndexAt(1.62004, 36.37, lines[i]), f2[i], 4e-4) << lines[i];
    }
}

double FocusOf(const GlassLens& lens)
{
    GlassRay ray{{1e-3, 0.0, 200.0}, {0.0, 0.0, -1.0}};
    StopPoint stop;
    EXPECT_EQ(lens.TraceFromScene(ray, stop), Passage::Passed);
    return ray.origin.z - ray.origin.x * ray.direction.z / ray.direction.x;
}

TEST(Dispersion, SingletMatchesTheThickLensEquation)
{
    const Prescription prescription = ReadPrescription(kSinglet);
    const GlassLens lens(prescription);
    for (const double wavelength : kWavelengths)
    {
        const double n = IndexAt(1.5168, 64.17, wavelength), r1 = 50.0, r2 = -70.0, d = 6.0;
        const double power = (n - 1.0) * (1.0 / r1 - 1.0 / r2 + (n - 1.0) * d / (n * r1 * r2)),
                     backFocus = (1.0 - (n - 1.0) * d / (n * r1)) / power;
        EXPECT_NEAR(GlassLens(AtWavelength(prescription, wavelength)).Cardinal().focalLength, 1.0 / power, 1e-11);
        GlassLens coloured = lens;
        coloured.TakeIndices(AtWavelength(prescription, wavelength));
        EXPECT_NEAR(FocusOf(coloured), lens.Cardinal().frontVertex - d - backFocus, 1e-6) << wavelength;
    }
}

/// Thin lenses in contact with f1 V1 = -f2 V2: C and F meet.
TEST(Dispersion, AchromatHasTheSecondarySpectrum)
{
    const double f = 100.0, V1 = 64.17, V2 = 36.37, n1 = 1.5168, n2 = 1.62004;
    const double power1 = V1 / (V1 - V2) / f, power2 = -V2 / (V1 - V2) / f;
    const double c1 = 0.5 * power1 / (n1 - 1.0), c2 = power2 / (n2 - 1.0);
    Prescription prescription;
    const auto row = [](double radius, double index, double abbe)
    {
        PrescriptionRow row;
        row.radius = radius;
        row.thickness = 1e-7;
        row.index = index;
        row.abbe = abbe;
        row.diameter = 10.0;
        return row;
    };
    prescription.rows = {row(1.0 / c1, n1, V1), row(-1.0 / c1, n2, V2), row(1.0 / (-c1 - c2), 1.0, 0.0), row(0.0, 1.0, 0.0)};
    prescription.stop = 3;
    const auto focal = [&](double wavelength) { return GlassLens(AtWavelength(prescription, wavelength)).Cardinal().focalLength; };
    EXPECT_NEAR(focal(kLineD), f, 1e-4);
    EXPECT_NEAR(focal(kLineF), focal(kLineC), 1e-6 * f);
    for (const double wavelength : kWavelengths)
    {
        const double power = power1 * (IndexAt(n1, V1, wavelength) - 1.0) / (n1 - 1.0) +
                             power2 * (IndexAt(n2, V2, wavelength) - 1.0) / (n2 - 1.0);
        EXPECT_NEAR(focal(wavelength), 1.0 / power, 1e-4);
    }
    EXPECT_GT(focal(kLineF) - focal(kLineD), 0.02);
    EXPECT_GT(focal(kLineG) - focal(kLineD), 0.1);
}

TEST(Dispersion, LensesCoverTheThirdsOfTheSpectrum)
{
    const Prescription prescription = ReadPrescription(kSinglet);
    const GlassLens lens(prescription);
    const GlassOfColours colours(lens, prescription);
    double before = -HUGE_VAL;
    for (int i = 0; i < 48; i++)
    {
        const double low = (i - 24) / 24.0, middle = low + 0.5 / 24.0;
        const double focus = -FocusOf(colours.Of(middle));
        EXPECT_GT(focus, before) << "the redder, the farther";
        before = focus;
        GlassLens exact = lens;
        exact.TakeIndices(AtWavelength(prescription, WavelengthOf(middle)));
        EXPECT_NEAR(focus, -FocusOf(exact), 1e-9);
        EXPECT_EQ(&colours.Of(low + 1e-6), &colours.Of(low + 1.0 / 24.0 - 1e-6));
    }
    EXPECT_EQ(&colours.Of(-1.0), &colours.Of(-0.999));
    EXPECT_NE(&colours.Of(1.0 / 3.0 - 1e-9), &colours.Of(1.0 / 3.0 + 1e-9));
    EXPECT_EQ(WavelengthOf(-1.0), 400.0);
    EXPECT_EQ(WavelengthOf(1.0 / 3.0), 600.0);
}

std::shared_ptr<const SolvedLens> Made(const char* text, bool dispersion)
{
    Statement given;
    given.prescription = std::make_shared<const Prescription>(ReadPrescription(text));
    given.dispersion = dispersion;
    given.sceneUnit = 1.0;
    given.focalPoint = {0.0, 0.0, 3000.0};
    given.tilt = 3.0;
    return std::make_shared<const SolvedLens>(Solve({{}, {0.0, 0.0, 1.0}, {1.5, 0.0, 0.0}, {0.0, 1.0, 0.0}}, given));
}

FourGlassPoints ThreeTimes(const FilmPoint& film, double u, double v, std::uint32_t seed)
{
    return {{film.x, film.x, film.x}, {film.y, film.y, film.y}, {u, u, u}, {v, v, v}, {seed, seed, seed}, 7};
}

TEST(Dispersion, RaysOfAColourFocusWhereItsLensDoes)
{
    const auto shared = Made(kSinglet, true);
    const SolvedLens& lens = *shared;
    const GlassCamera camera(shared, Aperture::Disc(), 0.0);
    ASSERT_TRUE(camera.HasColours());
    ASSERT_TRUE(LensCamera(shared, Aperture::Disc(), {}).HasColours());
    EXPECT_FALSE(LensCamera(Made(kSinglet, false), Aperture::Disc(), {}).HasColours());
    // thin lens equation of each colour
    const double film = lens.filmDistance * Dot(lens.axis, lens.normal);
    const FilmPoint onAxis{0.0, -Dot(lens.normal, lens.axisUp) / Dot(lens.normal, lens.axis) * lens.filmDistance / 24.0};
    double apart[3];
    for (int hue = 0; hue < 3; hue++)
    {
        double zz = 0.0, zx = 0.0;
        for (int i = 0; i < 64; i++)
        {
            FourGlassSamples samples;
            camera.DrawColours(ThreeTimes(onAxis, (i % 8 + 0.5) / 8.0, (i / 8 + 0.5) / 8.0, i), {-1.0, 0.0, 1.0}, samples);
            ASSERT_GT(samples.weight[hue], 0.0);
            const LensRay ray = samples.RayOf(hue);
            const Vec3 direction = Normalized(ray.direction);
            const double slope = Dot(direction, Normalized(lens.lensX)) / Dot(direction, lens.normal);
            const double place = Dot(ray.origin, Normalized(lens.lensX)) - slope * Dot(ray.origin, lens.normal);
            zz += place * place;
            zx += slope * place;
        }
        apart[hue] = -zx / zz;
    }
    const Prescription prescription = ReadPrescription(kSinglet);
    const auto power = [&](double hue) { return 1.0 / GlassLens(AtWavelength(prescription, WavelengthOf(hue))).Cardinal().focalLength; };
    // both have equal spherical aberration
    EXPECT_NEAR((apart[0] - apart[2]) / (power(-47.0 / 48.0) - power(47.0 / 48.0)), 1.0, 0.03) << film;
}

TEST(Dispersion, DoesNotChangeBrightness)
{
    const GlassCamera camera(Made(kDispersiveDoubleGauss, true), Aperture::Disc(), 1.0),
        plain(Made(kDispersiveDoubleGauss, false), Aperture::Disc(), 1.0);
    std::uint32_t refused = 0, drawn = 0;
    for (int i = 0; i < 400; i++)
    {
        const FilmPoint film{(i % 20) / 20.0 - 0.48, (i / 20) / 20.0 - 0.48};
        const double weight = plain.Draw(film, 0.3, 0.7, i).weight;
        EXPECT_EQ(camera.Brightness(film), weight);
        FourGlassSamples samples, reversed;
        camera.DrawColours(ThreeTimes(film, 0.3, 0.7, i), {-1.0, 0.1, 1.0}, samples);
        camera.DrawColours(ThreeTimes(film, 0.3, 0.7, i), {1.0, 0.1, -1.0}, reversed);
        for (int hue = 0; hue < 3; hue++)
        {
            EXPECT_EQ(samples.weight[hue], weight);
            EXPECT_EQ(samples.direction[0][hue], reversed.direction[0][2 - hue]);
            EXPECT_EQ(samples.refused[hue], reversed.refused[2 - hue]);
            refused += samples.refused[hue];
            drawn++;
        }
    }
    EXPECT_LT(double(refused), 0.3 * drawn);
}

TEST(Dispersion, NeedsAbbeNumbers)
{
    EXPECT_NO_THROW(RequireAbbeNumbers(ReadPrescription(kSinglet)));
    try
    {
        RequireAbbeNumbers(ReadPrescription("# a lens\n50 6 1.5168 20\n-70 10 1 20\n0 0 0 8\n"));
        ADD_FAILURE();
    }
    catch (const PrescriptionError& error)
    {
        EXPECT_EQ(error.line, 2);
        EXPECT_NE(std::string(error.what()).find("a glass of index 1.5168 without an Abbe number"), std::string::npos);
    }
}

} // namespace
} // namespace tilt_lens

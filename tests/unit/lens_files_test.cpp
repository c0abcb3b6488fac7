// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// Compares scenes/include/lenses with their sources.

#include <cmath>
#include <fstream>
#include <map>
#include <sstream>

#include <gtest/gtest.h>

#include "tilt_lens/glass/dispersion.h"
#include "tilt_lens/glass/glass_lens.h"

namespace tilt_lens
{
namespace
{

const std::string kFolder = std::string(TILT_LENS_SOURCE) + "/scenes/include/lenses/";

std::string Whole(const std::string& name)
{
    std::ifstream file(kFolder + name);
    EXPECT_TRUE(file.good()) << name;
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

std::vector<std::string> Fields(const std::string& line)
{
    std::vector<std::string> fields(1);
    bool quoted = false;
    for (const char c : line)
    {
        if (c == '"')
            quoted = !quoted;
        else if (c == ',' && !quoted)
            fields.emplace_back();
        else
            fields.back() += c;
    }
    return fields;
}

struct Stated
{
    std::string file, patent;
    double focalLength, fNumber, backFocus;  ///< backFocus 0: not stated
};

std::vector<Stated> Lenses()
{
    std::istringstream table(Whole("lenses.csv"));
    std::string line;
    std::getline(table, line);
    EXPECT_EQ(line, "file,lens,patent,source,focal length mm,f-number,back focus mm");
    std::vector<Stated> lenses;
    while (std::getline(table, line))
    {
        const std::vector<std::string> fields = Fields(line);
        EXPECT_EQ(fields.size(), 7u) << line;
        lenses.push_back(
            {fields[0], fields[2], std::stod(fields[4]), std::stod(fields[5]), fields[6].empty() ? 0.0 : std::stod(fields[6])});
    }
    return lenses;
}

/// Root mean square radius in best focus, relative to the focal length.
double AxialSpot(const GlassLens& lens, double fNumber)
{
    const CardinalPoints& points = lens.Cardinal();
    const int rays = 100;
    double xx = 0.0, xu = 0.0, uu = 0.0;
    for (int i = 0; i < rays; i++)
    {
        const double height = 0.5 * points.focalLength / fNumber * std::sqrt((i + 0.5) / rays);
        GlassRay ray{{height, 0.0, points.frontVertex + points.focalLength}, {0.0, 0.0, -1.0}};
        StopPoint stop;
        EXPECT_EQ(lens.TraceFromScene(ray, stop), Passage::Passed) << i;
        const double slope = ray.direction.x / ray.direction.z;
        const double x = ray.origin.x + (-points.separation - points.focalLength - ray.origin.z) * slope;
        xx += x * x / rays;
        xu += x * slope / rays;
        uu += slope * slope / rays;
    }
    return std::sqrt(std::max(0.0, xx - xu * xu / uu)) / points.focalLength;
}

TEST(LensFiles, MatchTheirSources)
{
    const std::vector<Stated> lenses = Lenses();
    EXPECT_GE(lenses.size(), 10u);
    for (const Stated& stated : lenses)
    {
        SCOPED_TRACE(stated.file);
        EXPECT_NE(stated.patent.find("US patent"), std::string::npos);
        const std::string text = Whole(stated.file);
        EXPECT_NE(text.find(stated.patent), std::string::npos) << "the file names its patent";
        const CardinalPoints points = GlassLens(ReadPrescription(text)).Cardinal();
        EXPECT_NEAR(points.focalLength / stated.focalLength, 1.0, 0.008);
        EXPECT_NEAR(points.fNumber / stated.fNumber, 1.0, 0.025);
        if (stated.backFocus > 0.0)
        {
            EXPECT_NEAR(points.backFocus / stated.backFocus, 1.0, 0.002);
        }
    }
}

TEST(LensFiles, FormSharpImages)
{
    for (const Stated& stated : Lenses())
    {
        SCOPED_TRACE(stated.file);
        const GlassLens lens(ReadPrescription(Whole(stated.file)));
        // 0.01 mm for 50 mm
        EXPECT_LT(AxialSpot(lens, 2.0 * lens.Cardinal().fNumber), 0.01 / 50.0);
    }
}

/// Root mean square radius, micrometres, on the axis at the stated back focus, for d, C, F.
double SpotOfThreeColours(const Stated& stated)
{
    const Prescription prescription = ReadPrescription(Whole(stated.file));
    const GlassLens lens(prescription);
    const CardinalPoints& points = lens.Cardinal();
    const int rays = 200;
    double squares = 0.0;
    int passed = 0;
    for (const double wavelength : {kLineD, kLineC, kLineF})
    {
        GlassLens coloured = lens;
        coloured.TakeIndices(AtWavelength(prescription, wavelength));
        for (int i = 0; i < rays; i++)
        {
            const double height = 0.5 * points.focalLength / stated.fNumber * std::sqrt((i + 0.5) / rays);
            GlassRay ray{{height, 0.0, points.frontVertex + points.focalLength}, {0.0, 0.0, -1.0}};
            StopPoint stop;
            if (coloured.TraceFromScene(ray, stop) != Passage::Passed)
                continue;
            const double way = points.rearVertex - stated.backFocus - ray.origin.z;
            squares += std::pow(ray.origin.x + way * ray.direction.x / ray.direction.z, 2);
            passed++;
        }
    }
    return 1000.0 * std::sqrt(squares / passed);
}

/// Source: spot-report.txt of the ray tracer jfotoptix (repository BeamFour/Beam42), except lenses with glasses of abnormal dispersion, or
/// with another focal length or back focus there.
TEST(LensFiles, SpotsMatchAnotherProgram)
{
    const std::map<std::string, double> published = {
        {"nikon_nikkor_n_50.dat", 82.04}, {"angenieux_55.dat", 65.53}, {"nikon_nikkor_52.dat", 19.73}};
    std::size_t found = 0;
    for (const Stated& stated : Lenses())
    {
        const auto spot = published.find(stated.file);
        if (spot == published.end())
            continue;
        EXPECT_NEAR(SpotOfThreeColours(stated) / spot->second, 1.0, 0.02) << stated.file;
        found++;
    }
    EXPECT_EQ(found, published.size());
}

} // namespace
} // namespace tilt_lens

// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/glass/prescription.h"

#include <cmath>

#include <gtest/gtest.h>

namespace tilt_lens
{
namespace
{

const char* const kPbrt = R"(# a triplet of no maker
# radius  thickness  index  diameter
20   3    1.6   14
-80  2.5  1     14
0    1    0     9      # the stop
-25  1.5  1.7   10
+30. 4    0     10
0    2.5  1.5   12
-22  40   1     12
)";

const char* const kLentil = R"({
  "a triplet": {
    "optical-elements-patent": [
      {"radius": 20, "thickness": 3, "ior": 1.6, "abbe": 50, "housing-radius": 7, "material": "X", "lens-geometry": "spherical"},
      {"radius": -80, "thickness": 2.5, "ior": null, "housing-radius": 7, "material": "air", "lens-geometry": "spherical"},
      {"radius": 99999, "thickness": 1, "ior": null, "housing-radius": 4.5, "material": "iris", "lens-geometry": "spherical"},
      {"radius": -25, "thickness": 1.5, "ior": 1.7, "housing-radius": 5, "material": "X", "lens-geometry": "spherical"},
      {"radius": 30, "thickness": 4, "ior": null, "housing-radius": 5, "material": "air", "lens-geometry": "spherical"},
      {"radius": 99999, "thickness": 2.5, "ior": 1.5, "housing-radius": 6, "material": "X", "lens-geometry": "spherical"},
      {"radius": -22, "thickness": 40, "ior": null, "housing-radius": 6, "material": "air", "lens-geometry": "spherical",
       "aspherical-equation": null}
    ]
  }
}
)";

const char* const kIset = R"({
 "name": "a triplet",
 "surfaces": [
  {"radius": 20, "thickness": 3, "ior": 1.6, "semi_aperture": 7},
  {"radius": -80, "thickness": 2.5, "ior": 1, "semi_aperture": 7, "conic_constant": 0},
  {"radius": 0, "thickness": 1, "ior": 0, "semi_aperture": 4.5},
  {"radius": [-25, -25], "thickness": 1.5, "ior": 1.7, "semi_aperture": [5, 5],
   "transform": [[1, 0, 0], [0, 1, 0], [0, 0, 1], [0, 0, 0]]},
  {"radius": 30, "thickness": 4, "ior": 1, "semi_aperture": 5},
  {"radius": 0, "thickness": 2.5, "ior": 1.5, "semi_aperture": 6},
  {"radius": -22, "thickness": 40, "ior": 1, "semi_aperture": 6}
 ]
}
)";

void ExpectTriplet(const Prescription& lens)
{
    const double rows[7][4] = {{20, 3, 1.6, 14}, {-80, 2.5, 1, 14}, {0, 1, 1, 9},    {-25, 1.5, 1.7, 10},
                               {30, 4, 1, 10},   {0, 2.5, 1.5, 12}, {-22, 40, 1, 12}};
    ASSERT_EQ(lens.rows.size(), 7u);
    EXPECT_EQ(lens.stop, 2u);
    for (int i = 0; i < 7; i++)
    {
        EXPECT_EQ(lens.rows[i].radius, rows[i][0]) << i;
        EXPECT_EQ(lens.rows[i].thickness, rows[i][1]) << i;
        EXPECT_EQ(lens.rows[i].index, rows[i][2]) << i;
        EXPECT_EQ(lens.rows[i].diameter, rows[i][3]) << i;
        EXPECT_EQ(lens.rows[i].conic, 0.0) << i;
        EXPECT_TRUE(lens.rows[i].aspheric.empty()) << i;
    }
}

std::string With(std::string text, const std::string& part, const std::string& by)
{
    const std::size_t at = text.find(part);
    EXPECT_NE(at, std::string::npos) << part;
    return text.replace(at, part.size(), by);
}

void ExpectError(const std::string& text, int line, const std::string& part, const std::string& choice = "")
{
    try
    {
        ReadPrescription(text, choice);
        ADD_FAILURE() << "no error for " << part;
    }
    catch (const PrescriptionError& error)
    {
        EXPECT_EQ(error.line, line) << error.what();
        EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
}

TEST(Prescription, AllFormsAgree)
{
    for (const char* text : {kPbrt, kLentil, kIset})
        ExpectTriplet(ReadPrescription(text));
    ExpectTriplet(ReadPrescription(kLentil, "a triplet"));
    // the stop may have the index of air; the lens may be alone in its file
    ExpectTriplet(ReadPrescription(With(kPbrt, "0    1    0 ", "0    1    1 ")));
    ExpectTriplet(ReadPrescription(With(kIset, "\"ior\": 0", "\"ior\": 1")));
    ExpectTriplet(ReadPrescription(With(With(kLentil, "\"a triplet\": {", ""), "]\n  }", "]")));
}

TEST(Prescription, PlanesBesideAMarkedStopAreRims)
{
    const Prescription lens = ReadPrescription(With(kPbrt, "-25  1.5", "0 2 1 8\n-25  1.5"));
    EXPECT_EQ(lens.stop, 2u);
    EXPECT_EQ(lens.rows.size(), 8u);
    ExpectError(With(With(kPbrt, "-25  1.5", "0 2 1 8\n-25  1.5"), "0    1    0 ", "0    1    1 "), 6, "second stop");
}

TEST(Prescription, ReadsAspheres)
{
    const Prescription both = ReadPrescription(
        With(kIset, "\"conic_constant\": 0", "\"conic_constant\": -1, \"aspherical-equation\": [3e-6]"));
    EXPECT_EQ(both.rows[1].conic, -1.0);
    EXPECT_EQ(both.rows[1].aspheric, std::vector<double>{3e-6});
    const Prescription lentil = ReadPrescription(With(kLentil, "\"aspherical-equation\": null", "\"aspherical-equation\": [1e-5, -2e-8]"));
    EXPECT_EQ(lentil.rows[6].aspheric, (std::vector<double>{1e-5, -2e-8}));
    const Prescription iset = ReadPrescription(With(kIset, "\"conic_constant\": 0", "\"conic_constant\": -1.5"));
    EXPECT_EQ(iset.rows[1].conic, -1.5);
}

TEST(Prescription, ReadsAbbeNumbers)
{
    EXPECT_EQ(ReadPrescription(kPbrt).rows[0].abbe, 0.0);
    EXPECT_EQ(ReadPrescription(kLentil).rows[0].abbe, 50.0);
    EXPECT_EQ(ReadPrescription(With(kPbrt, "1.6   14", "1.6   14 50")).rows[0].abbe, 50.0);
    EXPECT_EQ(ReadPrescription(With(kIset, "\"ior\": 1.6,", "\"ior\": 1.6, \"abbe\": 50,")).rows[0].abbe, 50.0);
    const Prescription inGlass = ReadPrescription("20 3 1.6 14 50\n0 1 0 9\n-22 40 1 12\n");
    EXPECT_EQ(inGlass.rows[1].abbe, 50.0);
    EXPECT_EQ(ReadPrescription(kPbrt).rows[3].line, 6);
}

TEST(Prescription, ScalesAllLengths)
{
    Prescription lens = ReadPrescription(kPbrt);
    lens.rows[0].aspheric = {1e-4, 1e-6};
    const Prescription twice = Scaled(lens, 2.0);
    EXPECT_EQ(twice.rows[3].radius, -50.0);
    EXPECT_EQ(twice.rows[3].thickness, 3.0);
    EXPECT_EQ(twice.rows[3].diameter, 20.0);
    EXPECT_EQ(twice.rows[3].index, 1.7);
    const double h = 3.0;
    EXPECT_NEAR(twice.rows[0].aspheric[0] * std::pow(2 * h, 4), 2 * 1e-4 * std::pow(h, 4), 1e-15);
    EXPECT_NEAR(twice.rows[0].aspheric[1] * std::pow(2 * h, 6), 2 * 1e-6 * std::pow(h, 6), 1e-15);
}

TEST(Prescription, RefusesRowsOfPbrtWithTheirLine)
{
    ExpectError("", 1, "empty");
    ExpectError(" \n\n", 1, "empty");
    ExpectError("# nothing\n", 0, "0 surfaces");
    ExpectError(With(kPbrt, "-80  2.5  1     14", "-80  2.5  1"), 4, "3 numbers");
    ExpectError(With(kPbrt, "-80  2.5  1     14", "-80  2.5  1  14  50 7"), 4, "6 numbers");
    ExpectError(With(kPbrt, "1.6   14", "1.6   14 5"), 3, "an Abbe number of 5");
    ExpectError(With(kPbrt, "1.6   14", "1.6   14 -50"), 3, "an Abbe number of -50");
    ExpectError(With(kPbrt, "-80  2.5", "-8O  2.5"), 4, "'-8O' where a number should be");
    ExpectError(With(kPbrt, "-80  2.5", "-80  2,5"), 4, "'2,5'");
    ExpectError(With(kPbrt, "-80  2.5", std::string("-80  2\0.5", 9)), 4, "'2?.5' where a number should be");
    ExpectError(With(kPbrt, "-80  2.5", "inf  2.5"), 4, "not finite");
    ExpectError(With(kPbrt, "-80  2.5", "-80  -2.5"), 4, "thickness of -2.5");
    ExpectError(With(kPbrt, "-80  2.5", "-80  nan"), 4, "thickness of nan");
    ExpectError(With(kPbrt, "1.6   14", "0.6   14"), 3, "index of refraction of 0.6");
    ExpectError(With(kPbrt, "1.6   14", "16   14"), 3, "index of refraction of 16");
    ExpectError(With(kPbrt, "1.6   14", "1.6   0"), 3, "clear diameter of 0");
    ExpectError(With(kPbrt, "0    1    0     9 ", "-400 1 1 9"), 0, "no stop");
    ExpectError(With(kPbrt, "-25  1.5  1.7   10", "0 1.5 0 10"), 6, "second stop (the first is in line 5)");
    ExpectError(With(kPbrt, "20   3  ", "20   0  "), 3, "column up by one row");
    ExpectError(With(kPbrt, "-22  40   1 ", "-22  40  1.5"), 9, "The film is in air");
    ExpectError(kPbrt, 0, "Remove it", "0001");
}

TEST(Prescription, RefusesJsonWithItsLine)
{
    ExpectError(With(kIset, "\"surfaces\": [",
                     "\"surfaces\": ["
                     "\n\n {,"),
                5, "no JSON");
    ExpectError(With(kIset, "\"surfaces\"", "\"faces\""), 0, "no known form");
    ExpectError(With(kIset, "\"ior\": 1.6, ", ""), 4, "without \"ior\"");
    ExpectError(With(kIset, "\"thickness\": 2.5, \"ior\": 1,", "\"thickness\": \"thick\", \"ior\": 1,"), 5, "'thick'. It must be a number");
    ExpectError(With(kIset, "[-25, -25]", "[-25, -26]"), 7, "\"radius\" with several values");
    ExpectError(With(kIset, "\"ior\": 1.7", "\"ior\": [[400, 700], [1.7, 1.6]]"), 7, "\"ior\" with several values");
    ExpectError(With(kIset, "[[1, 0, 0]", "[[1, 0.1, 0]"), 7, "transform");
    ExpectError(With(kIset, "[0, 0, 0]]", "[0, 0, 0], [1]]"), 8, "\"transform\" with 13 numbers");
    ExpectError(With(kLentil, "\"lens-geometry\": \"spherical\"}", "\"lens-geometry\": \"cyl-y\"}"), 4, "cylindrical");
    ExpectError(With(kLentil, "\"thickness\": 2.5", "\"thickness\": [2.5, 3, 4]"), 5, "a zoom");
    ExpectError(With(kLentil, "\"ior\": 1.6", "\"ior\": null"), 4, "without \"ior\"");
    ExpectError(With(kLentil, "\"radius\": 99999, \"thickness\": 1,", "\"radius\": 50, \"thickness\": 1,"), 6, "curved");
}

TEST(Prescription, RequiresTypesOfJsonWithTheirLine)
{
    for (const char* word : {"\"1.6\"", "true", "{}", "{\"a\": 1}"})
        ExpectError(With(kIset, "\"ior\": 1.6", std::string("\n\"ior\": ") + word), 5, "It must be a number");
    ExpectError(With(kIset, "\"ior\": 1.6", "\"ior\": [1.6, \"1.6\"]"), 4, "several values");
    ExpectError(With(kIset, "\"conic_constant\": 0", "\"aspherical-equation\": 5"), 5, "is 5. It must be a list of numbers");
    ExpectError(With(kIset, "\"conic_constant\": 0", "\"aspherical-equation\": [1e-5,\n\"2\"]"), 6, "is the text '2'. It must be a number");
    ExpectError(With(kIset, "\"surfaces\": [", "\"surfaces\": [\n5,"), 4, "Each surface must be an object");
    ExpectError("{\"surfaces\":\n{\"radius\": 5}}", 2, "It must be a list of surfaces");
    ExpectError(With(kLentil, "\"material\": \"iris\"", "\"material\": 5"), 6, "\"material\" is 5. It must be a text");
    for (const char* text :
         {"\"infinity\"", "450", "null, \"surfaces\": [5]", "{\"infinity\": 450}", "[450]", "[]", "[\"infinity\", \"450\"]"})
        EXPECT_THROW(ReadPrescription(With(kIset, "\"surfaces\"", std::string("\"object-distance\": ") + text + ", \"surfaces\"")),
                     PrescriptionError)
            << text;
    ExpectError(With(kIset, "\"surfaces\"", "\n\"object-distance\": \"infinity\", \"surfaces\""), 4, "It must be a list that begins with");
}

TEST(Prescription, HasLimits)
{
    const auto nested = [](int deep) { return With(kIset, "\"a triplet\"", std::string(deep, '[') + std::string(deep, ']')); };
    ExpectTriplet(ReadPrescription(nested(63)));
    ExpectError(nested(64), 2, "more than 64 deep");
    ExpectError(std::string(50000, '['), 1, "more than 64 deep");
    const auto coefficients = [](int count)
    {
        std::string list = "1e-9";
        for (int i = 1; i < count; i++)
            list += ", 0";
        return With(kIset, "\"conic_constant\": 0", "\n\"aspherical-equation\": [" + list + "]");
    };
    EXPECT_EQ(ReadPrescription(coefficients(20)).rows[1].aspheric.size(), 20u);
    ExpectError(coefficients(21), 6, "with 21 numbers. At most 20 are allowed");
    ExpectError(coefficients(10000), 6, "with 10000 numbers");
    std::string distances = "\"infinity\"";
    for (int i = 0; i < 21; i++)
        distances += ", " + std::to_string(1000 - i);
    ExpectError(With(kIset, "\"surfaces\"", "\"object-distance\": [" + distances + "],\n\"surfaces\""), 3, "with 21 numbers");
}

TEST(Prescription, ChoosesFromADatabase)
{
    const std::string lens = std::string(kLentil).substr(1, std::string(kLentil).rfind('}') - 1);
    const std::string both = "{" + lens + "," + With(lens, "a triplet", "another") + "}";
    ExpectTriplet(ReadPrescription(both, "another"));
    ExpectError(both, 0, "\"FILE#a triplet\"; there are a triplet, another.");
    ExpectError(both, 0, "no lens of the name 'third'", "third");
    ExpectError(both, 0, "no lens of the name 'a triplet, another'", "a triplet, another");
    ExpectError(kIset, 0, "holds one lens", "third");
    const std::string wrong = "{" + lens + "," + With(With(lens, "a triplet", "another"), "\"ior\": 1.6", "\"ior\": 9") + "}";
    ExpectError(wrong, 4 + 13, "index of refraction of 9", "another");
}

} // namespace
} // namespace tilt_lens

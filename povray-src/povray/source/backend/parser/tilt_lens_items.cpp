// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "backend/parser/tilt_lens_items.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>
#include <limits>
#include <vector>

#include "backend/frame.h"
#include "backend/parser/item_reader.h"

#include "base/povdebug.h"

namespace pov
{

using tilt_lens::FocusFamily;
using tilt_lens::kMostEdgeLight;
using tilt_lens::kMostOpticalVignetting;

const NumberRange kFinite = {-HUGE_VAL, HUGE_VAL, ""};
const NumberRange kPositive = {std::numeric_limits<double>::denorm_min(), HUGE_VAL, "It must be larger than 0; give a positive number."};

namespace
{

NumberRange Within(double least, double most, const char* meaning)
{
    return {least, most, Printed("It must be from %g to %g (%s); give a number in between.", least, most, meaning)};
}

const NumberRange kSwitch = kFinite;  // `on` and `off` are numbers
const NumberRange kBlades = {3, 1000, "A diaphragm has a whole number of blades from 3 to 1000; leave blades out for a round one.", true};
const NumberRange kBudget = Within(1, 10000, "mean number of rays a pixel");
const NumberRange kSeed = {0, 4294967295.0, "It takes a whole number from 0 to 4294967295; give another one, such as frame_number.", true};
const NumberRange kEdgeLight = Within(-kMostEdgeLight, kMostEdgeLight, "light in the middle to light at the rim; 0 is even");
const NumberRange kRim = Within(0, kMostOpticalVignetting, "lens diameters by which the rim covers the corners' aperture");
const NumberRange kBend = Within(-1, 1, "pincushion to barrel");
const NumberRange kNearBend = Within(-1, 1, "pincushion to barrel, where the picture is focused nearer");
const NumberRange kImageOfSides = Within(-100, 100,
                                         "millimetres by which the image at the film's left and right edge lies in front of the film");
const NumberRange kFringe = Within(-100, 100, "millimetres between the images of the ends of the spectrum");

#define SET(member) [](TiltLensCamera& lens, double value) { lens.member = value; }

} // namespace

// clang-format off
const std::vector<TiltLensItem> kTiltLensItems = {
    {"film_width", "MM", "36", {{kPositive, SET(statement.filmWidth)}}},
    {"focal_length", "MM", "50", {{kPositive, SET(statement.focalLength)}}},
    {"scene_unit", "MM", "1000", {{kPositive, SET(statement.sceneUnit)}}},
    {"shift", "<RIGHT_MM, UP_MM>", "<0, 8>", {}, ReadShift},
    {"f_stop", "N", "2.8", {{kPositive, SET(statement.fStop)}}},
    {"blades", "N [, DEG]", "5, 90", {{kBlades, SET(statement.blades)}, {kFinite, SET(statement.bladesAngle), "blades' angle"}}},
    {"blade_curvature", "AMOUNT", "0.5", {{Within(0, 1, "straight to round"), SET(statement.bladeCurvature)}}},
    {"squeeze", "RATIO", "2", {{Within(0.1, 10, "lying to upright ovals; 1 is round"), SET(statement.squeeze)}}},
    {"edge_light", "AMOUNT", "0.4", {{kEdgeLight, SET(statement.character.edgeLight)}}},
    {"natural_vignetting", "AMOUNT", "1",
     {{Within(0, 1, "none to that of a real lens"), SET(statement.character.naturalVignetting)}}},
    {"optical_vignetting", "AMOUNT [, N]", "0.5",
     {{kRim, SET(statement.character.opticalVignetting)},
      {kPositive, SET(statement.character.rimStop), "optical_vignetting's f-number"}}},
    {"distortion", "K1 [, K2 [, NEAR]]", "0.05",
     {{kBend, SET(statement.character.distortion1)},
      {kBend, SET(statement.character.distortion2), "distortion's K2"},
      {kNearBend, SET(statement.character.distortionNear), "distortion's NEAR"}}},
    {"field_curvature", "MM", "0.2", {{kImageOfSides, SET(statement.character.fieldCurvature)}}},
    {"lateral_colour", "MM", "0.02", {{kFringe, SET(statement.character.lateralColour)}}},
    {"axial_colour", "MM", "0.1", {{kFringe, SET(statement.character.axialColour)}}},
    {"prescription", "\"FILE\" [, MM]", "\"tessar.dat\"", {}, ReadPrescription},
    {"dispersion", "on/off", "on", {{kSwitch, SET(statement.dispersion)}}},
    {"budget", "RAYS", "12", {{kBudget, SET(statement.budget)}}},
    {"denoise", "on/off", "on", {{kSwitch, SET(statement.denoise)}}},
    {"sample_seed", "N", "frame_number", {{kSeed, SET(statement.sampleSeed)}}},
    {"tilt", "DEG", "6", {{kFinite, SET(statement.tilt)}}, NULL, FocusFamily::LensTurn},
    {"swing", "DEG", "6", {{kFinite, SET(statement.swing)}}, NULL, FocusFamily::LensTurn},
    {"focus_tilt", "DEG", "45", {{kFinite, SET(statement.focusTilt)}}, NULL, FocusFamily::FocusTurn},
    {"focus_swing", "DEG", "45", {{kFinite, SET(statement.focusSwing)}}, NULL, FocusFamily::FocusTurn},
    {"focal_plane", "{ <NORMAL>, DISTANCE }", "{ y, 0 }", {}, ReadFocalPlane, FocusFamily::FocalPlane, true},
    {"focal_points", "POINT, POINT, POINT", "<0, 0, 0>, <1, 0, 0>, <0, 0, 1>", {}, ReadFocalPoints, FocusFamily::FocalPoints, true},
    {"sharp_points", "POINT, POINT, POINT [, POINT...]", "<0, 0, 0>, <1, 0, 0>, <0, 0, 1>, <1, 1, 1>", {}, ReadSharpPoints,
     FocusFamily::SharpPoints, true},
    {"sharp_within", "PIXELS", "2", {{kPositive, SET(sharpWithinPixels)}}},
    {"circle_of_confusion", "MM", "0.03", {{kPositive, SET(statement.sharpWithin)}}},
    {"focus_on", "OBJECT", "Ball", {}, ReadFocusOn, {}, true},
    {"focus_at", "<X, Y>", "<0.5, 0.5>", {}, ReadFocusAt, {}, true},
    {"film_distance", "MM", "52", {{kPositive, SET(statement.filmDistance)}}, NULL, {}, true},
    {"focus_scale", "UNITS", "2", {{kPositive, SET(statement.focusScale)}}, NULL, {}, true},
    {"focus_peaking", "COLOUR [, PIXELS]", "rgb <1, 0, 0>", {}, ReadFocusPeaking},
    {"focus_map", "", "", {}, [](ItemReader&, TiltLensCamera& lens) { lens.aids.map = true; }},
    {"show_planes", "", "", {}, [](ItemReader&, TiltLensCamera& lens) { lens.aids.planes = true; }}};
// clang-format on

#undef SET

namespace
{

const char* const kCameraWords[] = {"aperture",  "focal_point", "look_at",   "blur_samples", "confidence", "variance",   "bokeh",
                                    "angle",     "location",    "direction", "right",        "up",         "sky",        "normal",
                                    "translate", "rotate",      "scale",     "matrix",       "transform",  "perspective"};

std::string Lowercase(std::string word)
{
    for (char& c : word)
        c = char(std::tolower((unsigned char)c));
    return word;
}

size_t EditDistance(const std::string& a, const std::string& b)
{
    std::vector<size_t> row(b.size() + 1);
    for (size_t j = 0; j <= b.size(); j++)
        row[j] = j;
    for (size_t i = 1; i <= a.size(); i++)
    {
        size_t diagonal = row[0];
        row[0] = i;
        for (size_t j = 1; j <= b.size(); j++)
        {
            const size_t kept = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
            diagonal = row[j];
            row[j] = std::min(kept, std::min(row[j], row[j - 1]) + 1);
        }
    }
    return row[b.size()];
}

} // namespace

std::string TiltLensItem::Example() const
{
    return word + std::string(*example ? " " : "") + example;
}

const TiltLensItem* FindTiltLensItem(const std::string& word)
{
    for (const TiltLensItem& item : kTiltLensItems)
        if (word == item.word)
            return &item;
    return NULL;
}

const TiltLensItem& NearestTiltLensItem(const std::string& found)
{
    const std::string word = Lowercase(found);
    return *std::min_element(kTiltLensItems.begin(), kTiltLensItems.end(), [&](const TiltLensItem& a, const TiltLensItem& b)
    { return EditDistance(word, a.word) < EditDistance(word, b.word); });
}

bool LooksLikeTiltLens(const std::string& found)
{
    const std::string word = Lowercase(found);
    return EditDistance(word, "tilt_lens") <= 3 || word.compare(0, 5, "tilt_") == 0 || word == "tiltshift" || word == "shift_lens" ||
           word == "lens";
}

std::string TiltLensItemNames()
{
    std::string words;
    for (const TiltLensItem& item : kTiltLensItems)
        words += std::string(words.empty() ? "" : ", ") + item.word;
    return words;
}

bool IsCameraWord(const std::string& word)
{
    return std::find(std::begin(kCameraWords), std::end(kCameraWords), word) != std::end(kCameraWords);
}

} // namespace pov

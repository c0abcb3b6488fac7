// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "backend/parser/tilt_lens_words.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <vector>

#include "backend/frame.h"
#include "backend/parser/parse_tilt_lens.h"

#include "base/povdebug.h"

namespace pov
{

using tilt_lens::FocusFamily;
using tilt_lens::kMostEdgeLight;

using P = TiltLensParser;
using Lens = TiltLensCamera;
using Word = const std::string&;

namespace
{

const char kLightToRim[] = "light in the middle to light at the rim; 0 is even";
const char kImageOfSides[] = "millimetres by which the image at the film's left and right edge lies in front of the film";
const char kEndsOfSpectrum[] = "millimetres between the images of the ends of the spectrum";

} // namespace

const TiltLensItem TiltLensItems::kAll[35] = {
    {"film_width", NULL, NULL, "film_width 36",
     [](P& p, Word word, Lens& lens) { lens.statement.filmWidth = p.PositiveNumber(word); }},
    {"focal_length", NULL, NULL, "focal_length 50",
     [](P& p, Word word, Lens& lens) { lens.statement.focalLength = p.PositiveNumber(word); }},
    {"scene_unit", NULL, NULL, "scene_unit 1000",
     [](P& p, Word word, Lens& lens) { lens.statement.sceneUnit = p.PositiveNumber(word); }},
    {"shift", NULL, NULL, "shift <0, 8>",
     [](P& p, Word, Lens& lens) { p.ParseShift(lens.statement); }},
    {"f_stop", NULL, NULL, "f_stop 2.8",
     [](P& p, Word word, Lens& lens) { lens.statement.fStop = p.PositiveNumber(word); }},
    {"blades", NULL, NULL, "blades 5, 90",
     [](P& p, Word, Lens& lens) { p.ParseBlades(lens.statement); }},
    {"blade_curvature", NULL, NULL, "blade_curvature 0.5",
     [](P& p, Word word, Lens& lens) { lens.statement.bladeCurvature = p.NumberWithin(word, 0.0, 1.0, "straight to round"); }},
    {"squeeze", NULL, NULL, "squeeze 2",
     [](P& p, Word word, Lens& lens)
     { lens.statement.squeeze = p.NumberWithin(word, 0.1, 10.0, "lying to upright ovals; 1 is round"); }},
    {"edge_light", NULL, NULL, "edge_light 0.4",
     [](P& p, Word word, Lens& lens)
     { lens.statement.character.edgeLight = p.NumberWithin(word, -kMostEdgeLight, kMostEdgeLight, kLightToRim); }},
    {"natural_vignetting", NULL, NULL, "natural_vignetting 1",
     [](P& p, Word word, Lens& lens)
     { lens.statement.character.naturalVignetting = p.NumberWithin(word, 0.0, 1.0, "none to that of a real lens"); }},
    {"optical_vignetting", NULL, NULL, "optical_vignetting 0.5",
     [](P& p, Word, Lens& lens) { p.ParseOpticalVignetting(lens.statement.character); }},
    {"distortion", NULL, NULL, "distortion 0.05",
     [](P& p, Word, Lens& lens) { p.ParseDistortion(lens.statement.character); }},
    {"field_curvature", NULL, NULL, "field_curvature 0.2",
     [](P& p, Word word, Lens& lens)
     { lens.statement.character.fieldCurvature = p.NumberWithin(word, -100.0, 100.0, kImageOfSides); }},
    {"lateral_colour", NULL, NULL, "lateral_colour 0.02",
     [](P& p, Word word, Lens& lens)
     { lens.statement.character.lateralColour = p.NumberWithin(word, -100.0, 100.0, kEndsOfSpectrum); }},
    {"axial_colour", NULL, NULL, "axial_colour 0.1",
     [](P& p, Word word, Lens& lens)
     { lens.statement.character.axialColour = p.NumberWithin(word, -100.0, 100.0, kEndsOfSpectrum); }},
    {"prescription", NULL, NULL, "prescription \"tessar.dat\"",
     [](P& p, Word, Lens& lens) { p.ParsePrescription(lens.statement); }},
    {"dispersion", NULL, NULL, "dispersion on",
     [](P& p, Word word, Lens& lens) { lens.statement.dispersion = p.Switch(word); }},
    {"denoise", NULL, NULL, "denoise on",
     [](P& p, Word word, Lens& lens) { lens.statement.denoise = p.Switch(word); }},
    {"sample_seed", NULL, NULL, "sample_seed frame_number",
     [](P& p, Word, Lens& lens) { p.ParseSampleSeed(lens.statement); }},
    {"tilt", "tilt and swing", NULL, "tilt 6",
     [](P& p, Word word, Lens& lens) { lens.statement.tilt = p.Number(word); }},
    {"swing", "tilt and swing", NULL, "swing 6",
     [](P& p, Word word, Lens& lens) { lens.statement.swing = p.Number(word); }},
    {"focus_tilt", "focus_tilt and focus_swing", NULL, "focus_tilt 45",
     [](P& p, Word word, Lens& lens)
     { lens.statement.focusTilt = p.Number(word); lens.statement.family = FocusFamily::FocusTurn; }},
    {"focus_swing", "focus_tilt and focus_swing", NULL, "focus_swing 45",
     [](P& p, Word word, Lens& lens)
     { lens.statement.focusSwing = p.Number(word); lens.statement.family = FocusFamily::FocusTurn; }},
    {"focal_plane", "focal_plane", "focal_plane", "focal_plane { y, 0 }",
     [](P& p, Word, Lens& lens) { p.ParseFocalPlane(lens.statement); }},
    {"focal_points", "focal_points", "focal_points", "focal_points <0, 0, 0>, <1, 0, 0>, <0, 0, 1>",
     [](P& p, Word, Lens& lens) { p.ParseFocalPoints(lens); }},
    {"sharp_points", "sharp_points", "sharp_points", "sharp_points <0, 0, 0>, <1, 0, 0>, <0, 0, 1>, <1, 1, 1>",
     [](P& p, Word, Lens& lens) { p.ParseSharpPoints(lens); }},
    {"sharp_within", NULL, NULL, "sharp_within 2",
     [](P& p, Word word, Lens& lens) { lens.sharpWithinPixels = p.PositiveNumber(word); }},
    {"circle_of_confusion", NULL, NULL, "circle_of_confusion 0.03",
     [](P& p, Word word, Lens& lens) { lens.statement.sharpWithin = p.PositiveNumber(word); }},
    {"focus_on", NULL, "focus_on", "focus_on Ball",
     [](P& p, Word, Lens& lens) { p.ParseFocusOn(lens.focusTarget); }},
    {"focus_at", NULL, "focus_at", "focus_at <0.5, 0.5>",
     [](P& p, Word, Lens& lens) { p.ParseFocusAt(lens.focusTarget); }},
    {"film_distance", NULL, "film_distance", "film_distance 52",
     [](P& p, Word word, Lens& lens) { lens.statement.filmDistance = p.PositiveNumber(word); }},
    {"focus_scale", NULL, "focus_scale", "focus_scale 2",
     [](P& p, Word word, Lens& lens) { lens.statement.focusScale = p.PositiveNumber(word); }},
    {"focus_peaking", NULL, NULL, "focus_peaking rgb <1, 0, 0>",
     [](P& p, Word, Lens& lens) { p.ParsePeaking(lens.aids); }},
    {"focus_map", NULL, NULL, "focus_map",
     [](P& p, Word, Lens& lens) { lens.aids.map = true; p.RequireAidsTogether(lens.aids); }},
    {"show_planes", NULL, NULL, "show_planes",
     [](P& p, Word, Lens& lens) { lens.aids.planes = true; p.RequireAidsTogether(lens.aids); }}};

namespace
{

/// Items of the camera that users expect inside the block.
const char* const kCameraWords[] = {"aperture",   "focal_point", "look_at",  "blur_samples", "confidence",
                                    "variance",   "bokeh",       "angle",    "location",     "direction",
                                    "right",      "up",          "sky",      "normal",       "translate",
                                    "rotate",     "scale",       "matrix",   "transform",    "perspective"};

std::string Lowercase(std::string word)
{
    for (char& c : word)
        c = char(std::tolower((unsigned char)c));
    return word;
}

/// Levenshtein distance.
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

const TiltLensItem* FindTiltLensItem(const std::string& word)
{
    const TiltLensItem* item = std::find_if(std::begin(TiltLensItems::kAll), std::end(TiltLensItems::kAll),
                                            [&](const TiltLensItem& i) { return word == i.word; });
    return item == std::end(TiltLensItems::kAll) ? NULL : item;
}

const TiltLensItem& NearestTiltLensItem(const std::string& found)
{
    const std::string word = Lowercase(found);
    return *std::min_element(std::begin(TiltLensItems::kAll), std::end(TiltLensItems::kAll),
                             [&](const TiltLensItem& a, const TiltLensItem& b)
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
    for (const TiltLensItem& item : TiltLensItems::kAll)
        words += std::string(words.empty() ? "" : ", ") + item.word;
    return words;
}

bool IsCameraWord(const std::string& word)
{
    return std::find(std::begin(kCameraWords), std::end(kCameraWords), word) != std::end(kCameraWords);
}

} // namespace pov

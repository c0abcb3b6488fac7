// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "backend/parser/tilt_lens_words.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <vector>

namespace pov
{

const TiltLensItem kTiltLensItems[32] = {
    {"film_width", NULL, NULL, "film_width 36"},
    {"focal_length", NULL, NULL, "focal_length 50"},
    {"scene_unit", NULL, NULL, "scene_unit 1000"},
    {"shift", NULL, NULL, "shift <0, 8>"},
    {"f_stop", NULL, NULL, "f_stop 2.8"},
    {"blades", NULL, NULL, "blades 5, 90"},
    {"blade_curvature", NULL, NULL, "blade_curvature 0.5"},
    {"squeeze", NULL, NULL, "squeeze 2"},
    {"edge_light", NULL, NULL, "edge_light 0.4"},
    {"natural_vignetting", NULL, NULL, "natural_vignetting 1"},
    {"optical_vignetting", NULL, NULL, "optical_vignetting 0.5"},
    {"distortion", NULL, NULL, "distortion 0.05"},
    {"field_curvature", NULL, NULL, "field_curvature 0.2"},
    {"lateral_colour", NULL, NULL, "lateral_colour 0.02"},
    {"axial_colour", NULL, NULL, "axial_colour 0.1"},
    {"prescription", NULL, NULL, "prescription \"tessar.dat\""},
    {"dispersion", NULL, NULL, "dispersion on"},
    {"denoise", NULL, NULL, "denoise on"},
    {"sample_seed", NULL, NULL, "sample_seed frame_number"},
    {"tilt", "tilt and swing", NULL, "tilt 6"},
    {"swing", "tilt and swing", NULL, "swing 6"},
    {"focus_tilt", "focus_tilt and focus_swing", NULL, "focus_tilt 45"},
    {"focus_swing", "focus_tilt and focus_swing", NULL, "focus_swing 45"},
    {"focal_plane", "focal_plane", "focal_plane", "focal_plane { y, 0 }"},
    {"focal_points", "focal_points", "focal_points", "focal_points <0, 0, 0>, <1, 0, 0>, <0, 0, 1>"},
    {"focus_on", NULL, "focus_on", "focus_on Ball"},
    {"focus_at", NULL, "focus_at", "focus_at <0.5, 0.5>"},
    {"film_distance", NULL, "film_distance", "film_distance 52"},
    {"focus_scale", NULL, "focus_scale", "focus_scale 2"},
    {"focus_peaking", NULL, NULL, "focus_peaking rgb <1, 0, 0>"},
    {"focus_map", NULL, NULL, "focus_map"},
    {"show_planes", NULL, NULL, "show_planes"}};

namespace
{

/// Words that people look for inside the block although they belong to the camera around it.
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

/// Edits that turn one word into the other (Levenshtein).
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
    const TiltLensItem* item = std::find_if(std::begin(kTiltLensItems), std::end(kTiltLensItems),
                                            [&](const TiltLensItem& i) { return word == i.word; });
    return item == std::end(kTiltLensItems) ? NULL : item;
}

const TiltLensItem& NearestTiltLensItem(const std::string& found)
{
    const std::string word = Lowercase(found);
    return *std::min_element(std::begin(kTiltLensItems), std::end(kTiltLensItems),
                             [&](const TiltLensItem& a, const TiltLensItem& b)
                             { return EditDistance(word, a.word) < EditDistance(word, b.word); });
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

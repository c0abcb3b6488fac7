// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file parse_tilt_lens_values.cpp
/// The values of the items of `tilt_lens { ... }`.

#include "backend/parser/parse_tilt_lens.h"

#include <cmath>

#include "backend/frame.h"
#include "backend/parser/parse.h"
#include "backend/parser/tilt_lens_words.h"

#include "base/povdebug.h"

namespace pov
{

using tilt_lens::Character;
using tilt_lens::kMostOpticalVignetting;
using tilt_lens::Statement;
using tilt_lens::Vec3;

/// Refuses what no value begins with, while it is known which item lacks it.
void TiltLensParser::RequireValue(const std::string& word)
{
    parser.Get_Token();
    const int token = parser.Token.Token_Id;
    const std::string text = parser.Token.Token_String;
    parser.Unget_Token();
    const TiltLensItem* known = FindTiltLensItem(word.substr(0, word.find('\'')));
    std::string found;
    if (token == END_OF_FILE_TOKEN)
        found = "the end of the file";
    else if (token == IDENTIFIER_TOKEN || token == STRING_LITERAL_TOKEN || token == RIGHT_CURLY_TOKEN ||
             token == LEFT_CURLY_TOKEN || token == COMMA_TOKEN || token == SEMI_COLON_TOKEN)
        found = (token == IDENTIFIER_TOKEN && FindTiltLensItem(text) == NULL ? "the undeclared '" : "'") + text + "'";
    else
        return;
    ErrorAt(item, "%s in tilt_lens has no value: found %s in its place. Write it as %s, with a number, a vector or an "
                  "expression of them.", word.c_str(), found.c_str(), known == NULL ? word.c_str() : known->example);
}

double TiltLensParser::Number(const std::string& word)
{
    RequireValue(word);
    EXPRESS v;
    const int terms = parser.Parse_Unknown_Vector(v);
    if (terms != 1)
        ErrorAt(item, "%s in tilt_lens: found a value of %d numbers. It takes one number; write one, or a component such "
                      "as .x of a vector.", word.c_str(), terms);
    const double value = v[0];
    if (!std::isfinite(value))
        ErrorAt(item, "%s %g in tilt_lens. It must be a finite number; check the expression.", word.c_str(),
                     value);
    return value;
}

double TiltLensParser::PositiveNumber(const std::string& word)
{
    const double value = Number(word);
    if (!(value > 0.0))
        ErrorAt(item, "%s %g in tilt_lens. It must be larger than 0; give a positive number.", word.c_str(),
                     value);
    return value;
}

/// `on` and `off` are numbers.
bool TiltLensParser::Switch(const std::string& word)
{
    return Number(word) != 0.0;
}

/// @param meaning  of the least and the greatest value
double TiltLensParser::NumberWithin(const std::string& word, double least, double most, const char* meaning)
{
    const double value = Number(word);
    if (!(value >= least && value <= most))
        ErrorAt(item, "%s %g in tilt_lens. It must be from %g to %g (%s); give a number in between.", word.c_str(), value,
                least, most, meaning);
    return value;
}

Vec3 TiltLensParser::Vector(const std::string& word)
{
    RequireValue(word);
    EXPRESS v;
    const int terms = parser.Parse_Unknown_Vector(v);
    if (terms != 3)
        ErrorAt(item, "%s in tilt_lens: found a value of %d numbers. A point or normal has three; write it as "
                     "<x, y, z>.", word.c_str(), terms);
    const Vec3 value{v[X], v[Y], v[Z]};
    if (!IsFinite(value))
        ErrorAt(item, "%s in tilt_lens: found <%g, %g, %g>. All three numbers must be finite; check the "
                     "expression.", word.c_str(), v[X], v[Y], v[Z]);
    return value;
}

void TiltLensParser::ParseShift(Statement& s)
{
    RequireValue("shift");
    EXPRESS v;
    const int terms = parser.Parse_Unknown_Vector(v);
    // a plain number would be promoted to both directions: surely not what was meant
    if (!(terms == 2 || (terms == 3 && v[Z] == 0.0)))
        ErrorAt(item, "shift in tilt_lens: found a value of %d numbers. It takes two, in millimetres; write it "
                     "as <right, up>.", terms);
    if (!std::isfinite(v[X]) || !std::isfinite(v[Y]))
        ErrorAt(item, "shift <%g, %g> in tilt_lens. Both numbers must be finite; check the expression.", v[X],
                     v[Y]);
    s.shiftRight = v[X];
    s.shiftUp = v[Y];
}

void TiltLensParser::ParseSampleSeed(Statement& s)
{
    const double kMost = 4294967295.0;  // 32 bits
    const double seed = Number("sample_seed");
    if (!(seed >= 0.0 && seed <= kMost && seed == std::floor(seed)))
        ErrorAt(item, "sample_seed %.12g in tilt_lens. It takes a whole number from 0 to %.0f; give another one, such as "
                     "frame_number.", seed, kMost);
    s.sampleSeed = std::uint32_t(seed);
}

void TiltLensParser::ParseBlades(Statement& s)
{
    const int kMost = 1000;  // edges far below any pixel
    const double count = Number("blades");
    if (!(count >= 3.0 && count <= kMost && count == std::floor(count)))
        ErrorAt(item, "blades %g in tilt_lens. A diaphragm has a whole number of blades from 3 to %d; leave "
                     "blades out for a round one.", count, kMost);
    s.blades = int(count);
    if (NextIsComma())
        s.bladesAngle = Number("blades' angle");
}

/// Takes a comma, behind which an item's second value stands; leaves anything else.
bool TiltLensParser::NextIsComma()
{
    parser.Get_Token();
    const bool comma = parser.Token.Token_Id == COMMA_TOKEN;
    if (!comma)
        parser.Unget_Token();
    return comma;
}

void TiltLensParser::ParseOpticalVignetting(Character& c)
{
    c.opticalVignetting = NumberWithin("optical_vignetting", 0.0, kMostOpticalVignetting,
                                       "lens diameters by which the rim covers the corners' aperture");
    if (NextIsComma())
        c.rimStop = PositiveNumber("optical_vignetting's f-number");
}

void TiltLensParser::ParseDistortion(Character& c)
{
    const char* const meaning = "pincushion to barrel";
    c.distortion1 = NumberWithin("distortion", -1.0, 1.0, meaning);
    if (NextIsComma())
        c.distortion2 = NumberWithin("distortion's K2", -1.0, 1.0, meaning);
    else
        return;
    if (NextIsComma())
        c.distortionNear = NumberWithin("distortion's NEAR", -1.0, 1.0, "pincushion to barrel, where the picture is focused nearer");
}

} // namespace pov

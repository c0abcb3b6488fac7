// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file parse_tilt_lens.h
/// The parser's part in `camera { ... tilt_lens { ... } }`. A friend of Parser, so that upstream's
/// parser needs one line for it and a call at each of four places.

#ifndef POVRAY_BACKEND_PARSE_TILT_LENS_H
#define POVRAY_BACKEND_PARSE_TILT_LENS_H

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "backend/frame.h"
#include "backend/scene/camera.h"

namespace pov
{

class Parser;
struct Sym_Table_Entry;
struct TiltLensItems;

class TiltLensParser
{
  public:
    explicit TiltLensParser(Parser& parser) : parser(parser) {}

    /// Parses `{ ... }` behind the word `tilt_lens`. Inside, the items hide macros of their names.
    void ParseBlock(Camera& camera);

    /// The same behind a camera's identifier: the block takes the place of the camera's own, whose other items stay.
    void ParseBlockBehindIdentifier(Camera& camera);

    /// Makes the name known by which a scene can tell that this program has the camera.
    void DeclareFeature();

    /// Keeps a warning of the camera's own items until its end, where it is known whether the camera has `tilt_lens`: with
    /// it, the value is an error, and a default that is not used must not be told of.
    void WarnLater(Camera& camera, const char* text);

    /// @name Errors where upstream's would not name the block.
    /// @{
    void RefuseOtherType(const Camera& camera);
    void RefuseStrangeItem();
    /// @}

    /// Tells the kept warnings if the camera has no `tilt_lens`; else takes from the camera's own items what the lens
    /// needs, while the parser can still tell which of them were written. Call before POV-Ray fills in the others.
    void TakeCameraItems(Camera& camera);

    /// Solves the lens of a camera that is parsed and transformed, for its errors and warnings. Also other cameras
    /// pass here, to be recorded (camera_record.h).
    void Check(Camera& camera);

    /// Refuses arguments of the wrong kind for a macro of tilt_lens.inc, where they are given.
    /// @param names  of its parameters
    void CheckMacro(const char* macro, Sym_Table_Entry* const* arguments, char* const* names, int count);

  private:
    friend TiltLensItems;  // whose functions parse the items

    Parser& parser;
    TiltLensPlace item;  ///< where the current item's word stands; its value may end lines later

    TiltLensPlace Here() const;
    bool NextItem(std::string& word, std::set<std::string>& seen);
    void ParseOpticalVignetting(tilt_lens::Character& character);
    void ParseDistortion(tilt_lens::Character& character);
    void ParsePrescription(tilt_lens::Statement& statement);
    std::string ReadWhole(const std::string& name);
    void RequireAidsTogether(const tilt_lens::FocusAids& aids);
    void NotAnItem(const std::string& word);
    void ClaimOnce(const std::string& word, std::set<std::string>& seen);
    std::vector<Sym_Table_Entry*> MacrosNamedAsItems();

    void RequireValue(const std::string& word);
    double Number(const std::string& word);
    double PositiveNumber(const std::string& word);
    bool Switch(const std::string& word);
    double NumberWithin(const std::string& word, double least, double most, const char* meaning);
    bool NextIsComma();
    tilt_lens::Vec3 Vector(const std::string& word);
    void ParseShift(tilt_lens::Statement& statement);
    void ParseBlades(tilt_lens::Statement& statement);
    void ParseSampleSeed(tilt_lens::Statement& statement);
    void ParseFocalPlane(tilt_lens::Statement& statement);
    void PlaneBrace(int brace, const char* sign);
    void ParseFocalPoints(TiltLensCamera& lens);
    void ParseSharpPoints(TiltLensCamera& lens);
    bool ParseTarget(FocusTarget& target);
    void ParseFocusOn(FocusTarget& target);
    void ParseFocusAt(FocusTarget& target);
    void ParsePeaking(tilt_lens::FocusAids& aids);

    void CheckBlock(Camera& camera);
    void SolveLens(Camera& camera);
    void RequireConsistent(const Camera& camera);
    void RequireFilm(const Camera& camera);
    void RequireSharpPoints(const Camera& camera);
    void RequireNoOtherLens(const Camera& camera);
    void RequireColours(const tilt_lens::Statement& statement, const TiltLensPlace& place);
    void TakeQuality(Camera& camera, const WrittenItems& written);
    void RequireAperture(const Camera& camera);
    void TakeFocalPoint(Camera& camera);
    void RequireFocus(Camera& camera);
    void TakeBlurSamples(Camera& camera);
    void WarnOfFocalPoint(const Camera& camera);
    void WarnOfSky(const Camera& camera);
    void RequireFacade(const Camera& camera);
    std::optional<tilt_lens::Vec3> DeclaredVector(const char* name);

    /// printf-like; throws.
    void ErrorAt(const TiltLensPlace& place, const char* format, ...);
    void WarningAt(const TiltLensPlace& place, const std::string& text);
};

} // namespace pov

#endif

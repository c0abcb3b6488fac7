// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file parse_tilt_lens.h
/// The parser's part in `camera { ... tilt_lens { ... } }`: all that the patches of upstream's parser call.

#ifndef POVRAY_BACKEND_PARSE_TILT_LENS_H
#define POVRAY_BACKEND_PARSE_TILT_LENS_H

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "backend/frame.h"
#include "backend/scene/camera.h"

namespace pov
{

class Parser;
struct Sym_Table_Entry;

/// A camera statement while it is parsed: all that POV-Ray's Camera does not keep.
struct CameraDraft
{
    bool hasBlock = false;                    ///< `tilt_lens` stands in this statement
    bool aperture = false;                    ///< written, perhaps with the default value 0
    double variance = 0.0, confidence = 0.9;  ///< as written; else the default
    tilt_lens::Vec3 facade;  ///< from the lower left to the lower right corner given to Tilt_Lens_Facade; 0: none

    struct Warning
    {
        TiltLensPlace place;
        std::string text;
    };
    std::vector<Warning> warnings;  ///< about values that are errors if the camera has `tilt_lens`
};

/// A friend of Parser.
class TiltLensParser
{
  public:
    explicit TiltLensParser(Parser& parser) : parser(parser) {}

    /// Declares the name by which a scene can tell that this program has the camera.
    void DeclareFeature();

    /// The draft of a camera statement that is being parsed.
    CameraDraft& Draft(const Camera& camera);

    /// Parses `{ ... }` behind the word `tilt_lens`. Inside, the items hide macros of their names.
    void ParseBlock(Camera& camera);

    /// The same behind a camera's identifier: the block takes the place of the camera's own, whose other items stay.
    void ParseBlockBehindIdentifier(Camera& camera);

    /// Keeps a warning of the camera's own items until its end, where it is known whether the camera has `tilt_lens`: with
    /// it, the value is an error, and a default that is not used must not be told of.
    void WarnLater(Camera& camera, const char* text);

    /// @name Errors where upstream's would not name the block.
    /// @{
    void RefuseOtherType(const Camera& camera);
    void RefuseStrangeItem(const Camera& camera);
    /// @}

    /// Tells the kept warnings if the camera has no `tilt_lens`; else takes from the camera's own items what the lens
    /// needs, while the parser can still tell which of them were written. Call before POV-Ray fills in the others.
    void TakeCameraItems(Camera& camera);

    /// Solves the lens of a camera that is parsed and transformed, for its errors and warnings, and ends the draft. Also other cameras
    /// pass here, to be recorded (camera_record.h).
    void Check(Camera& camera);

    /// @name Inside a macro of tilt_lens.inc, send a message that names the call of this macro; elsewhere does nothing.
    /// @{
    void ErrorAtCall(const char* text);
    /// @return  false: nothing is done
    bool WarningAtCall(unsigned int level, const char* text);
    /// @}

    /// Refuses arguments of the wrong kind for a macro of tilt_lens.inc, where they are given.
    /// @param names  of its parameters
    void CheckMacro(const char* macro, Sym_Table_Entry* const* arguments, char* const* names, int count);

  private:
    Parser& parser;

    std::optional<TiltLensPlace> Call() const;
    TiltLensPlace Here() const;
    bool ParseItem(TiltLensCamera& lens);
    void RefuseWord(const std::string& word);
    std::vector<Sym_Table_Entry*> MacrosNamedAsItems();
    std::optional<tilt_lens::Vec3> DeclaredVector(const char* name);
    void CheckBlock(Camera& camera);
    void SolveLens(Camera& camera);

    void ErrorAt(const TiltLensPlace& place, const std::string& text);
    void WarningAt(const TiltLensPlace& place, const std::string& text, unsigned int level = 0);

    /// Calls something, and gives its OpticsError a place.
    template<class Task>
    void At(const TiltLensPlace& place, const Task& task);
};

} // namespace pov

#endif

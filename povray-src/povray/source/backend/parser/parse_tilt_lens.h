// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file parse_tilt_lens.h
/// Parses `camera { ... tilt_lens { ... } }`: everything that the patches of upstream's parser call.

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

/// Data of a camera statement during parsing that POV-Ray's Camera does not keep.
struct CameraDraft
{
    bool hasBlock = false;
    bool aperture = false;           ///< written, even as 0
    std::optional<double> variance;  ///< as written
    double confidence = 0.9;         ///< written or default
    tilt_lens::Vec3 facade;          ///< lower left to lower right corner of Tilt_Lens_Facade; 0: none

    struct Warning
    {
        TiltLensPlace place;
        std::string text;
    };
    std::vector<Warning> warnings;  ///< errors if the camera has `tilt_lens`
};

class TiltLensParser
{
  public:
    explicit TiltLensParser(Parser& parser) : parser(parser) {}

    void DeclareFeature();

    CameraDraft& Draft(const Camera& camera);

    /// Parses `{ ... }` behind `tilt_lens`. Inside, items hide macros of their names.
    void ParseBlock(Camera& camera);

    /// Behind a camera's identifier: the block replaces the camera's block, other items stay.
    void ParseBlockBehindIdentifier(Camera& camera);

    /// Keeps a warning until the camera's end: with `tilt_lens` the value is an error, and an unused default needs no warning.
    void WarnLater(Camera& camera, const char* text);

    /// @name Errors that upstream would give without naming the block.
    /// @{
    void RefuseOtherType(const Camera& camera);
    void RefuseStrangeItem(const Camera& camera);
    /// @}

    /// Sends the kept warnings if the camera has no `tilt_lens`; else takes the lens's data from the camera's own items. Call before
    /// POV-Ray fills in unwritten items.
    void TakeCameraItems(Camera& camera);

    /// Solves a parsed and transformed camera's lens, for errors and warnings. Records any camera (camera_record.h).
    void Check(Camera& camera);

    /// @name Inside a macro of tilt_lens.inc, send a message that names the macro's call.
    /// @{
    void ErrorAtCall(const char* text);
    /// @return  false: not inside a macro
    bool WarningAtCall(unsigned int level, const char* text);
    /// @}

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

    template<class Task>
    void At(const TiltLensPlace& place, const Task& task);
};

} // namespace pov

#endif

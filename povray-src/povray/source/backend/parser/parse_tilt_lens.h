// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file parse_tilt_lens.h
/// Parses `camera { ... tilt_lens { ... } }` for the patches of upstream's parser.

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

/// Data that POV-Ray's Camera does not keep.
struct CameraDraft
{
    bool hasBlock = false;
    bool aperture = false;           ///< written, even as 0
    std::optional<double> variance;
    double confidence = 0.9;
    tilt_lens::Vec3 facade;          ///< lower left to lower right corner; 0: none

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

    /// Items hide macros of their names.
    void ParseBlock(Camera& camera);

    /// The block replaces the camera's block, other items stay.
    void ParseBlockBehindIdentifier(Camera& camera);

    /// Keeps a warning until the camera's end, where `tilt_lens` makes it an error.
    void WarnLater(Camera& camera, const char* text);

    /// @name Errors for which upstream would not name the block.
    /// @{
    void RefuseOtherType(const Camera& camera);
    void RefuseStrangeItem(const Camera& camera);
    /// @}

    /// Call before POV-Ray fills in unwritten items.
    void TakeCameraItems(Camera& camera);

    /// Solves the lens, and records the camera.
    void Check(Camera& camera);

    /// @name Messages that name the macro's call.
    /// @{
    void ErrorAtCall(const char* text);
    /// False: not inside a macro.
    bool WarningAtCall(unsigned int level, const char* text);
    /// @}

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

// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file state_key.h
/// The key of a state file, from which `+C` continues: it identifies the render that the file's tiles belong to.
///
/// The key is text, one `name=value` per line: the program, the options that change pixels or the numbering of tiles, and a hash of each
/// file read while parsing. It is the first message of the file.

#ifndef POVRAY_FRONTEND_STATE_KEY_H
#define POVRAY_FRONTEND_STATE_KEY_H

#include <string>

#include "base/configbase.h"
#include "base/fileinputoutput.h"
#include "base/path.h"
#include "base/povmscpp.h"
#include "base/scene_attributes.h"

namespace pov_frontend
{

struct ViewData;

enum
{
    kPOVMsgIdent_StateKey = 'StKe',
    kPOVAttrib_StateKey = 'StKe'  ///< string
};

/// Key of the render that is about to start; call after parsing.
std::string StateKey(POVMS_Object& options);

/// Writes the key behind the header of a new state file.
/// @throws pov_base::Exception  it could not be written
void WriteStateKey(pov_base::OStream& file, const std::string& key);

/// Compares a state file with the render that is to continue it. Removes a file without tiles, which a program that was stopped at once
/// leaves.
/// @param refuse  differences are errors (scenes with `tilt_lens`), else remarks
/// @return        a remark for the user, or an empty string
/// @throws pov_base::Exception  the file belongs to another render, or to none; always if that picture was larger
std::string CompareState(const pov_base::Path& file, const std::string& key, bool refuse);

/// Checks a state file's message before it is drawn.
/// @throws pov_base::Exception  a tile is outside the picture or incomplete
void RequireWholeTile(const ViewData& view, POVMS_Object& message);

} // namespace pov_frontend

#endif

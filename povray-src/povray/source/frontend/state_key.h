// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file state_key.h
/// First message of a state file, from which `+C` continues: one `name=value` per line, with the program, options that change pixels or the
/// numbering of tiles, and a hash of each file read while parsing.

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

/// Call after parsing.
std::string StateKey(POVMS_Object& options);

/// @throws pov_base::Exception  unwritable file
void WriteStateKey(pov_base::OStream& file, const std::string& key);

/// Removes a file without tiles, as left by a program stopped at once.
/// @param refuse  differences are errors, else remarks
/// @return        a remark or an empty string
/// @throws pov_base::Exception  a difference, if `refuse`; always if tiles do not fit the picture
std::string CompareState(const pov_base::Path& file, const std::string& key, bool refuse);

/// @throws pov_base::Exception  a tile is outside the picture or incomplete
void RequireWholeTile(const ViewData& view, POVMS_Object& message);

}  // namespace pov_frontend

#endif

// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file state_key.h
/// The key of a state file, which `+C` continues from: it says which render the tiles in the file belong to.
///
/// The key is text, one `name=value` a line: the program, the options that change a pixel or the numbers of the
/// tiles, and a hash of each file that was read while the scene was parsed. It is the first message of the file.

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
    kPOVAttrib_StateKey   = 'StKe'  ///< string
};

/// The key of the render that is about to start. Its scene must have been parsed.
std::string StateKey(POVMS_Object& options);

/// Why no state file could be made, from errno, for an error before the render.
std::string CannotCreateState(const pov_base::Path& file);

/// Writes the key behind the header of a new state file.
/// @throws pov_base::Exception  it could not be written
void WriteStateKey(pov_base::OStream& file, const std::string& key);

/// Compares a state file with the render that is to continue it. A file without any tile, as a program leaves that was
/// stopped at once, is removed.
/// @param refuse   whether a difference is an error (scenes with `tilt_lens`) or a remark (others)
/// @return a remark for the user, or nothing
/// @throws pov_base::Exception  the file belongs to another render, or to none; a smaller picture is always refused
std::string CompareState(const pov_base::Path& file, const std::string& key, bool refuse);

/// Looks at a message of a state file before it is drawn.
/// @throws pov_base::Exception  a tile that does not lie in the picture or is not whole
void RequireWholeTile(const ViewData& view, POVMS_Object& message);

} // namespace pov_frontend

#endif

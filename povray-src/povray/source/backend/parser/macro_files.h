// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file macro_files.h
/// Text files that were opened to read a macro of theirs and that nobody reads now. A macro from another file is read
/// there each time that it is invoked, and to open a file the parser must ask the frontend where it lies.

#ifndef POVRAY_BACKEND_MACRO_FILES_H
#define POVRAY_BACKEND_MACRO_FILES_H

#include <cstddef>
#include <memory>
#include <vector>

#include "backend/frame.h"
#include "base/textstream.h"

namespace pov
{

class MacroFiles
{
  public:
    /// A file that was kept under this name, at any position; the caller owns it. Null: there is none.
    pov_base::ITextStream* Take(const UCS2* name);
    /// Keeps a file that the caller owned. Of more than `most` the one that has lain longest is closed.
    void Keep(pov_base::ITextStream* file);
    /// The scene may have changed files: closes what is kept.
    void Forget() { files.clear(); }

    /// The system allows a program some thousand open files.
    static constexpr std::size_t most = 32;

  private:
    std::vector<std::unique_ptr<pov_base::ITextStream>> files;  ///< the last kept is the last
};

} // namespace pov

#endif

// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file macro_files.h
/// Text files kept open, since a macro is read from its file at each invocation.

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
    /// The caller owns the file, at any position; null if there is none.
    pov_base::ITextStream* Take(const UCS2* name);
    /// Takes ownership. Beyond `most` files, closes the oldest.
    void Keep(pov_base::ITextStream* file);
    void Forget() { files.clear(); }

    static constexpr std::size_t most = 32;

  private:
    std::vector<std::unique_ptr<pov_base::ITextStream>> files;
};

} // namespace pov

#endif

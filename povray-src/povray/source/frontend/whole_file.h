// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file whole_file.h
/// A file that gets its name only when it is complete: it is written beside its place and renamed at the end. A full disk or a killed
/// program leaves no truncated file, and keeps an older file of that name.

#ifndef POVRAY_FRONTEND_WHOLE_FILE_H
#define POVRAY_FRONTEND_WHOLE_FILE_H

#include <memory>
#include <string>

#include <boost/scoped_ptr.hpp>

#include "base/fileinputoutput.h"
#include "base/path.h"
#include "base/stringutilities.h"

namespace pov_frontend
{

class WholeFile
{
  public:
    explicit WholeFile(const pov_base::UCS2String& filename);

    ~WholeFile();

    WholeFile(const WholeFile&) = delete;
    WholeFile& operator=(const WholeFile&) = delete;

    /// Where to write: the final name itself if it is no regular file (standard output, a device), or if its folder is not writable.
    pov_base::UCS2String Place() const;

    /// Closes the file and renames it.
    /// @throws pov_base::Exception  it could not be completely written
    void Finish(boost::scoped_ptr<pov_base::OStream>& file);

    [[noreturn]] void Fail(const pov_base::Exception& cause) const;

  private:
    std::string target, place;
    bool finished = false;
};

/// True for `-`, `stdout` and `stderr`, in any case.
bool IsStandardStream(const std::string& name);

/// Closes and removes the state file of a finished picture; `file` may be null.
void RemoveState(std::shared_ptr<pov_base::OStream>& file, const pov_base::Path& name);

} // namespace pov_frontend

#endif

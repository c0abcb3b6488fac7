// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file whole_file.h
/// A file that appears under its name only when all of it is on the disk: it is written beside its
/// place and moved there at the end. A full disk or a killed program leaves no torn file, and an
/// older one of that name stays until the new one is whole.

#ifndef POVRAY_FRONTEND_WHOLE_FILE_H
#define POVRAY_FRONTEND_WHOLE_FILE_H

#include <memory>
#include <string>

#include <boost/scoped_ptr.hpp>

#include "base/fileinputoutput.h"
#include "base/path.h"
#include "base/povmscpp.h"
#include "base/stringutilities.h"

namespace pov_frontend
{

class WholeFile
{
  public:
    explicit WholeFile(const pov_base::UCS2String& filename);

    /// Removes what was not finished.
    ~WholeFile();

    WholeFile(const WholeFile&) = delete;
    WholeFile& operator=(const WholeFile&) = delete;

    /// Where to write: the name itself where it is no ordinary file (standard output, a device), or
    /// where its folder takes no other file.
    pov_base::UCS2String Place() const;

    /// Closes the file and gives it its name.
    /// @throws pov_base::Exception  not all of it could be written
    void Finish(boost::scoped_ptr<pov_base::OStream>& file);

    /// Throws an error that says which file could not be written, why, and what to do.
    [[noreturn]] void Fail(const pov_base::Exception& cause) const;

  private:
    std::string target, place;
    bool finished = false;
};

/// Whether an output's name means standard output or error: `-`, `stdout`, `stderr`, in any case.
bool IsStandardStream(const std::string& name);

/// Writes pixels to a render's state file. Where not all of them are taken, it is closed, so that nothing is written behind them.
/// @throws Exception  with the file's name and the reason
void WriteState(POVMS_Object& pixels, std::shared_ptr<pov_base::OStream>& state, const pov_base::Path& name);

/// Closes and removes the state file of a picture that is written; none may be open.
void RemoveState(std::shared_ptr<pov_base::OStream>& file, const pov_base::Path& name);

} // namespace pov_frontend

#endif

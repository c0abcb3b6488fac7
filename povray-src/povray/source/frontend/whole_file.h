// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file whole_file.h
/// Writes a file under another name and renames it when complete, so that no failure leaves a truncated file.

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

    /// The final name if it is no regular file (standard output, a device) or in a read-only folder.
    pov_base::UCS2String Place() const;

    /// @throws pov_base::Exception  incompletely written
    void Finish(boost::scoped_ptr<pov_base::OStream>& file);

    [[noreturn]] void Fail(const pov_base::Exception& cause) const;

  private:
    std::string target, place;
    bool finished = false;
};

bool IsStandardStream(const std::string& name);

/// `file` may be null.
void RemoveState(std::shared_ptr<pov_base::OStream>& file, const pov_base::Path& name);

} // namespace pov_frontend

#endif

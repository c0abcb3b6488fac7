// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "frontend/whole_file.h"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <sys/stat.h>
#include <unistd.h>

#include "base/file_list.h"
#include "base/pov_err.h"

#include "base/povdebug.h"

namespace pov_frontend
{

using pov_base::OStream;
using pov_base::UCS2String;

namespace
{

std::string Resolved(const std::string& name)
{
    char* path = realpath(name.c_str(), NULL);
    if (path == NULL)
        return name;
    const std::string resolved(path);
    std::free(path);
    return resolved;
}

/// True if `name` is no device and not write-protected, and its folder is writable.
bool MayBeReplaced(const std::string& name)
{
    struct stat found;
    if (stat(name.c_str(), &found) == 0 && (!S_ISREG(found.st_mode) || access(name.c_str(), W_OK) != 0))
        return false;
    const std::string::size_type slash = name.rfind('/');
    const std::string folder = slash == std::string::npos ? "." : name.substr(0, slash + 1);
    return access(folder.c_str(), W_OK) == 0;
}

} // namespace

bool IsStandardStream(const std::string& name)
{
    return name == "-" || strcasecmp(name.c_str(), "stdout") == 0 || strcasecmp(name.c_str(), "stderr") == 0;
}

WholeFile::WholeFile(const UCS2String& filename) : target(pov_base::UCS2toASCIIString(filename))
{
    if (!IsStandardStream(target))
        target = Resolved(target);
    // two processes may write the same picture
    place = IsStandardStream(target) || !MayBeReplaced(target) ? target : target + "." + std::to_string(getpid()) + ".part";
    errno = 0;
}

WholeFile::~WholeFile()
{
    if (!finished && place != target)
        std::remove(place.c_str());
}

UCS2String WholeFile::Place() const
{
    return pov_base::ASCIItoUCS2String(place.c_str());
}

void WholeFile::Finish(boost::scoped_ptr<OStream>& file)
{
    // flushes: the file is complete if its size matches
    errno = 0;
    file->seekg(0, pov_base::IOBase::seek_end);
    const POV_LONG size = file->tellg();
    const bool failed = !*file;
    file.reset();
    if (IsStandardStream(target))
        return;
    struct stat found;
    const bool ordinary = stat(place.c_str(), &found) == 0 && S_ISREG(found.st_mode);
    if (ordinary && (failed || found.st_size != size))
        throw POV_EXCEPTION(pov_base::kFileDataErr, "only a part of it was written");
    if (place != target && std::rename(place.c_str(), target.c_str()) != 0)
        throw POV_EXCEPTION(pov_base::kCannotOpenFileErr, "cannot be renamed from '" + place + "'");
    finished = true;
    tilt_lens::ListPicture(target);
}

void WholeFile::Fail(const pov_base::Exception& cause) const
{
    const std::string reason = errno != 0 ? std::string(": ") + std::strerror(errno) : std::string();
    throw POV_EXCEPTION(pov_base::kFileDataErr, "Cannot write the picture '" + target + "' (" + cause.what() + reason +
                                                    "). Make room there, then "
                                                    "continue with +C: what is in the state file need not be rendered again.");
}

void RemoveState(std::shared_ptr<OStream>& file, const pov_base::Path& name)
{
    if (!file)
        return;
    file.reset();
    std::remove(pov_base::UCS2toASCIIString(name()).c_str());
}

} // namespace pov_frontend

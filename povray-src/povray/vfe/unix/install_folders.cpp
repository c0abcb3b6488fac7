// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "vfe/unix/install_folders.h"

#include <filesystem>
#include <mutex>
#include <set>
#include <system_error>

namespace povray_install
{

namespace
{

/// The parent of the program's folder, or the configured prefix if unknown.
std::filesystem::path Prefix()
{
    std::error_code error;
    const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
    if (error)
        return TILT_LENS_INSTALL_PREFIX;
    return program.parent_path().parent_path();
}

} // namespace

Folder::Folder(const char* relative) : mPath((Prefix() / relative).string()) {}

const char* Folder::operator/(const char* tail) const
{
    static std::mutex mutex;
    static std::set<std::string> names;
    const std::lock_guard<std::mutex> lock(mutex);
    return names.insert(mPath + tail).first->c_str();
}

const Folder& DataFolder()
{
    static const Folder folder("share/povray-3.7");
    return folder;
}

const Folder& ConfigFolder()
{
    static const Folder folder("etc/povray/3.7");
    return folder;
}

} // namespace povray_install

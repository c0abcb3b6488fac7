// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file
/// The installation's folders, found from the program's place. Replaces upstream's literals POVLIBDIR and POVCONFDIR.

#ifndef POVRAY_TILT_LENS_INSTALL_FOLDERS_H
#define POVRAY_TILT_LENS_INSTALL_FOLDERS_H

#include <string>

namespace povray_install
{

class Folder
{
  public:
    explicit Folder(const char* relative);

    /// Valid for the whole run.
    const char* operator/(const char* tail) const;

  private:
    std::string mPath;
};

/// `<prefix>/share/povray-3.7`.
const Folder& DataFolder();

/// `<prefix>/etc/povray/3.7`.
const Folder& ConfigFolder();

} // namespace povray_install

// allows for a literal behind the macro
#define POVLIBDIR ::povray_install::DataFolder() / ""
#define POVCONFDIR ::povray_install::ConfigFolder() / ""

#endif  // POVRAY_TILT_LENS_INSTALL_FOLDERS_H

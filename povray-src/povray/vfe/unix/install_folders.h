// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file
/// The folders of the installation, found at run time from where the program lies.
///
/// Stock POV-Ray has them compiled in, as the string literals POVLIBDIR and POVCONFDIR. This header, which
/// the build includes ahead of vfe's files, defines the two macros so that every use upstream makes of them
/// (alone, or followed by a literal such as "/include") becomes an expression of type `const char*`. No
/// line of upstream changes, and a program that was installed elsewhere, or moved, still finds its files.

#ifndef POVRAY_TILT_LENS_INSTALL_FOLDERS_H
#define POVRAY_TILT_LENS_INSTALL_FOLDERS_H

#include <string>

namespace povray_install
{

class Folder
{
public:
    explicit Folder(const char *relative);

    /// This folder's name followed by `tail`. The characters live as long as the program.
    const char *operator/(const char *tail) const;

private:
    std::string mPath;
};

/// `<prefix>/share/povray-3.7`: include files, fonts, ini files.
const Folder &DataFolder();

/// `<prefix>/etc/povray/3.7`: `povray.ini` and `povray.conf`.
const Folder &ConfigFolder();

}

// The empty literal at the end is joined by the compiler with a literal that follows the macro.
#define POVLIBDIR  ::povray_install::DataFolder() / ""
#define POVCONFDIR ::povray_install::ConfigFolder() / ""

#endif // POVRAY_TILT_LENS_INSTALL_FOLDERS_H

// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file
/// Which files a scene may read and write, as povray.conf states it. The words of the user (scene, picture, INI files, folders for
/// include files) are not held to it: they state it.

#ifndef POVRAY_BASE_FILE_PERMISSIONS_H
#define POVRAY_BASE_FILE_PERMISSIONS_H

#include <string>

namespace tilt_lens
{

/// Whether scenes are restricted in reading and in writing. Before the first call they are not.
void RestrictScenes(bool reading, bool writing);

/// A folder whose files the scene may read. @param descend  with all folders in it @param writing  and write
void PermitFolder(const std::string &folder, bool descend, bool writing);

/// The scene, whose folder it may read.
void PermitScene(const std::string &scene);

/// The picture, whose folder the scene may read and write.
void PermitPicture(const std::string &picture);

/// A folder where no scene writes, whatever else is permitted: the program's own.
void ProtectFolder(const std::string &folder);

/// Why the scene may not open this file, and what to do; empty where it may.
std::string FileProblem(const std::string &name, bool writing);

}

#endif // POVRAY_BASE_FILE_PERMISSIONS_H

// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// configbase.h must come first
#include "base/configbase.h"

#include "base/file_list.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <mutex>
#include <set>

// must be last
#include "base/povdebug.h"

namespace tilt_lens
{

namespace
{

std::mutex sceneFilesMutex;
std::vector<std::string> sceneFiles;

void List(const std::string& entry)
{
    static const char* const list = std::getenv("TILT_LENS_FILE_LIST");
    if (list == nullptr || *list == '\0')
        return;

    static std::mutex mutex; // photons are loaded while the parser runs
    static std::set<std::string> listed;
    const std::lock_guard<std::mutex> lock(mutex);
    if (!listed.insert(entry).second)
        return;

    std::ofstream stream(list, std::ios::app | std::ios::binary);
    stream.write(entry.c_str(), static_cast<std::streamsize>(entry.size() + 1));
    stream.close();
    if (!stream)
    {
        // the first files are read before any exception handler exists
        std::fprintf(stderr, "povray: cannot write the list of files that TILT_LENS_FILE_LIST names: %s\n", list);
        std::_Exit(EXIT_FAILURE);
    }
}

} // namespace

void ListFile(const std::string& name, bool found)
{
    List((found ? '+' : '-') + name);
    if (!found)
        return;
    const std::lock_guard<std::mutex> lock(sceneFilesMutex);
    if (std::find(sceneFiles.begin(), sceneFiles.end(), name) == sceneFiles.end())
        sceneFiles.push_back(name);
}

void ListPicture(const std::string& name)
{
    List('=' + name);
}

void StartSceneFiles()
{
    const std::lock_guard<std::mutex> lock(sceneFilesMutex);
    sceneFiles.clear();
}

std::vector<std::string> SceneFiles()
{
    const std::lock_guard<std::mutex> lock(sceneFilesMutex);
    return sceneFiles;
}

} // namespace tilt_lens

// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "base/file_permissions.h"

#include <algorithm>
#include <filesystem>
#include <mutex>
#include <system_error>
#include <vector>

#include <strings.h>
#include <sys/stat.h>

namespace tilt_lens
{

namespace
{

namespace fs = std::filesystem;

struct Folder
{
    fs::path path; // without links
    bool descend, writing;
};

/// Folders whose files a scene may open. Locked, since the parser asks while the front end may begin with the next frame.
struct Permissions
{
    std::mutex mutex;
    bool readingRestricted = false, writingRestricted = false;
    std::vector<Folder> folders;
    std::vector<fs::path> ours;
};

Permissions &The()
{
    static Permissions permissions;
    return permissions;
}

/// The folder without links; empty where there is none.
fs::path FolderOf(const fs::path &name)
{
    std::error_code error;
    fs::path found = fs::canonical(name.empty() ? fs::path(".") : name, error);
    return error ? fs::path() : found;
}


/// The path of `file` relative to `folder`; empty if it lies elsewhere.
fs::path Below(const fs::path &file, const fs::path &folder)
{
    const auto ends = std::mismatch(folder.begin(), folder.end(), file.begin(), file.end());
    fs::path rest;
    if (ends.first == folder.end())
        for (auto part = ends.second; part != file.end(); ++part)
            rest /= *part;
    return rest;
}

bool IsHidden(const fs::path &below)
{
    return std::any_of(below.begin(), below.end(), [](const fs::path &part) { return part.native()[0] == '.'; });
}

/// The folder holds the file, and the file is not hidden in it.
bool Holds(const Folder &folder, const fs::path &file)
{
    const fs::path below = Below(file, folder.path);
    return !below.empty() && (folder.descend || !below.has_parent_path()) && !IsHidden(below);
}

bool IsLink(const fs::path &name)
{
    std::error_code none;
    return fs::is_symlink(fs::symlink_status(name, none));
}

/// The file that an opening of `name` reaches, without links. A file that is to be made need not exist, but its folder.
fs::path Reached(const fs::path &name, bool writing, std::error_code &error)
{
    fs::path found = fs::canonical(name, error);
    if (!writing || error != std::errc::no_such_file_or_directory || !name.has_filename())
        return found;
    if (IsLink(name))
        return found;
    error.clear();
    const fs::path folder = name.parent_path();
    found = fs::canonical(folder.empty() ? fs::path(".") : folder, error);
    return error ? found : found / name.filename();
}

/// The reason for which a file in a permitted folder is not written; NULL if it is.
const char *WhyNeverWritten(const fs::path &file)
{
    if (strcasecmp(file.extension().c_str(), ".ini") == 0)
        return "an INI file states options of the next picture";
    struct stat status;
    if (stat(file.c_str(), &status) != 0)
        return NULL;
    if (S_ISREG(status.st_mode) && (status.st_mode & (S_IXUSR | S_IXGRP | S_IXOTH)) != 0)
        return "it is a program";
    if (S_ISREG(status.st_mode) && status.st_nlink > 1)
        return "it has another name elsewhere (a hard link)";
    return NULL;
}

/// The ways that remain.
std::string Remedy(const fs::path &file, bool writing, const std::vector<Folder> &folders)
{
    std::string text;
    if (writing)
    {
        for (const Folder &folder : folders)
            if (folder.writing)
                text += std::string(text.empty() ? " A scene writes files without a leading dot in '" : "', '") + folder.path.string();
        text += text.empty() ? " A scene writes no files." : "'; +O names the folder of the picture.";
    }
    else
        text = " A scene reads files without a leading dot in its own folder, in the current one, in those of +L, and in that of the "
               "picture. To add a folder: +L\"" + file.parent_path().string() + "\".";
    return text + " Whoever trusts the scene lifts this with the option --unrestricted.";
}

std::string Problem(const std::string &name, bool writing)
{
    const Permissions &p = The();
    std::error_code error;
    const fs::path file = Reached(name, writing, error);
    std::string head = std::string("Not permitted: ") + (writing ? "writing '" : "reading '") + name + "'";
    if (error && IsLink(name))
        return head + ": it is a link to a file that does not exist. Choose another name; whoever trusts the scene lifts this with the option "
               "--unrestricted.";
    if (error)
        return "Cannot open '" + name + "' for " + (writing ? "writing: " : "reading: ") + error.message() + ".";
    if (file.string() != name)
        head += ", which is '" + file.string() + "'";
    const auto permits = [&](const Folder &folder) { return (folder.writing || !writing) && Holds(folder, file); };
    if (writing)
        for (const fs::path &folder : p.ours)
            if (!Below(file, folder).empty())
                return head + ": no scene writes into the program's own folder '" + folder.string() + "'. Choose another folder for the "
                       "picture, with +O. Whoever trusts the scene lifts this with the option --unrestricted.";
    if (std::none_of(p.folders.begin(), p.folders.end(), permits))
        return head + "." + Remedy(file, writing, p.folders);
    const char *const why = writing ? WhyNeverWritten(file) : NULL;
    return why ? head + ": " + why + ". Choose another name; whoever trusts the scene lifts this with the option --unrestricted." : "";
}

} // namespace

void RestrictScenes(bool reading, bool writing)
{
    const std::lock_guard<std::mutex> lock(The().mutex);
    The().readingRestricted = reading;
    The().writingRestricted = writing;
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    if (!error)
        The().ours.push_back(FolderOf(program.parent_path()));
}

void PermitFolder(const std::string &name, bool descend, bool writing)
{
    const fs::path found = FolderOf(name);
    const std::lock_guard<std::mutex> lock(The().mutex);
    std::vector<Folder> &folders = The().folders;
    const auto same = [&](const Folder &folder)
    { return folder.path == found && folder.descend == descend && folder.writing == writing; };
    if (!found.empty() && std::none_of(folders.begin(), folders.end(), same))
        folders.push_back({found, descend, writing});
}

void ProtectFolder(const std::string &folder)
{
    const std::lock_guard<std::mutex> lock(The().mutex);
    const fs::path found = folder.empty() ? fs::path() : FolderOf(folder);
    if (!found.empty())
        The().ours.push_back(found);
}

void PermitScene(const std::string &scene)
{
    PermitFolder(fs::path(scene).parent_path(), true, false);
    std::error_code error;
    const fs::path behindLink = fs::canonical(scene, error);
    if (!error)
        PermitFolder(behindLink.parent_path(), true, false);
}

void PermitPicture(const std::string &picture)
{
    PermitFolder(fs::path(picture).parent_path(), false, true);
}

std::string FileProblem(const std::string &name, bool writing)
{
    const std::lock_guard<std::mutex> lock(The().mutex);
    return (writing ? The().writingRestricted : The().readingRestricted) ? Problem(name, writing) : "";
}

}

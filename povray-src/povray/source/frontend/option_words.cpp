// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// configbase.h must always be the first POV file included, and configfrontend.h the next
#include "base/configbase.h"
#include "frontend/configfrontend.h"

#include "frontend/option_words.h"

#include <cctype>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>

#include "base/povms.h"
#include "base/povmsgid.h"
#include "base/processoptions.h"

// this must be the last file included
#include "base/povdebug.h"

namespace pov_frontend
{

using pov_base::ProcessOptions;

extern ProcessOptions::INI_Parser_Table RenderOptions_INI_Table[];
extern ProcessOptions::Cmd_Parser_Table RenderOptions_Cmd_Table[];

namespace
{

const char* const kMore = " povray(1) lists all options.";

/// Allowed values of an option.
std::string Taken(POVMSType key, POVMSType type)
{
    switch (key)
    {
        case kPOVAttrib_FileGamma:
        case kPOVAttrib_DisplayGamma:
        case kPOVAttrib_AntialiasGamma: return "a number above 0, or sRGB";
        case kPOVAttrib_DitherMethod: return "one of B2, B3, B4, D1, D2 and FS";
        case kPOVAttrib_OutputFileType: return "one of the letters B (BMP), C (compressed Targa), E (OpenEXR), H (Radiance HDR), J (JPEG), "
                                               "N (PNG), P (PPM) and T (Targa), and behind it bits per colour";
        case kPOVAttrib_Declare: return "NAME=NUMBER, or 'NAME=\"TEXT\"' with both marks";
        case kPOVAttrib_IncludeIni: return "the name of an INI file that can be read";
    }
    switch (type)
    {
        case kPOVMSType_Int: return "a whole number";
        case kPOVMSType_Float: return "a number";
        case kPOVMSType_Bool: return "on or off";
        case kPOVMSType_Null: return "";
    }
    return "a value";
}

bool BeginsWith(const std::string& word, const std::string& beginning)
{
    return word.size() >= beginning.size() && strncasecmp(word.c_str(), beginning.c_str(), beginning.size()) == 0;
}

/// Length of the common prefix, ignoring case.
std::size_t CommonLetters(const std::string& a, const std::string& b)
{
    std::size_t count = 0;
    while (count < a.size() && count < b.size() && std::tolower((unsigned char)a[count]) == std::tolower((unsigned char)b[count]))
        count++;
    return count;
}

/// Error in NAME=VALUE.
std::string SettingProblem(const std::string& word, std::size_t equals)
{
    const std::string name = word.substr(0, word.find_last_not_of(" \t", equals - 1) + 1);
    std::string nearest;
    for (const ProcessOptions::INI_Parser_Table* option = RenderOptions_INI_Table; option->keyword != NULL; option++)
    {
        if (strcasecmp(option->keyword, name.c_str()) == 0)
            return "'" + word + "': " + option->keyword + " takes " + Taken(option->key, option->type) + ".";
        if (CommonLetters(name, option->keyword) > CommonLetters(name, nearest))
            nearest = option->keyword;
    }
    const bool alike = CommonLetters(name, nearest) >= 3;
    return "'" + word + "': there is no option '" + name + "'" + (alike ? ", but " + nearest : std::string()) + "." + kMore;
}

/// Error in +LETTERS with an optional value.
std::string SwitchProblem(const std::string& word)
{
    const std::string letters = word.substr(1);
    std::string forms;
    for (const ProcessOptions::Cmd_Parser_Table* option = RenderOptions_Cmd_Table; option->command != NULL; option++)
    {
        const std::string command = option->command, taken = Taken(option->key, option->type);
        const bool alone = option->type == kPOVMSType_Null;
        // upstream's parser takes the first that fits
        if (!alone && letters.size() > command.size() && BeginsWith(letters, command))
            return "'" + word + "': +" + command + " takes " + taken + ".";
        if (!alone && letters.size() == command.size() && BeginsWith(letters, command))
            return "'" + word + "': +" + command + " takes " + taken + ", directly behind it.";
        if (!letters.empty() && BeginsWith(command, letters.substr(0, 1)))
            forms += std::string(forms.empty() ? "" : ", ") + "+" + command + (alone ? " alone" : " with " + taken);
    }
    if (forms.empty())
        return "'" + word + "': there is no such option." + kMore;
    return "'" + word + "': there is no such option. With its first letter there are " + forms + ".";
}

} // namespace

std::string WordProblem(const std::string& word)
{
    const std::size_t equals = word.find('=');
    if (equals != std::string::npos && equals > 0 && (std::isalnum((unsigned char)word[0]) || word[0] == '_'))
        return SettingProblem(word, equals);
    if (word.size() > 1 && (word[0] == '+' || word[0] == '-'))
        return SwitchProblem(word);
    errno = 0;
    const bool there = std::ifstream(word).good();
    const std::string reason = there ? "is no INI file" : "cannot be read as an INI file (" + std::string(std::strerror(errno)) + ")";
    return "'" + word + "' " + reason + ". A word without + or = is an INI file, a scene, whose name ends with .pov, or a folder of include "
           "files, whose name ends with /; +I takes a scene of any name.";
}

std::string LineProblem(const std::string& file, int line)
{
    std::ifstream stream(file);
    std::string text;
    for (int i = 0; i < line && std::getline(stream, text); i++)
        ;
    const std::size_t begin = text.find_first_not_of(" \t\r"), end = text.find_last_not_of(" \t\r");
    return "File '" + file + "' line " + std::to_string(line) + ": " +
           (begin == std::string::npos ? std::string("it cannot be read as an INI file.") : WordProblem(text.substr(begin, end - begin + 1)));
}

std::string UnwritableSettings(const std::string& file)
{
    const std::string reason = std::strerror(errno);
    return "Cannot write the INI file '" + file + "' (" + reason + "). Create_Ini (+GI) names a file in a folder that can be written to.";
}

} // namespace pov_frontend

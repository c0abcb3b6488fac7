// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// configbase.h must always be the first POV file included within base *.cpp files
#include "base/configbase.h"

#include "base/option_values.h"

#include <cctype>
#include <cmath>
#include <cstdlib>
#include <string>

#include <strings.h>

#include "base/povmsgid.h"

// this must be the last file included
#include "base/povdebug.h"

namespace tilt_lens
{

namespace
{

bool IsNumber(const std::string &text)
{
    char *end = NULL;
    const double value = std::strtod(text.c_str(), &end);
    return end != text.c_str() && *end == 0 && std::isfinite(value);
}

/// A number that reads the same by its digits alone, as POV-Ray reads it.
bool IsWhole(const std::string &text)
{
    return IsNumber(text) && std::strtod(text.c_str(), NULL) == double(std::strtol(text.c_str(), NULL, 10));
}

bool IsSwitch(const std::string &text)
{
    for (const char *const word : {"on", "true", "yes", "1", "off", "false", "no", "0"})
        if (strcasecmp(text.c_str(), word) == 0)
            return true;
    return false;
}

/// NAME=NUMBER or NAME="TEXT".
bool IsDeclaration(const std::string &text)
{
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0)
        return false;
    for (std::size_t i = 0; i < equals; i++)
        if (!std::isalnum((unsigned char)text[i]) && text[i] != '_')
            return false;
    const std::string value = text.substr(equals + 1);
    const bool quoted = value.size() > 2 && value.find('"') == 0 && value.find('"', 1) == value.size() - 1;
    return !std::isdigit((unsigned char)text[0]) && (quoted || IsNumber(value));
}

} // namespace

bool IsValueOf(POVMSType key, POVMSType type, const char *text)
{
    std::string value(text);
    value.erase(value.find_last_not_of(" \t\r\n") + 1);
    if (key == kPOVAttrib_Declare)
        return IsDeclaration(value);
    switch (type)
    {
        case kPOVMSType_Int: return IsWhole(value);
        case kPOVMSType_Float: return IsNumber(value);
        case kPOVMSType_Bool: return IsSwitch(value);
    }
    return true;
}

}

// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// configbase.h must always be the first POV file included within base *.cpp files
#include "base/configbase.h"

#include "base/file_name.h"

#include <algorithm>
#include <cstring>

#include "base/pov_err.h"

// this must be the last file included
#include "base/povdebug.h"

namespace tilt_lens
{

namespace
{

using Units = std::basic_string<POVMSUCS2>;

/// Lowest code point for each length in bytes; a longer form of a lower one is invalid UTF-8.
const unsigned int kLowest[] = { 0, 0, 0x80, 0x800, 0x10000 };

/// Decodes the code point at `at`; sets `length` in bytes, 0 for invalid UTF-8.
unsigned int CodePoint(const unsigned char *at, std::size_t &length)
{
    length = *at < 0x80 ? 1 : (*at & 0xE0) == 0xC0 ? 2 : (*at & 0xF0) == 0xE0 ? 3 : (*at & 0xF8) == 0xF0 ? 4 : 0;
    if (length < 2)
        return *at;
    unsigned int code = *at & (0x7F >> length);
    for (std::size_t i = 1; i < length; i++)
    {
        if ((at[i] & 0xC0) != 0x80) // also stops at the terminating zero
        {
            length = 0;
            return *at;
        }
        code = (code << 6) | (at[i] & 0x3F);
    }
    if (code < kLowest[length] || code > 0x10FFFF || (code & 0xFFFFF800) == 0xD800)
        length = 0;
    return code;
}

void Append(std::string &bytes, unsigned int code)
{
    const int further = code < 0x80 ? 0 : code < 0x800 ? 1 : code < 0x10000 ? 2 : 3;
    bytes += char(further == 0 ? code : (0xFFu << (7 - further) & 0xFFu) | (code >> (6 * further)));
    for (int i = further - 1; i >= 0; i--)
        bytes += char(0x80 | ((code >> (6 * i)) & 0x3F));
}

}

Units NameToUnits(const char *bytes)
{
    Units units;
    const unsigned char *at = reinterpret_cast<const unsigned char *>(bytes);
    while (at != nullptr && *at != 0)
    {
        std::size_t length;
        const unsigned int code = CodePoint(at, length);
        if (length == 0)
            units += Units::value_type(0xDC00 + *at);
        else if (code < 0x10000)
            units += Units::value_type(code);
        else
        {
            units += Units::value_type(0xD800 + ((code - 0x10000) >> 10));
            units += Units::value_type(0xDC00 + ((code - 0x10000) & 0x3FF));
        }
        at += std::max<std::size_t>(length, 1);
    }
    return units;
}

std::string NameToBytes(const POVMSUCS2 *units, std::size_t count)
{
    std::string bytes;
    for (std::size_t i = 0; i < count; i++)
    {
        const unsigned int unit = units[i];
        const bool pair = (unit & 0xFC00) == 0xD800 && i + 1 < count && (units[i + 1] & 0xFC00) == 0xDC00;
        if (pair)
            Append(bytes, 0x10000 + ((unit & 0x3FF) << 10) + (units[++i] & 0x3FF));
        else if (unit >= 0xDC80 && unit <= 0xDCFF)
            bytes += char(unit - 0xDC00);
        else
            Append(bytes, unit);
    }
    return bytes;
}

Units NameOf(POVMSAttributePtr attribute)
{
    int size = 0;
    if (POVMSAttr_Size(attribute, &size) != pov_base::kNoErr || size < int(sizeof(POVMSUCS2)))
        return Units();
    Units units(std::size_t(size) / sizeof(POVMSUCS2), 0);
    if (POVMSAttr_Get(attribute, kPOVMSType_UCS2String, &units[0], &size) != pov_base::kNoErr)
        return Units();
    units.pop_back();  // terminating zero
    return units;
}

Units NameIn(POVMSObjectPtr message, POVMSType key)
{
    POVMSAttribute attribute;
    if (POVMSObject_Get(message, &attribute, key) != pov_base::kNoErr)
        return Units();
    const Units name = NameOf(&attribute);
    (void)POVMSAttr_Delete(&attribute);
    return name;
}

std::size_t CopyNameToUnits(const char *bytes, POVMSUCS2 *units)
{
    const Units name = NameToUnits(bytes);
    std::copy_n(name.c_str(), name.size() + 1, units);
    return name.size();
}

std::size_t CopyNameToBytes(const POVMSUCS2 *units, char *bytes)
{
    std::size_t count = 0;
    while (units[count] != 0)
        count++;
    const std::string name = NameToBytes(units, count);
    std::memcpy(bytes, name.c_str(), name.size() + 1);
    return name.size();
}

}

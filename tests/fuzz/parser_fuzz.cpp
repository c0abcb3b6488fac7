// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file parser_fuzz.cpp
/// libFuzzer's target for the block's parser: the text between the braces.

#include <cctype>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "parse_driver.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    // refuses upstream's infinite loops, files, other parsers
    if (size > 2000)
        return -1;
    for (std::size_t i = 0; i < size; i++)
        if (data[i] == '#' || data[i] == '"' || !(std::isprint(data[i]) || data[i] == '\n' || data[i] == '\t'))
            return -1;
    const std::string block(reinterpret_cast<const char*>(data), size);
    const std::string complaint = Complaint(Parse(SceneAround(block)));
    if (!complaint.empty())
    {
        std::fprintf(stderr, "%s\n", complaint.c_str());
        std::abort();
    }
    return 0;
}

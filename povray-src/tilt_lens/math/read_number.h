// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file read_number.h
/// The value of a decimal number, for the parser of scenes.

#ifndef TILT_LENS_READ_NUMBER_H
#define TILT_LENS_READ_NUMBER_H

#include <charconv>
#include <cstdio>
#include <system_error>

namespace tilt_lens
{

/// Sets value to the double nearest to the decimal number in [begin, end), which a zero byte follows. It is the value that
/// sscanf gives, in a tenth of its time.
/// @return  false if there is no number; then value keeps what it held
inline bool ReadNumber(const char* begin, const char* end, double* value)
{
    const std::from_chars_result read = std::from_chars(begin, end, *value);
    if (read.ec == std::errc() && read.ptr == end)
        return true;
    return std::sscanf(begin, "%lf", value) != 0;  // an incomplete exponent, or a number beyond those of a double
}

} // namespace tilt_lens

#endif

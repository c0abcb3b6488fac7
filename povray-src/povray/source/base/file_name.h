// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file
/// Converts file names between the bytes of the operating system and the strings of 16-bit units of options, paths and messages.
///
/// Bytes are read as UTF-8 and become UTF-16. A byte that is not part of valid UTF-8 becomes the unit 0xDC00 + byte, which valid UTF-8
/// never yields, so that every name survives a round trip (as in Python's PEP 383).

#ifndef POVRAY_BASE_FILE_NAME_H
#define POVRAY_BASE_FILE_NAME_H

#include <cstddef>
#include <string>

#include "base/povms.h"

namespace tilt_lens
{

std::basic_string<POVMSUCS2> NameToUnits(const char *bytes);

std::string NameToBytes(const POVMSUCS2 *units, std::size_t count);

/// The name in an attribute of a message, of any length.
std::basic_string<POVMSUCS2> NameOf(POVMSAttributePtr attribute);

/// The name in a message's attribute; empty if there is none.
std::basic_string<POVMSUCS2> NameIn(POVMSObjectPtr message, POVMSType key);

/// NameToUnits() into an array with room for as many units as there are bytes, and a zero. Returns the length.
std::size_t CopyNameToUnits(const char *bytes, POVMSUCS2 *units);

/// NameToBytes() into an array with room for three bytes per unit, and a zero. Returns the length.
std::size_t CopyNameToBytes(const POVMSUCS2 *units, char *bytes);

}

#endif // POVRAY_BASE_FILE_NAME_H

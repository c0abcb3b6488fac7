// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file
/// Names of files between the two forms that the program keeps them in: the bytes that the operating system takes, and
/// strings of 16-bit units, in which options, paths and messages carry them.
///
/// Bytes are read as UTF-8 and become UTF-16. A byte that is no part of valid UTF-8 becomes the unit 0xDC00 + byte, which
/// valid UTF-8 never gives, and comes back as that byte: so every name survives both ways (Python's PEP 383 does the same).

#ifndef POVRAY_BASE_FILE_NAME_H
#define POVRAY_BASE_FILE_NAME_H

#include <cstddef>
#include <string>

#include "base/povms.h"

namespace tilt_lens
{

/// The units of a name given as bytes.
std::basic_string<POVMSUCS2> NameToUnits(const char *bytes);

/// The bytes of a name given as units.
std::string NameToBytes(const POVMSUCS2 *units, std::size_t count);

/// The name in an attribute of a message, of any length.
std::basic_string<POVMSUCS2> NameOf(POVMSAttributePtr attribute);

/// The name in a message's attribute of this key; empty where there is none.
std::basic_string<POVMSUCS2> NameIn(POVMSObjectPtr message, POVMSType key);

/// As NameToUnits(), into the caller's array, which has room for as many units as there are bytes, and a zero. Returns the length.
std::size_t CopyNameToUnits(const char *bytes, POVMSUCS2 *units);

/// As NameToBytes(), into the caller's array, which has room for three bytes a unit, and a zero. Returns the length.
std::size_t CopyNameToBytes(const POVMSUCS2 *units, char *bytes);

}

#endif // POVRAY_BASE_FILE_NAME_H

// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file option_words.h
/// Explains words of the command line and lines of INI files that upstream's parser refuses.

#ifndef POVRAY_FRONTEND_OPTION_WORDS_H
#define POVRAY_FRONTEND_OPTION_WORDS_H

#include <string>

namespace pov_frontend
{

std::string WordProblem(const std::string& word);

/// @param line  of the file, from 1
std::string LineProblem(const std::string& file, int line);

/// An INI file that was to be written, and why it was not: errno.
std::string UnwritableSettings(const std::string& file);

} // namespace pov_frontend

#endif

// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file option_words.h
/// What is wrong with a word of the command line, or with a line of an INI file, that upstream's parser refuses.

#ifndef POVRAY_FRONTEND_OPTION_WORDS_H
#define POVRAY_FRONTEND_OPTION_WORDS_H

#include <string>

namespace pov_frontend
{

/// The word, and what is allowed in its place.
std::string WordProblem(const std::string& word);

/// The same for a line of an INI file.
/// @param line  of the file, from 1
std::string LineProblem(const std::string& file, int line);

/// An INI file that was to be written, and why it was not: errno.
std::string UnwritableSettings(const std::string& file);

} // namespace pov_frontend

#endif

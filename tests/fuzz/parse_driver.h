// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file parse_driver.h
/// POV-Ray's parser from text to outcome, without files or messages.

#ifndef TILT_LENS_TESTS_PARSE_DRIVER_H
#define TILT_LENS_TESTS_PARSE_DRIVER_H

#include <string>
#include <vector>

struct ParseOutcome
{
    std::vector<std::string> errors;
    std::vector<std::string> warnings;
    bool lens = false;
    std::string broken;                 ///< a ray that is not finite
};

ParseOutcome Parse(const std::string& scene);

std::string SceneAround(const std::string& block);

/// Forbidden behaviour of the parser, or empty.
std::string Complaint(const ParseOutcome& outcome);

#endif

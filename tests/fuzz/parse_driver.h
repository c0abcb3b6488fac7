// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file parse_driver.h
/// POV-Ray's parser as a function from text to outcome, within this process: no program, no file, no messages to the
/// user.

#ifndef TILT_LENS_TESTS_PARSE_DRIVER_H
#define TILT_LENS_TESTS_PARSE_DRIVER_H

#include <string>
#include <vector>

struct ParseOutcome
{
    std::vector<std::string> errors;    ///< fatal ones: parsing has ended there
    std::vector<std::string> warnings;
    bool lens = false;                  ///< the scene has a camera with tilt_lens, and it has been solved
    std::string broken;                 ///< fault of an accepted lens: a ray that is not finite
};

ParseOutcome Parse(const std::string& scene);

/// A scene with a camera around the block's text.
std::string SceneAround(const std::string& block);

/// Describes forbidden behaviour of the parser; empty if there is none.
std::string Complaint(const ParseOutcome& outcome);

#endif

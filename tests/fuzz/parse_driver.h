// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file parse_driver.h
/// POV-Ray's own parser as a function from text to outcome, in this process: no program is started, no
/// file is read or written, and what the parser would tell the user is caught.

#ifndef TILT_LENS_TESTS_PARSE_DRIVER_H
#define TILT_LENS_TESTS_PARSE_DRIVER_H

#include <string>
#include <vector>

struct ParseOutcome
{
    std::vector<std::string> errors;    ///< fatal ones: parsing has ended there
    std::vector<std::string> warnings;
    bool lens = false;                  ///< the scene has a camera with tilt_lens, and it has been solved
    std::string broken;                 ///< what is wrong with an accepted lens: a ray without numbers
};

/// Parses a scene.
ParseOutcome Parse(const std::string& scene);

/// The scene around a block: a camera that the block's text stands in, and nothing else.
std::string SceneAround(const std::string& block);

/// What a parser must never do with a text, in words; empty if all is well.
std::string Complaint(const ParseOutcome& outcome);

#endif

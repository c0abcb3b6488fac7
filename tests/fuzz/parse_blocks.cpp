// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file parse_blocks.cpp
/// Parses texts of blocks from standard input, each ended by a zero byte, as scenes of their own. Prints one line per
/// block at once, so that a crash can be attributed: `lens`, `none` (no tilt_lens in the end), `error WORDS` or `wrong
/// WORDS`.

#include <iostream>
#include <string>

#include "parse_driver.h"

int main()
{
    std::string block;
    while (std::getline(std::cin, block, '\0'))
    {
        const ParseOutcome outcome = Parse(SceneAround(block));
        const std::string complaint = Complaint(outcome);
        if (!complaint.empty())
            std::cout << "wrong " << complaint << std::endl;
        else if (!outcome.errors.empty())
            std::cout << "error " << outcome.errors[0] << std::endl;
        else
            std::cout << (outcome.lens ? "lens" : "none") << std::endl;
    }
    return 0;
}

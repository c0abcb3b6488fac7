// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file parse_blocks.cpp
/// Parses blocks from standard input, each ended by a zero byte. Prints `lens`, `none`, `error WORDS` or `wrong WORDS` for each.
/// `--items` prints the parser's table as JSON; an infinite limit is null.

#include <cstring>
#include <iostream>
#include <string>

#include <nlohmann/json.hpp>

#include "parse_driver.h"
#include "backend/parser/tilt_lens_items.h"

namespace
{

nlohmann::json Items()
{
    nlohmann::json items;
    for (const pov::TiltLensItem& item : pov::kTiltLensItems)
    {
        nlohmann::json numbers = nlohmann::json::array();
        for (const pov::ItemNumber& number : item.numbers)
            numbers.push_back({{"name", number.name == NULL ? item.word : number.name},
                               {"least", number.range.least},
                               {"most", number.range.most},
                               {"whole", number.range.whole}});
        items.push_back({{"word", item.word}, {"values", item.values}, {"example", item.Example()}, {"numbers", numbers}});
    }
    return items;
}

} // namespace

int main(int count, char** options)
{
    if (count > 1 && std::strcmp(options[1], "--items") == 0)
    {
        std::cout << Items().dump() << std::endl;
        return 0;
    }
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

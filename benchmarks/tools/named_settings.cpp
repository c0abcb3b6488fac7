// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "named_settings.h"

#include <map>
#include <sstream>
#include <stdexcept>
#include <variant>

namespace tilt_lens
{

namespace
{

using Field = std::variant<double Settings::*, float Settings::*, std::uint32_t Settings::*, bool Settings::*>;

#define FIELD(name) {#name, Field(&Settings::name)}
const std::map<std::string, Field> fields = {
    FIELD(halfRounds),           FIELD(varianceRatioPrior), FIELD(lensPointBlur),  FIELD(emitterShare),    FIELD(emittersOfPixel),
    FIELD(hiddenEmitterSamples), FIELD(greatestRisk),       FIELD(chanceRisk),     FIELD(mostSentSamples), FIELD(spreadWeight),
    FIELD(missedWeight),         FIELD(forecasts),          FIELD(deviationShare),
};
#undef FIELD

} // namespace

Settings SettingsNamed(const std::string& text)
{
    Settings settings;
    std::istringstream list(text);
    for (std::string item; std::getline(list, item, ',');)
    {
        const std::size_t equals = item.find('=');
        const auto field = fields.find(item.substr(0, equals));
        if (equals == std::string::npos || field == fields.end())
            throw std::invalid_argument("'" + item + "' is not NAME=VALUE with a name of settings.h");
        const double value = std::stod(item.substr(equals + 1));
        std::visit([&](auto member) { settings.*member = value; }, field->second);
    }
    return settings;
}

} // namespace tilt_lens

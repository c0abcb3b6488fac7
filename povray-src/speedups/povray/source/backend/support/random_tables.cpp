// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "backend/support/random_tables.h"

#include <map>
#include <mutex>
#include <tuple>

namespace pov
{

namespace
{

struct Tables
{
    std::mutex busy;
    std::map<std::tuple<double, double, std::size_t>, const std::vector<double>> kept;
};

/// Never destroyed: statics use it.
Tables& Kept()
{
    static Tables& tables = *new Tables;
    return tables;
}

} // namespace

const std::vector<double>* KeptRandomDoubles(double least, double most, std::size_t count)
{
    Tables& tables = Kept();
    const std::lock_guard<std::mutex> lock(tables.busy);
    const auto found = tables.kept.find({least, most, count});
    return found != tables.kept.end() ? &found->second : nullptr;
}

void KeepRandomDoubles(double least, double most, const std::vector<double>& numbers)
{
    Tables& tables = Kept();
    const std::lock_guard<std::mutex> lock(tables.busy);
    tables.kept.emplace(std::make_tuple(least, most, numbers.size()), numbers);
}

} // namespace pov

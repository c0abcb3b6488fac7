// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "backend/parser/macro_files.h"

#include <algorithm>
#include <string_view>

namespace pov
{

pov_base::ITextStream* MacroFiles::Take(const UCS2* name)
{
    const std::basic_string_view<UCS2> wanted(name);
    const auto found = std::find_if(files.rbegin(), files.rend(), [&](const auto& file) { return file->name() == wanted; });
    if (found == files.rend())
        return nullptr;
    pov_base::ITextStream* const file = found->release();
    files.erase(std::next(found).base());
    return file;
}

void MacroFiles::Keep(pov_base::ITextStream* file)
{
    files.emplace_back(file);
    if (files.size() > most)
        files.erase(files.begin());
}

} // namespace pov

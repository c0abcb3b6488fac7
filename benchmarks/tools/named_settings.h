// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file named_settings.h
/// The sampler's numbers by name (the benchmark's part `ablation`).

#ifndef TILT_LENS_NAMED_SETTINGS_H
#define TILT_LENS_NAMED_SETTINGS_H

#include <string>

#include "tilt_lens/settings.h"

namespace tilt_lens
{

/// @param text NAME=VALUE, separated by commas; may be empty; other settings as in settings.h
/// @throws std::invalid_argument an unknown name, or no number
Settings SettingsNamed(const std::string& text);

} // namespace tilt_lens

#endif

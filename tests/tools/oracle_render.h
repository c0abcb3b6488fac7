// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file oracle_render.h
/// Accumulation buffer (Haeberli and Akeley): a lens point of a tilted thin lens is a linear camera, exact in stock POV-Ray.

#ifndef WITNESS_ORACLE_RENDER_H
#define WITNESS_ORACLE_RENDER_H

#include <cstdint>
#include <filesystem>
#include <string>

#include "lens_points.h"
#include "oracle_case.h"
#include "picture.h"

namespace witness
{

struct RenderSettings
{
    std::string povray = "/usr/bin/povray";
    std::filesystem::path scenes;            ///< case's scene files
    std::filesystem::path work;
    int batches = 8;                         ///< independent, for the standard error
    int samples = 512;                       ///< pinholes in a batch; a power of two
    int processes = 16;                      ///< simultaneous: each idles 0.2 s per frame
    std::uint32_t seed = 1;
};

std::string AnimationScene(const OracleCase& description, const CameraSolved& camera, const std::vector<LensPoint>& points, int first);

/// @throws std::runtime_error
Reference RenderOracle(const OracleCase& description, const RenderSettings& settings);

} // namespace witness

#endif

// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file tilt_lens_report.h
/// Report of a `tilt_lens` picture.

#ifndef POVRAY_BACKEND_TILT_LENS_REPORT_H
#define POVRAY_BACKEND_TILT_LENS_REPORT_H

#include <string>

namespace pov
{

class Camera;
class TiltLensAids;
class TiltLensView;

struct TiltLensCost
{
    double seconds, cpuSeconds;  ///< longest thread; sum of all threads
    double threads;
    double rays;         ///< without shadow rays
    double shadowTests;  ///< pairs of object and shadow ray
};

/// @param camera  with a solved lens
std::string DescribeTiltLens(const Camera& camera, double width, const TiltLensAids* aids);

std::string SummarizeTiltLens(const TiltLensView& view, const TiltLensCost& cost);

} // namespace pov

#endif

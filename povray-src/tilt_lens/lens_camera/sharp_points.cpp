// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/lens_camera/sharp_points.h"

#include <algorithm>
#include <cmath>

#include "tilt_lens/glass/glass_lens.h"

namespace tilt_lens
{

namespace
{

const double kNarrowStop = 1000.0;

} // namespace

Statement WithWidestStop(const CameraFrame& camera, const Statement& given)
{
    if (given.family != FocusFamily::SharpPoints || !given.sharpWithin)
        return given;
    Statement stopped = given;
    stopped.sharpWithin.reset();
    stopped.aperture = 0.0;
    stopped.fStop = kNarrowStop;
    const SolvedLens lens = Solve(camera, stopped);
    const double holding = kNarrowStop * GreatestBlur(SharpPointBlurs(camera.location, stopped, lens)) / *given.sharpWithin;
    const double open = lens.glass ? lens.glass->Cardinal().fNumber : kWidestStop;
    stopped.fStop = std::max({holding, open, given.character.rimStop.value_or(0.0), kWidestStop});
    return stopped;
}

std::vector<double> SharpPointBlurs(const Vec3& location, const Statement& given, const Lens& lens)
{
    std::vector<double> blurs;
    for (const Vec3& point : given.sharpPoints)
    {
        const Vec3 way = point - location;
        const double T = Dot(way, lens.axis) / Dot(lens.direction, lens.axis);
        blurs.push_back(BlurDiameter(lens, way / T, T, given.filmWidth));
    }
    return blurs;
}

double GreatestBlur(const std::vector<double>& blurs)
{
    double greatest = 0.0;
    for (const double blur : blurs)
        greatest = std::max(greatest, std::fabs(blur));
    return greatest;
}

std::optional<double> BlurWithoutTilt(const Vec3& location, const Statement& given, const Lens& lens)
{
    double least = HUGE_VAL, greatest = 0.0;
    for (const Vec3& point : given.sharpPoints)
    {
        const double vergence = 1.0 / Dot(point - location, lens.axis);
        least = std::min(least, vergence);
        greatest = std::max(greatest, vergence);
    }
    Statement parallel = given;
    parallel.family = FocusFamily::FocalPlane;
    parallel.planeNormal = lens.axis;
    parallel.planeDistance = Dot(location, lens.axis) + 2.0 / (least + greatest);
    parallel.shiftRight = parallel.shiftUp = 0.0;  // in the lens's direction
    parallel.sharpWithin.reset();
    parallel.aperture = 0.0;
    parallel.fStop = lens.focalLength / lens.diameter;
    try
    {
        return GreatestBlur(SharpPointBlurs(location, parallel, Solve({location, lens.direction, lens.right, lens.up}, parallel)));
    }
    catch (const OpticsError&)
    {
        return {};
    }
}

} // namespace tilt_lens

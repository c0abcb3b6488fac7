// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/glass/field_aberrations.h"

#include <cmath>

#include "tilt_lens/glass/pupil_view.h"

namespace tilt_lens
{

namespace
{

/// Difference of direction cosines: far above rounding, with a square negligible beside 1.
constexpr double kStep = 1e-5;

struct Aimed
{
    const GlassLens& lens;
    Vec3 film;

    std::optional<GlassRay> Towards(double l, double m, StopPoint& stop) const
    {
        std::optional<GlassRay> ray = RayTowards(film, {l, m});
        return ray && lens.Trace(*ray, stop) == Passage::Passed ? ray : std::optional<GlassRay>();
    }

    std::optional<double> MiddleOfStop() const
    {
        double l = ParaxialAim(lens.Cardinal(), film).l, before = l + 1e-3;
        StopPoint stop, earlier;
        if (!Towards(before, 0.0, earlier))
            return {};
        for (int i = 0; i < 20; i++)
        {
            if (!Towards(l, 0.0, stop))
                return {};
            if (std::fabs(stop.a) < 1e-9 || stop.a == earlier.a)
                return l;
            const double next = l - stop.a * (l - before) / (stop.a - earlier.a);
            before = l;
            earlier = stop;
            l = next;
        }
        return {};
    }
};

double Slope(double part, const GlassRay& ray)
{
    return part / ray.direction.z;
}

} // namespace

std::optional<FieldAberrations> FieldAberrationsOf(const GlassLens& lens, double filmDistance, double height)
{
    const CardinalPoints& points = lens.Cardinal();
    const Aimed aimed{lens, {height, 0.0, -points.separation - filmDistance}};
    const std::optional<double> middle = aimed.MiddleOfStop();
    if (!middle)
        return {};
    StopPoint stop;
    const auto chief = aimed.Towards(*middle, 0.0, stop), beside = aimed.Towards(*middle, kStep, stop);
    const auto above = aimed.Towards(*middle + kStep, 0.0, stop), below = aimed.Towards(*middle - kStep, 0.0, stop);
    if (!chief || !beside || !above || !below)
        return {};
    // 1/distance from H at which neighbours meet
    const auto atH = [](double place, double slope, double z) { return place - slope * z; };
    const double besideSlope = Slope(beside->direction.y, *beside);
    const double sagittal = -besideSlope / atH(beside->origin.y, besideSlope, beside->origin.z);
    const double aboveSlope = Slope(above->direction.x, *above), belowSlope = Slope(below->direction.x, *below);
    const double apart = atH(above->origin.x, aboveSlope, above->origin.z) - atH(below->origin.x, belowSlope, below->origin.z);
    const double tangential = -(aboveSlope - belowSlope) / apart;
    const double focused = 1.0 / points.focalLength - 1.0 / filmDistance, square = filmDistance * filmDistance;
    const double chiefSlope = Slope(chief->direction.x, *chief);
    const double shown = focused * atH(chief->origin.x, chiefSlope, chief->origin.z) + chiefSlope;
    return FieldAberrations{shown / (-height / filmDistance) - 1.0, (sagittal - focused) * square, (tangential - focused) * square};
}

} // namespace tilt_lens

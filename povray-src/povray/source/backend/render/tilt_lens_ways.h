// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file tilt_lens_ways.h
/// From a sample's number to its ray: film point and lens point, and the way from one through the other. Each step waits
/// for divisions and roots of the one before; those of a few samples together overlap.

#ifndef POVRAY_BACKEND_TILT_LENS_WAYS_H
#define POVRAY_BACKEND_TILT_LENS_WAYS_H

#include <algorithm>
#include <array>

#include "backend/scene/tilt_lens_view.h"
#include "tilt_lens/camera/ray.h"

namespace pov
{

/// How a sample's ray begins.
struct TiltLensWay
{
    tilt_lens::Start start;
    tilt_lens::LensRay ray;
    double length;              ///< of the ray's direction
    tilt_lens::Vec3 direction;  ///< normalised

    /// From its start.
    void FindRay(const tilt_lens::Lens& lens)
    {
        ray = MakeRay(lens, start.x, start.y, start.point.a, start.point.b);
        length = Length(ray.direction);
        direction = {ray.direction.x / length, ray.direction.y / length, ray.direction.z / length};
    }
};

/// The ways of samples that are asked for pixel by pixel, each pixel's in order.
class TiltLensWays
{
  public:
    explicit TiltLensWays(const TiltLensView& view) : view(view), ahead(std::min(kMost, view.limits.First())) {}

    const TiltLensWay& Of(const tilt_lens::SampleId& id)
    {
        if (count == 0 || id.x != first.x || id.y != first.y)
        {
            sampler = tilt_lens::PixelSampler(id.x, id.y, 0);
            targets = view.emitters.Of(id.x, id.y);
            count = 0;
        }
        if (id.index - first.index >= count)
            Make(id);
        return ways[id.index - first.index];
    }

    /// Of the pixel that was asked for last.
    const tilt_lens::PixelSampler& Sampler() const { return sampler; }

  private:
    static constexpr std::uint32_t kMost = 8;

    const TiltLensView& view;
    const std::uint32_t ahead;  ///< ways made at a time; rounds of samples are no shorter, so that none is made in vain
    tilt_lens::PixelSampler sampler{0, 0, 0};
    tilt_lens::Emitters::Targets targets;
    tilt_lens::SampleId first{};
    std::uint32_t count = 0;
    std::array<TiltLensWay, kMost> ways;

    void Make(const tilt_lens::SampleId& from)
    {
        first = from;
        count = ahead;
        std::array<tilt_lens::Sample, kMost> samples;
        for (std::uint32_t i = 0; i < count; i++)
            samples[i] = sampler(from.index + i);
        for (std::uint32_t i = 0; i < count; i++)
            ways[i].start = view.emitters.Aim(targets, {from.x, from.y, from.index + i}, samples[i]);
        for (std::uint32_t i = 0; i < count; i++)
            ways[i].FindRay(view.lens);
    }
};

} // namespace pov

#endif

// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/samples/flat_mirror.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "tilt_lens/settings.h"

namespace tilt_lens
{

namespace
{

class MirrorPlane
{
  public:
    explicit MirrorPlane(const FlatMirror& mirror) : mirror(mirror), across(Cross(mirror.sides[0], mirror.sides[1])), area(Length(across))
    {
    }

    bool IsFlat() const { return area > 0.0 && std::isfinite(area); }

    double Area() const { return mirror.unbounded ? HUGE_VAL : area; }

    double Reflectance() const { return mirror.reflectance; }

    double DistanceOf(const Vec3& point) const { return Dot(point - mirror.corner, across) / area; }

    Vec3 ImageOf(const Vec3& point) const { return point - (2.0 * DistanceOf(point) / area) * across; }

    /// Fractions of the way from eye to image between which rays cross the mirror.
    struct Crossing
    {
        double first, last;
    };

    /// @param blur  greatest distance of rays from the way: radius of lens and emitter
    std::optional<Crossing> Shows(const Vec3& eye, const Vec3& source, const Vec3& image, double blur) const
    {
        const double before = DistanceOf(eye), behind = DistanceOf(source);
        if (!(before * behind > 0.0 && (before > 0.0 || mirror.unbounded)))
            return std::nullopt;
        const double crossing = before / (before + behind);
        const Vec3 way = image - eye, at = eye + crossing * way - mirror.corner;
        // rays that start this far from the eye cross a mirror that they graze farther away
        const double spread = blur * (1.0 + Length(way) / std::fabs(before + behind));
        const double along[2] = {Dot(Cross(at, mirror.sides[1]), across), Dot(Cross(mirror.sides[0], at), across)};
        for (int i = 0; i < 2 && !mirror.unbounded; i++)
        {
            const double margin = spread * Length(mirror.sides[1 - i]) / area, place = along[i] / (area * area);
            if (!(place > -margin && place < 1.0 + margin))
                return std::nullopt;
        }
        return Crossing{crossing - spread / Length(way), crossing + spread / Length(way)};
    }

  private:
    FlatMirror mirror;
    Vec3 across;
    double area;
};

class Images
{
  public:
    explicit Images(double lensDiameter) : lensRadius(0.5 * lensDiameter) {}

    void AddOf(const Emitter& source, const MirrorPlane& mirror)
    {
        const Vec3 image = mirror.ImageOf(source.centre);
        if (mirror.Shows({}, source.centre, image, lensRadius + source.radius))
            Add(source, image, mirror.Reflectance());
    }

    /// The lens sees `near`, and in it `far`.
    void AddOf(const Emitter& source, const MirrorPlane& far, const MirrorPlane& near)
    {
        const double blur = lensRadius + source.radius;
        const Vec3 inFar = far.ImageOf(source.centre), image = near.ImageOf(inFar), eye = near.ImageOf({});
        const auto nearCrossing = near.Shows({}, inFar, image, blur), farCrossing = far.Shows(eye, source.centre, inFar, blur);
        if (nearCrossing && farCrossing && nearCrossing->first < farCrossing->last)
            Add(source, image, far.Reflectance() * near.Reflectance());
    }

    std::vector<Emitter> found;

  private:
    void Add(const Emitter& source, const Vec3& image, double reflectance)
    {
        if (source.radiance * reflectance > source.around)
            found.push_back({image, source.radius, source.radiance * reflectance, source.around});
    }

    double lensRadius;
};

std::vector<MirrorPlane> LargestOf(const std::vector<FlatMirror>& mirrors, std::size_t most)
{
    std::vector<MirrorPlane> planes;
    for (const FlatMirror& mirror : mirrors)
        if (MirrorPlane plane(mirror); plane.IsFlat())
            planes.push_back(plane);
    std::stable_sort(planes.begin(), planes.end(), [](const MirrorPlane& a, const MirrorPlane& b) { return a.Area() > b.Area(); });
    planes.erase(planes.begin() + std::min(planes.size(), most), planes.end());
    return planes;
}

}  // namespace

std::vector<Emitter> MirrorImages(const std::vector<Emitter>& sources, const std::vector<FlatMirror>& mirrors, double lensDiameter)
{
    Images images(lensDiameter);
    if (sources.empty())
        return images.found;
    const std::vector<MirrorPlane> planes = LargestOf(mirrors, Settings::greatestImages / sources.size());
    const bool pairs = planes.size() * planes.size() <= Settings::greatestImages / sources.size();
    for (const Emitter& source : sources)
        for (const MirrorPlane& far : planes)
        {
            images.AddOf(source, far);
            for (const MirrorPlane& near : planes)
                if (pairs && &near != &far)
                    images.AddOf(source, far, near);
        }
    return images.found;
}

}  // namespace tilt_lens

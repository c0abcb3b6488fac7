// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file layers.h
/// Picture and layers of a tilt_lens camera, and the blur for another plane of sharp focus.
///
/// A film point's chief ray leaves the lens centre C along d, scaled to the depth 1. Its point at the depth z has the signed blur K (1/z -
/// N.d / (D - N.C)) pixels, where N.X = D is the plane of sharp focus: the vergence of the point minus that of the plane, by the thin lens
/// equation, which holds for a tilted lens, too. K is the same for all pixels; it follows from the layer `blur` and the plane in the file's
/// header.

#ifndef REFOCUS_LAYERS_H
#define REFOCUS_LAYERS_H

#include <array>
#include <stdexcept>
#include <string>
#include <vector>

namespace refocus
{

using Vec3 = std::array<double, 3>;

struct Mistake : std::runtime_error
{
    using std::runtime_error::runtime_error;
};

double Dot(const Vec3& a, const Vec3& b);

/// Points X with normal.X = distance, in world coordinates.
struct Plane
{
    Vec3 normal;
    double distance;
};

/// Interleaved channels, linear, upper row first.
struct Picture
{
    int width = 0, height = 0, channels = 0;
    std::vector<float> values;
    std::vector<std::string> names;
};

struct Layers
{
    int width = 0, height = 0;
    std::vector<float> depth;  ///< scene units; infinite without a hit
    std::vector<float> blur;  ///< pixels, signed, of the render
    std::vector<Vec3> positions;  ///< world coordinates
    std::vector<Vec3> directions;  ///< of the chief rays, world axes, depth 1
    Vec3 location{};  ///< of the lens centre
    Plane focus{};  ///< of the render
    double fStop = 0.0;  ///< of the render
    double blurFactor = 0.0;  ///< K above, pixels times scene units

    /// Signed blur in pixels of a pixel's first surface, for another plane of sharp focus.
    /// @throws Mistake  the plane passes through the lens centre
    double BlurWith(const Plane& plane, std::size_t pixel) const;
};

/// @throws Mistake  no such file, no OpenEXR file, too few channels
Picture ReadPicture(const std::string& path);
Layers ReadLayers(const std::string& path);
void WritePicture(const Picture& picture, const std::string& path);

}  // namespace refocus

#endif

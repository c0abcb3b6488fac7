// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file layers.h
/// Layers of a picture, and the blur for another plane of sharp focus.
///
/// A chief ray leaves the lens centre C along d, of depth 1. At the depth z the signed blur is K (1/z - N.d / (D - N.C)) pixels, for the
/// plane N.X = D. K follows from the layer `blur` and the header's plane.

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

/// Points X with normal.X = distance, world coordinates.
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
    Vec3 location{};  ///< lens centre
    Plane focus{};  ///< of the render
    double fStop = 0.0;  ///< of the render
    double blurFactor = 0.0;  ///< K above, pixels times scene units

    /// @throws Mistake the plane passes through the lens centre
    double BlurWith(const Plane& plane, std::size_t pixel) const;
};

/// @throws Mistake  no such file, no OpenEXR file, too few channels
Picture ReadPicture(const std::string& path);
Layers ReadLayers(const std::string& path);
void WritePicture(const Picture& picture, const std::string& path);

} // namespace refocus

#endif

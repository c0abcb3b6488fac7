// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file layers.h
/// Picture and layers of a tilt_lens camera, and the blur that another plane of sharp focus would give.
///
/// A film point's chief ray leaves the lens centre C along d, scaled to the depth 1. A point on it at the depth z has the
/// signed blur K (1/z - N.d / (D - N.C)) pixels, where N.X = D is the plane of sharp focus: 1/z minus the same number of the
/// plane, by the imaging equation of a thin lens, also of a tilted one. K, the same for all pixels, is taken from the layer
/// `blur` and the plane in the file's header.

#ifndef REFOCUS_LAYERS_H
#define REFOCUS_LAYERS_H

#include <array>
#include <stdexcept>
#include <string>
#include <vector>

namespace refocus
{

using Vec3 = std::array<double, 3>;

/// What a user can mend.
struct Mistake : std::runtime_error
{
    using std::runtime_error::runtime_error;
};

double Dot(const Vec3& a, const Vec3& b);

/// The points X with normal.X = distance, in world coordinates.
struct Plane
{
    Vec3 normal;
    double distance;
};

/// Interleaved channels, linear, rows from above.
struct Picture
{
    int width = 0, height = 0, channels = 0;
    std::vector<float> values;
    std::vector<std::string> names;
};

struct Layers
{
    int width = 0, height = 0;
    std::vector<float> depth;     ///< scene units; infinite where nothing is met
    std::vector<float> blur;      ///< pixels, signed, of the render
    std::vector<Vec3> positions;  ///< world coordinates
    std::vector<Vec3> directions; ///< of the chief rays, world axes, depth 1
    Vec3 location{};              ///< of the lens centre
    Plane focus{};                ///< of the render
    double fStop = 0.0;           ///< of the render
    double blurFactor = 0.0;      ///< K above, pixels times scene units

    /// Signed blur in pixels of a pixel's first surface, with another plane of sharp focus.
    /// @throws Mistake  the plane goes through the lens centre
    double BlurWith(const Plane& plane, std::size_t pixel) const;
};

/// @throws Mistake  no such file, no OpenEXR file, too few channels
Picture ReadPicture(const std::string& path);
Layers ReadLayers(const std::string& path);
void WritePicture(const Picture& picture, const std::string& path);

} // namespace refocus

#endif

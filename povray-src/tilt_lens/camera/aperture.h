// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file aperture.h
/// The shape of the lens opening: a map from the sampler's unit square to aperture coordinates.
///
/// Every map preserves areas up to a constant factor (Picture(): up to its weight). Uniform samples stay uniform, and stratified samples
/// stay stratified.

#ifndef TILT_LENS_APERTURE_H
#define TILT_LENS_APERTURE_H

#include <functional>
#include <memory>
#include <utility>
#include <variant>

namespace tilt_lens
{

/// Point of the lens: a to the right, b up, seen from the camera looking into the scene. The lens is the unit disc (Picture(): the square
/// [-1, 1]^2).
struct AperturePoint
{
    double a, b;
};

class AperturePicture;

/// Immutable and cheap to copy: copies share their tables.
class Aperture
{
  public:
    static constexpr int maxBlades = 1000;

    /// The unit disc, by the concentric map of P. Shirley and K. Chiu, "A Low Distortion Map Between Disk and Square", 1997:
    /// continuous, and a bijection of the closed square and the disc.
    static Aperture Disc();

    /// A regular polygon with its corners on the unit circle. Blades stop the lens of the given f-number down to N/(2 pi) sin(2 pi/N) of
    /// the disc's area. The first corner lies on the a axis, turned by the angle towards b.
    ///
    /// The map is the disc's with triangles in place of sectors: equal angles become equal lengths along an edge, which preserves areas. It
    /// is a continuous bijection.
    ///
    /// With a curvature c the edges are arcs of radius 1/c between the same corners: 0 is straight, 1 the unit circle. At least 512 chords
    /// around the opening approximate the arcs to 2e-5. The triangles from the centre to the chords have equal areas, so that the map
    /// remains a polygon's.
    /// @throws std::invalid_argument  fewer than 3 blades, more than maxBlades, an infinite angle, a curvature outside [0, 1]
    static Aperture Polygon(int blades, double angleRadians, double curvature = 0.0);

    /// An aperture made narrower: 1/ratio of its width, or for a ratio below 1 that fraction of its height. It stays within the unit disc
    /// if it was.
    /// @throws std::invalid_argument  a ratio that is not finite and positive
    static Aperture Squeezed(const Aperture& shape, double ratio);

    /// A disc or polygon that is brighter at its rim or in its middle and passes as much light. At the relative radius r, and with n =
    /// |amount| / (1 - |amount|), the brightness is (n + 1) r^(2n) for a positive amount, (n + 1) (1 - r^2)^n for a negative one.
    /// @throws std::invalid_argument  another shape; an amount outside (-1, 1)
    static Aperture Graded(const Aperture& shape, double amount);

    /// Any brightness over the square around the lens, tabulated in 256 x 256 cells.
    ///
    /// weight(u, v) for (u, v) in [0, 1]^2 is the relative brightness at a = 2u - 1, b = 1 - 2v: v grows *downward*. POV-Ray's `bokeh {
    /// pigment { ... } }` lies so over the lens: its focal blur moves the ray's origin by (u - 0.5) `XPerp` - (v - 0.5) `YPerp`, times half
    /// of `aperture`, with `XPerp` = up x direction and `YPerp` = direction x `XPerp`, which points up. The caller passes the pigment's
    /// value at <u, v, 0>. (Up x direction is the right of a left-handed camera, and the left of any other.)
    ///
    /// Only ratios of weights count; negative and non-finite weights count as 0. Each cell averages 4 of them, or 16 where they vary within
    /// the cell or around it. Details smaller than half a cell may be missed.
    ///
    /// Sampled by inversion: u chooses a from the marginal distribution, v chooses b from the conditional distribution of that column,
    /// linearly within a cell. Monotone, a in u and b in falling v. Continuous except across cells without weight and, in b, from column to
    /// column.
    /// @throws std::invalid_argument  no place has a positive weight
    static Aperture Picture(const std::function<double(double u, double v)>& weight);

    /// @param u, v  in [0, 1)
    AperturePoint operator()(double u, double v) const;

    /// Maps several points.
    /// @param count  a multiple of 4
    void Map(const double* u, const double* v, double* a, double* b, int count) const;

    /// Probability density of the points, per area of aperture coordinates; 0 outside the opening.
    double Density(const AperturePoint& point) const;

    /// Radius of a circle around the centre that contains the opening.
    double BoundingRadius() const;
    bool IsDisc() const { return std::holds_alternative<Round>(shape); }

  private:
    struct Round
    {
    };
    struct Outline;
    struct Oval;
    struct Grade;
    template<class Table>
    using Shared = std::shared_ptr<const Table>;
    using Shape = std::variant<Round, Shared<Outline>, Shared<AperturePicture>, Shared<Oval>, Shared<Grade>>;

    Aperture() = default;  // a disc
    explicit Aperture(Shape itsShape) : shape(std::move(itsShape)) {}

    Shape shape;
};

}  // namespace tilt_lens

#endif

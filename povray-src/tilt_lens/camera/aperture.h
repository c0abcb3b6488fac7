// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file aperture.h
/// The lens opening's shape: a map from the sampler's unit square to aperture coordinates. It preserves areas up to a constant factor
/// (Picture(): up to its weight), so uniform and stratified samples stay so.

#ifndef TILT_LENS_APERTURE_H
#define TILT_LENS_APERTURE_H

#include <functional>
#include <memory>
#include <utility>
#include <variant>

namespace tilt_lens
{

/// Point of the lens: a right, b up, as the camera sees the scene. The lens is the unit disc (Picture(): the square [-1, 1]^2).
struct AperturePoint
{
    double a, b;
};

class AperturePicture;

/// Immutable; copies share their tables.
class Aperture
{
  public:
    static constexpr int maxBlades = 1000;

    /// Unit disc, by the concentric map of P. Shirley and K. Chiu, "A Low Distortion Map Between Disk and Square", 1997: a continuous
    /// bijection of the closed square and the disc.
    static Aperture Disc();

    /// Regular polygon with corners on the unit circle: N/(2 pi) sin(2 pi/N) of the disc's area. The first corner lies on the a axis,
    /// turned by the angle towards b. Equal angles become equal lengths along an edge, which preserves areas. A continuous bijection.
    ///
    /// With a curvature c the edges are arcs of radius 1/c between the corners: 0 is straight, 1 the unit circle. At least 512 chords
    /// approximate them to 2e-5; their triangles with the centre have equal areas, so the map remains a polygon's.
    /// @throws std::invalid_argument  fewer than 3 blades, more than maxBlades, an infinite angle, a curvature outside [0, 1]
    static Aperture Polygon(int blades, double angleRadians, double curvature = 0.0);

    /// 1/ratio of the shape's width, or below 1 that fraction of its height. Stays within the unit disc.
    /// @throws std::invalid_argument  a ratio that is not finite and positive
    static Aperture Squeezed(const Aperture& shape, double ratio);

    /// A disc or polygon brighter at its rim or in its middle, with the same light. At the relative radius r, with n = |amount| / (1
    /// - |amount|): brightness is (n + 1) r^(2n) for a positive amount, (n + 1) (1 - r^2)^n for a negative one.
    /// @throws std::invalid_argument  another shape; an amount outside (-1, 1)
    static Aperture Graded(const Aperture& shape, double amount);

    /// Any brightness over the square around the lens, tabulated in 256 x 256 cells.
    ///
    /// weight(u, v) for (u, v) in [0, 1]^2 is the relative brightness at a = 2u - 1, b = 1 - 2v: v grows *downward*, as POV-Ray's
    /// `bokeh { pigment { ... } }` at <u, v, 0> lies over the lens. Its focal blur moves the ray's origin by (u - 0.5) `XPerp` - (v -
    /// 0.5) `YPerp`, times half of `aperture`; `XPerp` = up x direction (right of a left-handed camera, left of any other), `YPerp` =
    /// direction x `XPerp` points up.
    ///
    /// Only ratios of weights count; negative and non-finite weights count as 0. Each cell averages 4, or 16 where they vary within
    /// or around it. Details smaller than half a cell may be missed.
    ///
    /// Inversion: u chooses a from the marginal distribution, v chooses b from that column's, linearly within a cell. Monotone, a in
    /// u and b in falling v. Continuous except across cells without weight and, in b, between columns.
    /// @throws std::invalid_argument  no place has a positive weight
    static Aperture Picture(const std::function<double(double u, double v)>& weight);

    /// @param u, v  in [0, 1)
    AperturePoint operator()(double u, double v) const;

    /// @param count  a multiple of 4
    void Map(const double* u, const double* v, double* a, double* b, int count) const;

    /// Density of the points per area of aperture coordinates; 0 outside.
    double Density(const AperturePoint& point) const;

    /// Circle around the centre that contains the opening.
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

    Aperture() = default;  // disc
    explicit Aperture(Shape itsShape) : shape(std::move(itsShape)) {}

    Shape shape;
};

} // namespace tilt_lens

#endif

// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file aperture.h
/// Maps from the sampler's unit square to the lens opening, with areas in proportion to their light.

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

    /// Unit disc, by the map of P. Shirley and K. Chiu, "A Low Distortion Map Between Disk and Square", 1997.
    static Aperture Disc();

    /// Regular polygon with corners on the unit circle, the first at the angle from the a axis towards b. With a curvature c the edges are
    /// arcs of radius 1/c, approximated to 2e-5 by at least 512 chords.
    /// @throws std::invalid_argument  blades outside [3, maxBlades], an infinite angle, a curvature outside [0, 1]
    static Aperture Polygon(int blades, double angleRadians, double curvature = 0.0);

    /// Divides the shape's width by the ratio, or, below 1, multiplies its height by it.
    /// @throws std::invalid_argument  a ratio not finite and positive
    static Aperture Squeezed(const Aperture& shape, double ratio);

    /// A disc or polygon brighter at its rim or in its middle, with the same light. Let n = |amount| / (1 - |amount|). At the relative
    /// radius r the brightness is (n + 1) r^(2n), or (n + 1) (1 - r^2)^n for a negative amount.
    /// @throws std::invalid_argument  another shape; an amount outside (-1, 1)
    static Aperture Graded(const Aperture& shape, double amount);

    /// Any brightness over the square around the lens, in 256 x 256 cells. a grows with u, b falls with v.
    /// @param weight  relative brightness at a = 2u - 1, b = 1 - 2v, as in POV-Ray's `bokeh`; negative and non-finite weights count as 0
    /// @throws std::invalid_argument  no place has a positive weight
    static Aperture Picture(const std::function<double(double u, double v)>& weight);

    /// @param u, v  in [0, 1)
    AperturePoint operator()(double u, double v) const;

    /// @param count  a multiple of 4
    void Map(const double* u, const double* v, double* a, double* b, int count) const;

    /// Points per area of aperture coordinates.
    double Density(const AperturePoint& point) const;

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

}  // namespace tilt_lens

#endif

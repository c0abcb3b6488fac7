// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file aperture.h
/// The shape of the lens opening, as a map from the unit square of the sampler to aperture
/// coordinates. Every map preserves measure (up to the constant area; for a picture, up to its
/// weight), so uniform samples become uniform on the opening, and boxes of the square become
/// regions of the same share of the opening, so stratified samples stay stratified.

#ifndef TILT_LENS_APERTURE_H
#define TILT_LENS_APERTURE_H

#include <functional>
#include <memory>

namespace tilt_lens
{

/// Aperture coordinates: a to the right, b up, as seen from the camera looking into the scene; the
/// unit disc (or, for a picture, the square [-1, 1]^2) is the lens.
struct AperturePoint
{
    double a, b;
};

class AperturePicture;

/// One shape of opening. Immutable and cheap to copy: copies share their tables.
class Aperture
{
  public:
    static constexpr int maxBlades = 1000;

    /// The unit disc, by the concentric map of P. Shirley and K. Chiu, "A Low Distortion Map
    /// Between Disk and Square", 1997. Continuous; a bijection between the closed square and the
    /// disc.
    static Aperture Disc();

    /// A regular polygon with its corners on the unit circle: the diaphragm's blades cut into the
    /// lens that the f-number describes, so the opening has N/(2 pi) sin(2 pi/N) of the disc's
    /// area. The first corner lies on the right-hand axis, turned by the angle from `a` towards
    /// `b`.
    ///
    /// The concentric map with the sectors of the disc made triangles: equal angles become equal
    /// lengths along an edge, which preserves areas. Continuous and a bijection like the disc's.
    ///
    /// With a curvature c the edges are arcs of radius 1/c between the same corners: 0 is straight,
    /// 1 the unit circle. An arc is drawn as chords that span triangles of equal area with the
    /// middle, at least 512 around the opening: it is missed by less than 2e-5, and the map remains
    /// that of a polygon.
    /// @throws std::invalid_argument  fewer than 3 blades, more than maxBlades, an infinite angle, a
    ///                                curvature outside [0, 1]
    static Aperture Polygon(int blades, double angleRadians, double curvature = 0.0);

    /// A shape made narrower: to 1/ratio of its width, or for a ratio below 1 to that part of its
    /// height. What was inside the unit disc stays there.
    /// @throws std::invalid_argument  a ratio that is not finite and positive
    static Aperture Squeezed(const Aperture& shape, double ratio);

    /// A shape of blades or a disc that is brighter at its rim or in its middle, and lets as much light through. Each point of it
    /// lies at a part r of the way from the middle to the rim. With n = |amount| / (1 - |amount|), its brightness is
    /// (n + 1) r^(2n) for an amount above 0, and (n + 1) (1 - r^2)^n for one below.
    /// @throws std::invalid_argument  another shape; an amount outside (-1, 1)
    static Aperture Graded(const Aperture& shape, double amount);

    /// Any brightness over the square around the lens, tabulated in 256 x 256 cells.
    ///
    /// weight(u, v) for (u, v) in [0, 1]^2 is the relative brightness at a = 2u - 1, b = 1 - 2v: v
    /// grows *downward*. That is how POV-Ray's `bokeh { pigment { ... } }` lies over the lens: its
    /// focal blur moves the ray's origin by (u - 0.5) `XPerp` - (v - 0.5) `YPerp`, times half of
    /// `aperture`, with `XPerp` = up x direction and `YPerp` = direction x `XPerp`, that is, up. So
    /// the caller passes the pigment's value at <u, v, 0>. (Up x direction is the camera's right
    /// only for a left-handed camera, and the opposite of it otherwise.)
    ///
    /// Weights have no upper limit, only their ratios count; negative and non-finite ones count as
    /// 0. Each cell takes 4 of them, or 16 where they vary within the cell or around it. Details
    /// smaller than half a cell may be missed.
    ///
    /// By inversion: u chooses a from the marginal distribution, v chooses b from the conditional
    /// one of that column of cells, linearly within a cell. Monotone, a in u and b in falling v;
    /// continuous except across cells without weight and, in b, from column to column.
    /// @throws std::invalid_argument  no place has a positive weight
    static Aperture Picture(const std::function<double(double u, double v)>& weight);

    /// @param u, v  in [0, 1)
    AperturePoint operator()(double u, double v) const;

    /// The same for some points, side by side.
    /// @param count  a multiple of 4
    void Map(const double* u, const double* v, double* a, double* b, int count) const;

    /// Density of the points that uniform (u, v) give, per area of aperture coordinates; 0 outside the
    /// opening. Its integral is 1.
    double Density(const AperturePoint& point) const;

    /// Radius of a circle around all of the opening.
    double BoundingRadius() const;
    /// Whether the opening is the unit disc.
    bool IsDisc() const { return shape == Shape::Disc; }

  private:
    enum class Shape
    {
        Disc,
        Polygon,
        Picture,
        Squeezed,
        Graded
    };
    struct Outline;  ///< the corners of a polygon
    struct Oval;     ///< a shape and how it is squeezed
    struct Grade;    ///< a shape and where it is bright

    explicit Aperture(Shape itsShape) : shape(itsShape) {}

    Shape shape;
    std::shared_ptr<const Outline> outline;  ///< of a polygon only
    std::shared_ptr<const AperturePicture> picture;  ///< of a picture only
    std::shared_ptr<const Oval> oval;        ///< of a squeezed shape only
    std::shared_ptr<const Grade> grade;      ///< of a graded shape only

    double Size(const AperturePoint& point) const;
    void MapOneByOne(const double* u, const double* v, double* a, double* b, int count) const;
};

}  // namespace tilt_lens

#endif

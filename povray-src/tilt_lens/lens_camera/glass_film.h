// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#ifndef TILT_LENS_GLASS_FILM_H
#define TILT_LENS_GLASS_FILM_H

#include <cstdint>

#include "tilt_lens/camera/frame_table.h"
#include "tilt_lens/camera/ray.h"
#include "tilt_lens/glass/glass_lens.h"
#include "tilt_lens/math/simd.h"

namespace tilt_lens
{

struct FourGlassPoints
{
    double x[4], y[4];
    double u[4], v[4];      ///< in [0, 1), but for aimed ones
    std::uint32_t seed[4];  ///< for drawing blocked directions again
    unsigned int wanted;    ///< one bit per point that needs a sample
    unsigned int aimed = 0; ///< those whose (u, v) is the point of the pupil itself; not drawn again
};

struct FourGlassSamples
{
    double origin[3][4], direction[3][4], w[4], weight[4];
    double a[4], b[4];  ///< point of the pupil: a unit disc with the lens's axes
    std::uint32_t refused[4];

    LensRay RayOf(std::size_t i) const
    {
        return {{origin[0][i], origin[1][i], origin[2][i]}, {direction[0][i], direction[1][i], direction[2][i]}, w[i]};
    }
};

struct FourPupils
{
    double place[3][4];                           ///< film points, lens frame, mm
    double l[4], m[4], radial[4], tangential[4];  ///< ellipses of directions
    double axisL[4], axisM[4];                    ///< their radial axes
    double brightness[4];
    unsigned int seen = 0;                        ///< one bit per film point with light
};

/// The ellipse's centre is relative to the paraxial aim, so it varies little over the frame.
struct PupilNode
{
    double l = 0.0, m = 0.0, radial = 0.0, tangential = 0.0;
    double open = 0.0;     ///< share that the rims leave open
    double passing = 0.0;  ///< share of the ellipse whose rays pass
    double natural = 0.0;  ///< relative illumination by the stop alone
    bool seen = false;
};

/// Odd, so that one entry is the centre. Interpolating the open share errs by 1/2000.
constexpr int kPupilTableSide = 33;

template<class Vector>
struct PupilInterpolation
{
    const PupilNode* upperLeft[kVectorWidth<Vector>];
    Vector weights[4];

    TILT_LENS_INLINED PupilInterpolation(const PupilNode* nodes, const double* x, const double* y)
    {
        Vector right, down;
        for (std::size_t i = 0; i < kVectorWidth<Vector>; i++)
        {
            const TablePlace place = PlaceOf(kPupilTableSide, {x[i], y[i]});
            upperLeft[i] = &nodes[place.at];
            right[i] = place.right;
            down[i] = place.down;
        }
        weights[0] = (1.0 - right) * (1.0 - down);
        weights[1] = right * (1.0 - down);
        weights[2] = (1.0 - right) * down;
        weights[3] = right * down;
    }

    TILT_LENS_INLINED Vector operator()(double PupilNode::* number) const
    {
        constexpr std::size_t corners[4] = {0, 1, kPupilTableSide, kPupilTableSide + 1};
        Vector mean{};
        for (int corner = 0; corner < 4; corner++)
        {
            Vector value{};
            for (std::size_t i = 0; i < kVectorWidth<Vector>; i++)
                value[i] = upperLeft[i][corners[corner]].*number;
            mean += weights[corner] * value;
        }
        return mean;
    }
};

struct GlassFilm
{
    const Lens* lens;
    CardinalPoints cardinal;
    double natural;  ///< share of the natural light fall-off, 0 to 1
    Vec3 axisX, axisY;  ///< of the lens, world, unit length
    Vec3 middle, right, up;  ///< lens frame, mm
    double middleOpen = 1.0, middleNatural = 1.0;

    /// Lens frame, mm.
    template<class Number>
    TILT_LENS_INLINED VecOf<Number> Place(const Number& x, const Number& y) const
    {
        return {middle.x + x * right.x + y * up.x, middle.y + x * right.y + y * up.y, middle.z + x * right.z + y * up.z};
    }

    template<class Number>
    TILT_LENS_INLINED Number Brightness(const Number& open, const Number& itsNatural) const
    {
        const Number even = Number() + 1.0, falloff = natural == 0.0 ? even : 1.0 - natural + natural * itsNatural / middleNatural;
        return falloff * open / middleOpen;
    }

    /// Scales the direction to the axial length of the chief ray, so that ray parameters compare with ideal rays'.
    template<class Number>
    TILT_LENS_INLINED LensRayOf<Number> ToWorld(const Number& x, const Number& y, const GlassRayOf<Number>& ray) const
    {
        constexpr double leastAlong = 0.01;
        const VecOf<Number> origin = AlongAxes(ray.origin), direction = AlongAxes(ray.direction);
        const Number least = Number() + leastAlong, along = Dot(direction, Broadcast<Number>(lens->axis));
        const Number scale = Dot(lens->direction, lens->axis) / Max(along, least), unit = Number() + lens->millimetre;
        return {unit * origin, scale * direction, lens->focusMiddle + x * lens->focusRight + y * lens->focusUp};
    }

  private:
    template<class Number>
    TILT_LENS_INLINED VecOf<Number> AlongAxes(const VecOf<Number>& v) const
    {
        const Vec3& axisZ = lens->normal;
        return {v.x * axisX.x + v.y * axisY.x + v.z * axisZ.x, v.x * axisX.y + v.y * axisY.y + v.z * axisZ.y,
                v.x * axisX.z + v.y * axisY.z + v.z * axisZ.z};
    }
};

} // namespace tilt_lens

#endif

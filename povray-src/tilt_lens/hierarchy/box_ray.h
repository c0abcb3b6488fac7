// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file box_ray.h
/// A ray against eight axis-aligned boxes at a time: the slab method, in single precision, rounded so that no box is
/// missed which the ray meets in exact arithmetic (T. Ize, "Robust BVH Ray Traversal", JCGT 2013).

#ifndef TILT_LENS_BOX_RAY_H
#define TILT_LENS_BOX_RAY_H

#include <cmath>
#include <cstddef>

#include "tilt_lens/math/simd.h"

namespace tilt_lens
{

/// Eight boxes. Those of unused places are empty: no ray meets them.
struct alignas(32) EightBoxes
{
    /// Planes of the boxes: first the lower ones of the axes x, y, z, then the upper ones.
    float planes[6][8];
};

class BoxRay
{
  public:
    /// @param origin, direction  three numbers each, in the boxes' frame and unit; the direction has any length but 0
    template<class Vector>
    BoxRay(const Vector& origin, const Vector& direction)
    {
        for (int axis = 0; axis < 3; axis++)
            Set(axis, origin[axis], direction[axis]);
    }

    float enterFrom[3], leaveFrom[3], enterInverse[3], leaveInverse[3];
    std::ptrdiff_t enterPlanes[3], leavePlanes[3];  ///< where these lie in EightBoxes, in bytes

  private:
    /// Each of the at most three roundings of a product (origin, inverse, product) changes it by 2^-24; this is eight of them.
    static constexpr double kRounding = 4.8e-7;
    /// A ray that begins on a plane at 0 and runs along it is not beyond it.
    static constexpr double kLeastMargin = 1e-15;
    /// A component of the direction counts as at least this, so that no inverse is infinite.
    static constexpr double kLeastSlope = 1e-36;

    void Set(int axis, double origin, double slope)
    {
        const bool falls = std::signbit(slope);
        const double inverse = std::fabs(slope) > kLeastSlope ? 1.0 / slope : std::copysign(1.0 / kLeastSlope, slope);
        const double margin = std::fabs(origin) * kRounding + kLeastMargin, signedMargin = falls ? -margin : margin;
        enterFrom[axis] = origin + signedMargin;
        leaveFrom[axis] = origin - signedMargin;
        enterInverse[axis] = inverse * (1.0 - kRounding);
        leaveInverse[axis] = inverse * (1.0 + kRounding);
        const std::ptrdiff_t row = sizeof(Float8);
        enterPlanes[axis] = (falls ? axis + 3 : axis) * row;
        leavePlanes[axis] = (falls ? axis : axis + 3) * row;
    }
};

/// A ray against eight boxes.
/// @param limit  boxes that begin behind it do not count; in lengths of the ray's direction
/// @param begin  eight numbers, at a multiple of 32 bytes: is set to where the ray enters the boxes, 0 where it begins in them
/// @return       bits of the boxes that the ray meets
typedef unsigned int EnterBoxes(const EightBoxes& boxes, const BoxRay& ray, float limit, float* begin);

/// For every processor.
EnterBoxes EnterPlain;

/// With half as many instructions, for those that have AVX2; has the same results to the last bit.
EnterBoxes EnterByAvx2;

/// The faster one that this processor has.
extern EnterBoxes* const Enter;

} // namespace tilt_lens

#endif

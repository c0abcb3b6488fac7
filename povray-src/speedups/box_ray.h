// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file box_ray.h
/// Slab method for eight axis-aligned boxes at a time, in single precision, rounded so that no box is missed (T. Ize, "Robust BVH Ray
/// Traversal", JCGT 2013).

#ifndef SPEEDUPS_BOX_RAY_H
#define SPEEDUPS_BOX_RAY_H

#include <cstddef>

#include "tilt_lens/math/simd.h"

namespace speedups
{

using namespace tilt_lens;

/// Unused places hold empty boxes.
struct alignas(32) EightBoxes
{
    float planes[6][8];
};

/// Vector is Float8 for AVX2, Float4 for every processor; both give equal results.
template<class Vector>
class BoxRay
{
  public:
    /// @param origin, direction  as for BoxHierarchy::Walk()
    TILT_LENS_INLINED BoxRay(const double* origin, const double* direction)
    {
        // the fourth lane is unused
        const Double4 from = {origin[0], origin[1], origin[2], 0.0}, slope = {direction[0], direction[1], direction[2], 1.0};
        const LongMask4 bits = LongMask4(slope), sign = bits & (1ll << 63);
        const Double4 length = Double4(bits ^ sign), steepest = Double4() + 1.0 / kLeastSlope;
        const Double4 inverse = length > kLeastSlope ? 1.0 / slope : Double4(LongMask4(steepest) | sign);
        const Double4 margin = Double4(LongMask4(from) & ~(1ll << 63)) * kRounding + kLeastMargin;
        const Double4 signedMargin = Double4(LongMask4(margin) ^ sign);
        Float4 enterFroms = __builtin_convertvector(from + signedMargin, Float4);
        Float4 leaveFroms = __builtin_convertvector(from - signedMargin, Float4);
        Float4 enterInverses = __builtin_convertvector(inverse * (1.0 - kRounding), Float4);
        Float4 leaveInverses = __builtin_convertvector(inverse * (1.0 + kRounding), Float4);
        // broadcasting from memory takes one instruction, from a lane two
        asm volatile("" : "+m"(enterFroms), "+m"(leaveFroms), "+m"(enterInverses), "+m"(leaveInverses));
        for (int axis = 0; axis < 3; axis++)
        {
            enterFrom[axis] = enterFroms[axis] - Vector();
            leaveFrom[axis] = leaveFroms[axis] - Vector();
            enterInverse[axis] = enterInverses[axis] - Vector();
            leaveInverse[axis] = leaveInverses[axis] - Vector();
            const std::ptrdiff_t row = sizeof(EightBoxes::planes[0]), upper = sign[axis] != 0 ? 3 * row : 0;
            enterPlanes[axis] = axis * row + upper;
            leavePlanes[axis] = (axis + 3) * row - upper;
        }
    }

    /// @param limit  ray parameter, in lengths of the direction
    /// @param begin  aligned to 32 bytes: ray parameters of the eight entries, 0 if the ray starts inside
    /// @return       one bit per box met
    TILT_LENS_INLINED unsigned int Enter(const EightBoxes& boxes, float limit, float* begin) const
    {
        unsigned int met = 0;
        for (std::size_t first = 0; first < 8; first += kVectorWidth<Vector>)
            met |= EnterSome(boxes, limit, begin, first) << first;
        return met;
    }

  private:
    /// Allows for eight roundings of 2^-24, more than occur.
    static constexpr double kRounding = 4.8e-7;
    /// Keeps a ray along a plane at 0 inside the slab.
    static constexpr double kLeastMargin = 1e-15;
    /// Keeps inverses finite.
    static constexpr double kLeastSlope = 1e-36;

    Vector enterFrom[3], leaveFrom[3], enterInverse[3], leaveInverse[3];
    std::ptrdiff_t enterPlanes[3], leavePlanes[3];  ///< byte offsets in EightBoxes

    TILT_LENS_INLINED unsigned int EnterSome(const EightBoxes& boxes, float limit, float* begin, std::size_t first) const
    {
        const char* const from = reinterpret_cast<const char*>(&boxes) + first * sizeof(float);
        Vector enter = Vector(), leave = limit - Vector();
        for (int axis = 0; axis < 3; axis++)
        {
            const Vector in = *reinterpret_cast<const Vector*>(from + enterPlanes[axis]);
            const Vector out = *reinterpret_cast<const Vector*>(from + leavePlanes[axis]);
            const Vector near = (in - enterFrom[axis]) * enterInverse[axis];
            const Vector far = (out - leaveFrom[axis]) * leaveInverse[axis];
            enter = near > enter ? near : enter;
            leave = far < leave ? far : leave;
        }
        *reinterpret_cast<Vector*>(begin + first) = enter;
        return SignBits(enter <= leave);
    }
};

} // namespace speedups

#endif

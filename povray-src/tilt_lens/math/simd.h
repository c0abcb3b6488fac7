// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file simd.h
/// Numbers that lie side by side, to and from a vector register. They need no alignment.

#ifndef TILT_LENS_SIMD_H
#define TILT_LENS_SIMD_H

#include <cstring>

namespace tilt_lens
{

/// @param from  as many numbers as a Vector holds, which may be a single number
template<class Vector, class Number>
Vector Load(const Number* from)
{
    Vector vector;
    std::memcpy(&vector, from, sizeof(vector));
    return vector;
}

template<class Vector, class Number>
void Store(Number* to, Vector vector)
{
    std::memcpy(to, &vector, sizeof(vector));
}

} // namespace tilt_lens

#endif

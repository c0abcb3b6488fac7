// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file real.h
/// The numbers that a camera is solved with: 113 bits, and exponents far beyond those of doubles. The numbers of a
/// scene are taken as exact, however much of them cancels (a plane of focus a hair from the lens, a camera
/// 10^12 units from the origin), and the lens is rounded once, at the end. It costs microseconds, once a
/// camera, and is the same on every machine: it needs nothing of the C library.

#ifndef TILT_LENS_REAL_H
#define TILT_LENS_REAL_H

#include <boost/multiprecision/cpp_bin_float.hpp>

#include "tilt_lens/math/vec3.h"

namespace tilt_lens
{

using Real = boost::multiprecision::cpp_bin_float_quad;
using RealVec = VecOf<Real>;

} // namespace tilt_lens

#endif

// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file real.h
/// The solver's numbers: 113 bits and a wide range of exponents, against cancellation. Equal on every machine, without the C library.

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

// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file variant.h
/// Each file here is compiled once per variant, with TILT_LENS_VARIANT, the namespace, and TILT_LENS_REGISTER, the bytes of a vector
/// register.
///
/// Rule, kept by the test `unit.kernel_symbols`: call no inline function of the library or the standard library that is not
/// TILT_LENS_INLINED. The linker keeps any one of the variants' copies: AVX2 instructions would run on processors without them.

#ifndef TILT_LENS_VARIANT_H
#define TILT_LENS_VARIANT_H

#include <type_traits>

#include "tilt_lens/math/kernels.h"
#include "tilt_lens/math/simd.h"

namespace tilt_lens::TILT_LENS_VARIANT
{

typedef double Doubles __attribute__((vector_size(TILT_LENS_REGISTER)));
typedef float Floats __attribute__((vector_size(TILT_LENS_REGISTER)));
typedef int Ints __attribute__((vector_size(TILT_LENS_REGISTER)));

template<class Pointer>
using FunctionOf = std::remove_pointer_t<Pointer>;

FunctionOf<decltype(Kernels::findPoints)> FindPoints;
FunctionOf<decltype(Kernels::findFilmPoints)> FindFilmPoints;
FunctionOf<decltype(Kernels::addRadiances)> AddRadiances;
FunctionOf<decltype(Kernels::mapToDisc)> MapToDisc;
FunctionOf<decltype(Kernels::findPositions)> FindPositions;
FunctionOf<decltype(Kernels::makeRays)> MakeRays;
FunctionOf<decltype(Kernels::traceGlass)> TraceGlass;
FunctionOf<decltype(Kernels::findPupils)> FindPupils;
FunctionOf<decltype(Kernels::aimAtPupils)> AimAtPupils;
FunctionOf<decltype(Kernels::leaveGlass)> LeaveGlass;
FunctionOf<decltype(Kernels::spreadSample)> SpreadSample;
FunctionOf<decltype(Kernels::filterBlock)> FilterBlock;
FunctionOf<decltype(Kernels::estimateSpread)> EstimateSpread;

} // namespace tilt_lens::TILT_LENS_VARIANT

#endif

// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file variant.h
/// Compiled once per variant: TILT_LENS_VARIANT is its namespace, TILT_LENS_REGISTER the bytes of a vector register.
///
/// Call no inline function without TILT_LENS_INLINED: the linker keeps any variant's copy, perhaps one that the processor cannot run. The
/// test `unit.kernel_symbols` checks this.

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

// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/math/kernels.h"

namespace tilt_lens
{

namespace
{

const Kernels& BestKernels()
{
#ifdef TILT_LENS_AVX2
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi"))
        return avx2::kKernels;
#endif
    return plain::kKernels;
}

} // namespace

const Kernels* kernels = &BestKernels();

} // namespace tilt_lens

// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file with_kernels.h
/// Runs code with each variant of the kernels.

#ifndef TILT_LENS_TESTS_WITH_KERNELS_H
#define TILT_LENS_TESTS_WITH_KERNELS_H

#include "tilt_lens/math/kernels.h"

namespace tilt_lens
{

inline bool HasSeveralVariants()
{
    return kernels != &plain::kKernels;
}

template<class Function>
auto WithPlainKernels(const Function& function)
{
    struct Replaced
    {
        const Kernels* const before = kernels;
        Replaced() { kernels = &plain::kKernels; }
        ~Replaced() { kernels = before; }
    } replaced;
    return function();
}

} // namespace tilt_lens

#endif

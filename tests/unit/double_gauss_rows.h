// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file double_gauss_rows.h
/// Prescription of pbrt's dgauss.50mm.dat (US patent 2,673,491).

#ifndef TILT_LENS_TESTS_DOUBLE_GAUSS_ROWS_H
#define TILT_LENS_TESTS_DOUBLE_GAUSS_ROWS_H

namespace tilt_lens
{

inline constexpr const char* kDoubleGauss =
    "29.475 3.76 1.67 25.2\n84.83 0.12 1 25.2\n19.275 4.025 1.67 23\n40.77 3.275 1.699 23\n12.75 5.705 1 18\n0 4.5 0 17.1\n"
    "-14.495 1.18 1.603 17\n40.77 6.065 1.658 20\n-20.385 0.19 1 20\n437.065 3.22 1.717 20\n-39.73 0 1 20\n";

inline constexpr const char* kDispersiveDoubleGauss =
    "29.475 3.76 1.67 25.2 47\n84.83 0.12 1 25.2\n19.275 4.025 1.67 23 47\n40.77 3.275 1.699 23 30\n12.75 5.705 1 18\n0 4.5 0 17.1\n"
    "-14.495 1.18 1.603 17 38\n40.77 6.065 1.658 20 57\n-20.385 0.19 1 20\n437.065 3.22 1.717 20 48\n-39.73 0 1 20\n";

} // namespace tilt_lens

#endif

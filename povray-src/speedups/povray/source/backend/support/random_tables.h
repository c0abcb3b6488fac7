// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file random_tables.h
/// Cache of tables of random numbers, always the same by the same seed. The renderer makes tables of 32768 numbers twice at start and
/// twice per thread.

#ifndef POVRAY_BACKEND_RANDOM_TABLES_H
#define POVRAY_BACKEND_RANDOM_TABLES_H

#include <cstddef>
#include <vector>

namespace pov
{

/// The table made with the same arguments, for the whole run, or null. Thread-safe.
const std::vector<double>* KeptRandomDoubles(double least, double most, std::size_t count);
void KeepRandomDoubles(double least, double most, const std::vector<double>& numbers);

} // namespace pov

#endif

// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file random_tables.h
/// Cache of tables of random numbers, which depend on their seed alone; each thread needs two.

#ifndef POVRAY_BACKEND_RANDOM_TABLES_H
#define POVRAY_BACKEND_RANDOM_TABLES_H

#include <cstddef>
#include <vector>

namespace pov
{

/// Valid for the whole run; may be null. Thread-safe.
const std::vector<double>* KeptRandomDoubles(double least, double most, std::size_t count);
void KeepRandomDoubles(double least, double most, const std::vector<double>& numbers);

} // namespace pov

#endif

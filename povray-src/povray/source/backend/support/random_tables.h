// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file random_tables.h
/// Tables of random numbers are the same each time, since their generator begins with the same seed. The renderer asks for
/// those of 32768 numbers twice at start and twice more for every thread.

#ifndef POVRAY_BACKEND_RANDOM_TABLES_H
#define POVRAY_BACKEND_RANDOM_TABLES_H

#include <cstddef>
#include <vector>

namespace pov
{

/// Made before with the same arguments: any thread may ask, the answer stays. Null if it was not.
const std::vector<double>* KeptRandomDoubles(double least, double most, std::size_t count);
void KeepRandomDoubles(double least, double most, const std::vector<double>& numbers);

} // namespace pov

#endif

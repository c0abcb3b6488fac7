// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file allocator.cpp
/// Allocates by jemalloc, in huge pages if the system has them. Parser and picture touch many megabytes for the first time; the system
/// handles 2 megabytes per huge page at once, in place of 4 kilobytes. Figures: docs/notebook.md, section on the cost of reading a scene.

/// Read by jemalloc before main; see jemalloc(3).
extern "C" const char* malloc_conf;
const char* malloc_conf = "thp:always";

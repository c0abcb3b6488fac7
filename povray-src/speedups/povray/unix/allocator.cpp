// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file allocator.cpp
/// Allocates by jemalloc, in huge pages if the system has them (figures: docs/notebook.md).

/// Read before main; see jemalloc(3).
extern "C" const char* malloc_conf;
const char* malloc_conf = "thp:always";

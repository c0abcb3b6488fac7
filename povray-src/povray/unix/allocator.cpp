// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file allocator.cpp
/// How the program takes memory: by jemalloc, in huge pages where the system has them. A parser and the blocks of a picture
/// touch many megabytes for the first time, which takes the system a step for each page of 4 kilobytes, but one for each huge page
/// of 2 megabytes. docs/notebook.md ("What does reading a scene cost?") has the figures.

/// Read by jemalloc before main; its manual page, jemalloc(3), has the words.
extern "C" const char* malloc_conf;
const char* malloc_conf = "thp:always";

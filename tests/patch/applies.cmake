# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
#
# The series, and nothing else, applies without fuzz to the pinned source. Takes REPOSITORY, ARCHIVES or POVRAY_TARBALL, and WORK.
include("${REPOSITORY}/cmake/PatchedSource.cmake")

file(REMOVE_RECURSE "${WORK}")
patched_source_prepare("${WORK}" "${ARCHIVES}" "${REPOSITORY}/povray-src/upstream.json" "${REPOSITORY}/patches" TRUE)

patched_source_read_series(ours "${REPOSITORY}/patches/series")
list(LENGTH ours count)
file(STRINGS "${WORK}/applied-patches" applied)
list(LENGTH applied all)
math(EXPR first "${all} - ${count}")
list(SUBLIST applied ${first} -1 last)
if(NOT "${last}" STREQUAL "${ours}")
    message(FATAL_ERROR "The record of applied patches ends with (${last}), the series is (${ours}).")
endif()
if(first EQUAL 0)
    message(FATAL_ERROR "No patch of Debian's series was applied.")
endif()
file(GLOB_RECURSE rejects "${WORK}/povray/*.rej" "${WORK}/povray/*.orig")
if(rejects)
    message(FATAL_ERROR "Patching left behind ${rejects}")
endif()
file(REMOVE_RECURSE "${WORK}")

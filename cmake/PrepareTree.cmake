# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
#
# The patched source outside of a build, for cmake/edit-patch: cmake -DREPOSITORY= -DSERIES= -DWORK= [-DDOWNLOADS= -DPOVRAY_TARBALL=] -P
# this. Without DOWNLOADS, the configured build's archives.
include("${CMAKE_CURRENT_LIST_DIR}/PatchedSource.cmake")

if(NOT DOWNLOADS)
    set(DOWNLOADS "${REPOSITORY}/build/downloads")
    if(EXISTS "${REPOSITORY}/build/CMakeCache.txt")
        load_cache("${REPOSITORY}/build" READ_WITH_PREFIX "" POVRAY_TARBALL)
    endif()
endif()
patched_source_prepare("${WORK}" "${DOWNLOADS}" "${REPOSITORY}/povray-src/upstream.json" "${SERIES}" TRUE)

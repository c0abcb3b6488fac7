# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
#
# All required: a missing picture format or preview would be noticed only in use.
include_guard()

set(TILT_LENS_MISSING "")

macro(tilt_lens_require found package)
    if(NOT ${found})
        list(APPEND TILT_LENS_MISSING ${package})
    endif()
endmacro()

find_package(Threads REQUIRED)
find_package(Boost 1.65 CONFIG QUIET COMPONENTS thread date_time)
find_package(ZLIB QUIET)
find_package(PNG QUIET)
find_package(JPEG QUIET)
find_package(TIFF QUIET)
# Debian's Imath names a Python library outside its package; harmless.
set(CMAKE_MESSAGE_LOG_LEVEL WARNING)
find_package(OpenEXR CONFIG QUIET)
unset(CMAKE_MESSAGE_LOG_LEVEL)
if(TARGET OpenEXR::IlmImf AND NOT TARGET OpenEXR::OpenEXR)
    add_library(OpenEXR::OpenEXR ALIAS OpenEXR::IlmImf)  # OpenEXR 2 calls it by this name
endif()
find_package(SDL 1.2 QUIET)
find_package(nlohmann_json QUIET)
find_library(JEMALLOC_LIBRARY NAMES libjemalloc.a jemalloc)  # static where it can be had: one library less to load at start
mark_as_advanced(JEMALLOC_LIBRARY)

tilt_lens_require(Boost_THREAD_FOUND libboost-thread-dev)
tilt_lens_require(Boost_DATE_TIME_FOUND libboost-date-time-dev)
tilt_lens_require(ZLIB_FOUND zlib1g-dev)
tilt_lens_require(PNG_FOUND libpng-dev)
tilt_lens_require(JPEG_FOUND libjpeg-dev)
tilt_lens_require(TIFF_FOUND libtiff-dev)
tilt_lens_require(OpenEXR_FOUND libopenexr-dev)
tilt_lens_require(SDL_FOUND libsdl1.2-dev)
tilt_lens_require(JEMALLOC_LIBRARY libjemalloc-dev)
tilt_lens_require(nlohmann_json_FOUND nlohmann-json3-dev)

if(TILT_LENS_MISSING)
    list(JOIN TILT_LENS_MISSING " " TILT_LENS_MISSING)
    message(FATAL_ERROR "Libraries are missing. Install their Debian packages and configure again:\n"
        "  sudo apt-get install ${TILT_LENS_MISSING}\n"
        "Other systems have them under other names; docs/building.md, \"What the build needs\", says which libraries these are.")
endif()

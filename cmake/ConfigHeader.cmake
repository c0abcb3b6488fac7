# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
#
# The headers of POV-Ray's configure script.
include_guard()
include(CheckFunctionExists)
include(CheckIncludeFile)

foreach(function IN ITEMS clock_gettime getcwd getrusage gettimeofday nanosleep readlink)
    string(TOUPPER "HAVE_${function}" variable)
    check_function_exists(${function} ${variable})
endforeach()
check_include_file(sys/resource.h HAVE_SYS_RESOURCE_H)
check_include_file(sys/time.h HAVE_SYS_TIME_H)

if(CMAKE_LIBRARY_ARCHITECTURE)
    set(POVRAY_ARCHITECTURE "${CMAKE_LIBRARY_ARCHITECTURE}")
else()
    set(POVRAY_ARCHITECTURE "${CMAKE_SYSTEM_PROCESSOR}-linux-gnu")
endif()
string(TOUPPER "${CMAKE_BUILD_TYPE}" build_type)
string(STRIP "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${build_type}}" POVRAY_CXXFLAGS)

set(POVRAY_GENERATED "${CMAKE_BINARY_DIR}/generated")
configure_file("${CMAKE_CURRENT_LIST_DIR}/config.h.in" "${POVRAY_GENERATED}/config.h" @ONLY)
# Printed at the start of a render; unknown is "" as upstream has it.
file(CONFIGURE OUTPUT "${POVRAY_GENERATED}/jversion.h" CONTENT "#define JVERSION \"${JPEG_VERSION}\"\n")

# A definition of the files that use it, so that a changed patch does not recompile everything.
if(TILT_LENS_PATCHES)
    patched_source_series_hash(series_hash "${TILT_LENS_SERIES}" ${TILT_LENS_LEFT_OUT})
    string(SUBSTRING "${series_hash}" 0 12 series_hash)
    set(TILT_LENS_BUILD_NAME "povray-tilt-lens ${PROJECT_VERSION}, patch series ${series_hash}")
    if(NOT SPEEDUPS)
        string(APPEND TILT_LENS_BUILD_NAME " without speedups")
    endif()
else()
    set(TILT_LENS_BUILD_NAME "povray-tilt-lens ${PROJECT_VERSION}, without its patch series")
endif()

# No other program may continue a picture from a state file.
file(GLOB_RECURSE own_sources CONFIGURE_DEPENDS "${CMAKE_SOURCE_DIR}/povray-src/*.cpp" "${CMAKE_SOURCE_DIR}/povray-src/*.h")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${own_sources})
set(TILT_LENS_SOURCES_HASH "")
foreach(source IN LISTS own_sources)
    file(SHA256 "${source}" hash)
    string(APPEND TILT_LENS_SOURCES_HASH "${hash}\n")
endforeach()
string(SHA256 TILT_LENS_SOURCES_HASH "${TILT_LENS_SOURCES_HASH}")

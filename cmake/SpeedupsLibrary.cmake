# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
#
# Code that only makes POV-Ray faster, without headers of POV-Ray: "speedups/box_hierarchy.h". The files of povray-src/speedups/povray are
# part of the program.
include_guard()

if(SPEEDUPS)
    file(GLOB speedups_sources CONFIGURE_DEPENDS "${CMAKE_SOURCE_DIR}/povray-src/speedups/*.cpp")
    add_library(speedups STATIC ${speedups_sources})
    target_compile_options(speedups PRIVATE -Wall -Wextra -fno-math-errno)
    target_link_libraries(speedups PUBLIC tilt_lens)    # its vector registers
endif()

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
#
# The camera as a plain C++17 library, without any header of POV-Ray. Users include, for example, "tilt_lens/camera/optics.h".
include_guard()

file(GLOB tilt_lens_sources CONFIGURE_DEPENDS "${CMAKE_SOURCE_DIR}/povray-src/tilt_lens/*/*.cpp")
add_library(tilt_lens STATIC ${tilt_lens_sources})
target_include_directories(tilt_lens PUBLIC "${CMAKE_SOURCE_DIR}/povray-src")
# No fused multiply-add, also in functions of the headers and in upstream's files: a processor that has it, such as arm64, would
# give other pixels than one that has not.
target_compile_options(tilt_lens PUBLIC -ffp-contract=off)
# Nobody asks for errno: without it, a square root is one instruction.
target_compile_options(tilt_lens PRIVATE -Wall -Wextra -fno-math-errno)
target_link_libraries(tilt_lens PRIVATE Boost::headers nlohmann_json::nlohmann_json)
if(TILT_LENS_SANITIZE MATCHES "undefined")
    target_compile_options(tilt_lens PRIVATE -fno-sanitize-recover=undefined)
endif()

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
#
# The camera as a C++17 library without headers of POV-Ray: "tilt_lens/camera/optics.h".
include_guard()

set(tilt_lens_folder "${CMAKE_SOURCE_DIR}/povray-src/tilt_lens")
file(GLOB tilt_lens_sources CONFIGURE_DEPENDS "${tilt_lens_folder}/*/*.cpp")
file(GLOB tilt_lens_kernels CONFIGURE_DEPENDS "${tilt_lens_folder}/kernels/*.cpp")
list(REMOVE_ITEM tilt_lens_sources ${tilt_lens_kernels})

# Vector register's bytes, and options, of each variant of the kernels (math/kernels.h).
set(tilt_lens_register_plain 16)
set(tilt_lens_options_plain)
set(tilt_lens_register_avx2 32)
set(tilt_lens_options_avx2 -mavx2 -mbmi)
set(tilt_lens_variants plain)
if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64|i.86)$")
    list(APPEND tilt_lens_variants avx2)
endif()

# add_tilt_lens_kernels(TARGET): kernels for tilt_lens_sources, with TARGET's options, as TARGET_plain and TARGET_avx2.
function(add_tilt_lens_kernels target)
    foreach(variant IN LISTS tilt_lens_variants)
        set(kernels ${target}_${variant})
        add_library(${kernels} OBJECT EXCLUDE_FROM_ALL ${tilt_lens_kernels})
        target_include_directories(${kernels} PRIVATE $<TARGET_PROPERTY:${target},INCLUDE_DIRECTORIES>)
        target_compile_definitions(${kernels} PRIVATE $<TARGET_PROPERTY:${target},COMPILE_DEFINITIONS>
            TILT_LENS_VARIANT=${variant} TILT_LENS_REGISTER=${tilt_lens_register_${variant}})
        target_compile_options(${kernels} PRIVATE $<TARGET_PROPERTY:${target},COMPILE_OPTIONS> ${tilt_lens_options_${variant}})
        target_sources(${target} PRIVATE $<TARGET_OBJECTS:${kernels}>)
    endforeach()
    if("avx2" IN_LIST tilt_lens_variants)
        target_compile_definitions(${target} PUBLIC TILT_LENS_AVX2)
    endif()
endfunction()

add_library(tilt_lens STATIC ${tilt_lens_sources})
target_include_directories(tilt_lens PUBLIC "${CMAKE_SOURCE_DIR}/povray-src")
# No fused multiply-add, in all files: processors that have it, such as arm64, would give other pixels.
target_compile_options(tilt_lens PUBLIC -ffp-contract=off)
# Without errno a square root is one instruction.
target_compile_options(tilt_lens PRIVATE -Wall -Wextra -fno-math-errno)
target_link_libraries(tilt_lens PRIVATE Boost::headers nlohmann_json::nlohmann_json)
if(TILT_LENS_SANITIZE MATCHES "undefined")
    target_compile_options(tilt_lens PRIVATE -fno-sanitize-recover=undefined)
endif()
add_tilt_lens_kernels(tilt_lens)

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
#
# Upstream's patched files, our files at upstream's paths, the camera library, and the speedups.
include_guard()

set(POVRAY_SOURCE "${CMAKE_BINARY_DIR}/upstream/povray")
set(POVRAY_OWN "${CMAKE_SOURCE_DIR}/povray-src/povray")
set(POVRAY_SPEEDUPS "${CMAKE_SOURCE_DIR}/povray-src/speedups/povray")

# changes only while configuring
file(GLOB_RECURSE povray_core "${POVRAY_SOURCE}/source/*.cpp")
file(GLOB povray_vfe "${POVRAY_SOURCE}/vfe/*.cpp" "${POVRAY_SOURCE}/vfe/unix/*.cpp")
set(povray_unix "${POVRAY_SOURCE}/unix/disp_text.cpp" "${POVRAY_SOURCE}/unix/disp_sdl.cpp")
file(GLOB_RECURSE povray_own_core CONFIGURE_DEPENDS "${POVRAY_OWN}/source/*.cpp")
file(GLOB_RECURSE povray_own_unix CONFIGURE_DEPENDS "${POVRAY_OWN}/vfe/*.cpp" "${POVRAY_OWN}/unix/*.cpp")
if(SPEEDUPS)
    file(GLOB_RECURSE povray_speedups CONFIGURE_DEPENDS "${POVRAY_SPEEDUPS}/source/*.cpp")
    list(APPEND povray_own_core ${povray_speedups})
endif()

# Both trees are searched for "backend/render/x.h".
add_library(povray_settings INTERFACE)
target_compile_definitions(povray_settings INTERFACE HAVE_CONFIG_H _GNU_SOURCE=1 _REENTRANT
    BOOST_BIND_GLOBAL_PLACEHOLDERS)     # upstream's way of using them; Boost prints a note without this
target_compile_options(povray_settings INTERFACE -pipe $<$<COMPILE_LANG_AND_ID:CXX,GNU>:-fno-enforce-eh-specs>)
target_include_directories(povray_settings INTERFACE "${POVRAY_GENERATED}")
set(povray_folders source source/backend source/base source/frontend vfe vfe/unix unix)
list(TRANSFORM povray_folders PREPEND "${POVRAY_SOURCE}/")
target_include_directories(povray_settings INTERFACE ${povray_folders})
target_include_directories(povray_settings INTERFACE "${POVRAY_OWN}/source" "${POVRAY_OWN}" "${SDL_INCLUDE_DIR}")
add_library(povray_own_unix STATIC ${povray_own_unix})
target_include_directories(povray_own_unix PRIVATE "${POVRAY_OWN}" "${SDL_INCLUDE_DIR}")
target_compile_definitions(povray_own_unix PRIVATE TILT_LENS_INSTALL_PREFIX="${CMAKE_INSTALL_PREFIX}")
target_compile_options(povray_own_unix PRIVATE -Wall -Wextra ${TILT_LENS_CHECK_STACK})
target_link_libraries(povray_own_unix PRIVATE ${CMAKE_DL_LIBS})
target_link_libraries(povray_settings INTERFACE tilt_lens
    PNG::PNG JPEG::JPEG TIFF::TIFF OpenEXR::OpenEXR ZLIB::ZLIB Boost::thread Boost::date_time
    Threads::Threads povray_own_unix m)
if(SPEEDUPS)
    target_include_directories(povray_settings INTERFACE "${POVRAY_SPEEDUPS}/source")
    target_link_libraries(povray_settings INTERFACE speedups)
endif()

# Object libraries: all files reach the link. Upstream's warnings are off (-w); ours stay.
add_library(povray_core OBJECT ${povray_core})
target_link_libraries(povray_core PRIVATE povray_settings)
target_compile_options(povray_core PRIVATE -w)

# Upstream's headers take most of a compilation, so several files are compiled together. Not those whose names clash (shapes), that include
# a header without a guard (parser), whose functions the fuzzers replace (povms, scene), or that fixes add.
set_target_properties(povray_core PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8)
set(povray_alone ${povray_core})
list(FILTER povray_alone INCLUDE REGEX "/backend/(shape|parser)/|/base/povms\\.cpp$|/backend/scene/scene\\.cpp$")
foreach(source IN LISTS povray_core)
    file(STRINGS "${source}" notice LIMIT_COUNT 1)
    if(notice MATCHES "povray-tilt-lens")
        list(APPEND povray_alone "${source}")
    endif()
endforeach()
set_source_files_properties(${povray_alone} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)

# These functions read others' text; checks of the stack elsewhere would be 3 % of all instructions.
set(povray_checks_stack ${povray_core})
list(FILTER povray_checks_stack INCLUDE REGEX "/backend/parser/")
set_source_files_properties(${povray_checks_stack} PROPERTIES COMPILE_OPTIONS "${TILT_LENS_CHECK_STACK}")

# Replaces vfe's two macros of installation folders, which the program finds at run time.
add_library(povray_vfe OBJECT ${povray_vfe})
target_link_libraries(povray_vfe PRIVATE povray_settings)
target_compile_options(povray_vfe PRIVATE -w ${TILT_LENS_CHECK_STACK} "SHELL:-include vfe/unix/install_folders.h")
target_compile_definitions(povray_vfe PRIVATE POVCONFDIR_BACKWARD="/etc")
set_target_properties(povray_vfe PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8)

# Ours alone warn, not upstream's headers or message codes such as 'OCLA'.
add_library(povray_own_settings INTERFACE)
target_link_libraries(povray_own_settings INTERFACE povray_settings)
target_include_directories(povray_own_settings SYSTEM INTERFACE ${povray_folders})
target_compile_options(povray_own_settings INTERFACE -Wall -Wextra -Wno-multichar)

# without our patches upstream calls none of our files
if(TILT_LENS_PATCHES AND povray_own_core)
    add_library(povray_own OBJECT ${povray_own_core})
    # fewer at a time, so that a change compiles soon
    set_target_properties(povray_own PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 4)
    target_link_libraries(povray_own PRIVATE povray_own_settings)
endif()

# add_povray_program(NAME): all these objects. Sanitizers have their own allocators.
function(add_povray_program name)
    add_executable(${name} ${povray_unix})
    target_link_libraries(${name} PRIVATE povray_settings povray_core povray_vfe)
    target_compile_options(${name} PRIVATE -w)
    if(TARGET povray_own)
        target_link_libraries(${name} PRIVATE povray_own)
    endif()
    if(TILT_LENS_PATCHES AND SPEEDUPS AND NOT TILT_LENS_SANITIZE)
        target_sources(${name} PRIVATE "${POVRAY_SPEEDUPS}/unix/allocator.cpp")
        target_link_libraries(${name} PRIVATE "${JEMALLOC_LIBRARY}" ${CMAKE_DL_LIBS})
    endif()
endfunction()
add_povray_program(povray)
set_target_properties(povray PROPERTIES RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/bin")

set_source_files_properties("${POVRAY_SOURCE}/source/backend/povray.cpp" "${POVRAY_SOURCE}/vfe/unix/unixconsole.cpp"
    PROPERTIES COMPILE_DEFINITIONS "TILT_LENS_BUILD_NAME=\"${TILT_LENS_BUILD_NAME}\"")
set_source_files_properties("${POVRAY_OWN}/source/frontend/state_key.cpp"
    PROPERTIES COMPILE_DEFINITIONS "TILT_LENS_PROGRAM=\"${TILT_LENS_BUILD_NAME}, sources ${TILT_LENS_SOURCES_HASH}\"")

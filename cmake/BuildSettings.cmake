# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
#
# Compiler, build type, ccache and sanitizers.
include_guard()

if(CMAKE_BINARY_DIR STREQUAL CMAKE_SOURCE_DIR)
    message(FATAL_ERROR "Build in a folder of its own: rm -r CMakeCache.txt CMakeFiles; cmake --preset release")
endif()
if(NOT CMAKE_BUILD_TYPE)
    set(CMAKE_BUILD_TYPE Release CACHE STRING "Release or Debug" FORCE)
endif()

# Debian's g++ 12 takes C++17 with extensions by itself: stock POV-Ray's language.
set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

# Stock's assertions stay on. The prefix map makes clones in two folders equal.
set(CMAKE_CXX_FLAGS_RELEASE "-O3")
set(CMAKE_CXX_FLAGS_DEBUG "-O1 -g -fno-omit-frame-pointer")
add_compile_options("-ffile-prefix-map=${CMAKE_SOURCE_DIR}=.")
# Only inlined functions pass registers of 32 bytes (math/simd.h).
add_compile_options(-Wno-psabi)

# Ends the program at a write past an array. Sanitizers exclude the C library's checks.
set(TILT_LENS_CHECK_STACK)
if(NOT TILT_LENS_SANITIZE)
    set(TILT_LENS_CHECK_STACK -fstack-protector-strong)
    set(level 3)
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 12)
        set(level 2)    # all that it has; glibc's headers would warn in every file
    endif()
    add_compile_options($<$<CONFIG:Release>:-U_FORTIFY_SOURCE> $<$<CONFIG:Release>:-D_FORTIFY_SOURCE=${level}>)
    add_link_options(LINKER:-z,relro,-z,now)
endif()

if(TILT_LENS_SANITIZE)
    add_compile_options(-fsanitize=${TILT_LENS_SANITIZE})
    add_link_options(-fsanitize=${TILT_LENS_SANITIZE})
endif()

# A profile lies beside its object, so two steps use one folder (cmake/build-fast). prefer-atomic: threads count together.
if(TILT_LENS_PROFILE STREQUAL "make")
    add_compile_options(-fprofile-generate -fprofile-update=prefer-atomic)
    add_link_options(-fprofile-generate)
elseif(TILT_LENS_PROFILE STREQUAL "use")
    add_compile_options(-fprofile-use -fprofile-correction -fprofile-partial-training -Wno-missing-profile -flto)
    add_link_options(-fprofile-use -flto=auto)
elseif(TILT_LENS_PROFILE)
    message(FATAL_ERROR "TILT_LENS_PROFILE is \"${TILT_LENS_PROFILE}\"; it can be \"make\", \"use\" or empty")
endif()

# ccache fails where it cannot write its folder.
function(tilt_lens_try_ccache)
    set(probe "${CMAKE_BINARY_DIR}/CMakeFiles/ccache-probe.cpp")
    file(WRITE "${probe}" "int probe;\n")
    execute_process(COMMAND "${CCACHE_PROGRAM}" "${CMAKE_CXX_COMPILER}" -c "${probe}" -o "${probe}.o"
        RESULT_VARIABLE result OUTPUT_QUIET ERROR_VARIABLE said)
    set(works OFF)
    if(result EQUAL 0)
        set(works ON)
    else()
        message(STATUS "Building without ccache, which does not work here: ${said}")
    endif()
    set(TILT_LENS_CCACHE_WORKS ${works} CACHE INTERNAL "Whether ccache compiled a trial file")
endfunction()

if(TILT_LENS_CCACHE)
    find_program(CCACHE_PROGRAM ccache)
    mark_as_advanced(CCACHE_PROGRAM)
    if(CCACHE_PROGRAM AND NOT DEFINED TILT_LENS_CCACHE_WORKS)
        tilt_lens_try_ccache()
    endif()
    if(CCACHE_PROGRAM AND TILT_LENS_CCACHE_WORKS)
        # Paths are relative to this folder, so that another clone hits.
        set(CMAKE_CXX_COMPILER_LAUNCHER
            /usr/bin/env "CCACHE_BASEDIR=${CMAKE_SOURCE_DIR}" CCACHE_NOHASHDIR=1 "${CCACHE_PROGRAM}")
    endif()
endif()

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
#
# Makes the bundle's folder WORK/NAME, for Bundle.cmake. Debian's tools name the libraries' packages.
cmake_minimum_required(VERSION 3.22)

set(folder "${WORK}/${NAME}")
set(program "${folder}/bin/povray")

# owner(OUT FILE): the Debian package of FILE. dpkg's list may lack the name's /usr.
function(owner out file)
    get_filename_component(file "${file}" REALPATH)
    string(REGEX REPLACE "^/usr" "" short "${file}")
    execute_process(COMMAND dpkg-query --search "${file}" "${short}" OUTPUT_VARIABLE said ERROR_QUIET)
    if(NOT said MATCHES "^([^ \n]+): ")
        message(FATAL_ERROR "No Debian package holds ${file}, so that its licence is not known. A bundle is made on Debian, with "
            "libraries of its packages.")
    endif()
    set(${out} "${CMAKE_MATCH_1}" PARENT_SCOPE)
endfunction()

# licence(PACKAGE): copies licences and the texts that they refer to, and notes the source.
function(licence package)
    string(REGEX REPLACE ":.*" "" plain "${package}")
    file(COPY_FILE "/usr/share/doc/${plain}/copyright" "${folder}/licences/${plain}")
    file(READ "/usr/share/doc/${plain}/copyright" text)
    string(REGEX MATCHALL "/usr/share/common-licenses/[A-Za-z]+(-[0-9.]*[0-9])?" texts "${text}")
    foreach(common IN LISTS texts)
        get_filename_component(name "${common}" NAME)
        file(COPY_FILE "${common}" "${folder}/licences/${name}" ONLY_IF_DIFFERENT)
    endforeach()
    execute_process(COMMAND dpkg-query --show "--showformat=   \${source:Package} \${source:Version} (\${Package})\\n" "${package}"
        OUTPUT_VARIABLE line COMMAND_ERROR_IS_FATAL ANY)
    file(APPEND "${folder}/SOURCE" "${line}")
endfunction()

# newest_glibc(OUT FILE...): the newest version that the files ask for.
function(newest_glibc out)
    set(newest 0)
    foreach(file IN LISTS ARGN)
        execute_process(COMMAND "${OBJDUMP}" -T "${file}" OUTPUT_VARIABLE symbols COMMAND_ERROR_IS_FATAL ANY)
        string(REGEX MATCHALL "GLIBC_[0-9.]+" versions "${symbols}")
        list(REMOVE_DUPLICATES versions)
        foreach(version IN LISTS versions)
            string(REPLACE "GLIBC_" "" version "${version}")
            if(version VERSION_GREATER newest)
                set(newest "${version}")
            endif()
        endforeach()
    endforeach()
    set(${out} "${newest}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE "${folder}")
execute_process(COMMAND "${CMAKE_COMMAND}" --install "${BUILD}" --component bundle --prefix "${folder}" --strip
    OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)

# All but glibc's. The program loads SDL with the first window, from the system.
set(CMAKE_GET_RUNTIME_DEPENDENCIES_PLATFORM linux+elf)
set(CMAKE_GET_RUNTIME_DEPENDENCIES_TOOL objdump)
set(CMAKE_GET_RUNTIME_DEPENDENCIES_COMMAND "${OBJDUMP}")
file(GET_RUNTIME_DEPENDENCIES EXECUTABLES "${program}"
    RESOLVED_DEPENDENCIES_VAR libraries UNRESOLVED_DEPENDENCIES_VAR unresolved
    PRE_EXCLUDE_REGEXES "^ld-linux" "^lib(c|m|dl|rt|pthread|resolv|util)\\.so")
if(unresolved)
    message(FATAL_ERROR "Libraries of the program are not on this system: ${unresolved}")
endif()
file(MAKE_DIRECTORY "${folder}/lib" "${folder}/licences")
file(COPY_FILE "${BUILD}/bundle/SOURCE" "${folder}/SOURCE")
file(APPEND "${folder}/SOURCE" "
3. The libraries in lib/, and jemalloc in the program itself, as packaged by Debian. Debian distributes
   their source under these names and versions: apt-get source NAME=VERSION.
")
set(packages "")
foreach(library IN LISTS libraries)
    get_filename_component(name "${library}" NAME)
    get_filename_component(real "${library}" REALPATH)
    file(COPY_FILE "${real}" "${folder}/lib/${name}")
    owner(package "${library}")
    list(APPEND packages "${package}")
endforeach()
owner(package "${JEMALLOC}")
list(APPEND packages "${package}")
list(REMOVE_DUPLICATES packages)
list(SORT packages)
foreach(package IN LISTS packages)
    licence("${package}")
endforeach()
file(COPY_FILE "${BUILD}/upstream/debian-copyright" "${folder}/licences/povray")

file(GLOB all "${folder}/lib/*")
newest_glibc(glibc "${program}" ${all})
file(WRITE "${folder}/READ-ME-FIRST" "povray-tilt-lens ${VERSION}: POV-Ray 3.7 with a tilt-shift camera, for Linux with glibc ${glibc} or later

This is an unofficial version of POV-Ray. The POV-Ray team does not support it and is not
responsible for it; please do not report its faults to them.

Nothing need be installed. In the folder where the pictures shall be:

    ${NAME}/render                            the miniature town
    ${NAME}/render SCENE.pov +W640 +H360      a scene of yours

Without Bash: ${NAME}/bin/povray SCENE.pov +W640 +H360 -D
A window with the picture needs SDL 1.2 of the system (libSDL-1.2.so.0). ./focus and ./batch are
not in this bundle: they need Python and packages of it, and the repository, whose
commands take this program by --povray ${NAME}/bin/povray.

README.md and docs/ describe the camera. SOURCE says where the source is, LICENSE and licences/
under which licences all of it may be used and passed on.
")

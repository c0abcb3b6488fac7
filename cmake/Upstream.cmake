# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
#
# The pinned source of upstream: reads the pin, checks files against it, and finds the files
# (a folder given by POVRAY_TARBALL, the download folder, or the network, in this order).
#
# The pin is upstream's tarball, and a table of the packaging revisions by which Debian's releases distribute
# it. Any one revision of the table will do.
#
# upstream_read_pin sets in the caller's scope:
#   UPSTREAM_PACKAGE, UPSTREAM_VERSION, UPSTREAM_SOURCE_FOLDER
#   UPSTREAM_TARBALL                 upstream's file name
#   UPSTREAM_REVISIONS               Debian's versions of the package, oldest first
#   UPSTREAM_<dsc or debian>_<N>     file names of revision N, counted from 0
#   UPSTREAM_TABLE                   the revisions with their releases, for messages
include_guard()

# Notes size and SHA-256 of the file that the JSON object at the path ARGN describes; sets OUT to its name.
macro(upstream_read_file out)
    string(JSON ${out} GET "${upstream_json}" ${ARGN} name)
    string(JSON UPSTREAM_SIZE_${${out}} GET "${upstream_json}" ${ARGN} size)
    string(JSON UPSTREAM_SHA256_${${out}} GET "${upstream_json}" ${ARGN} sha256)
endmacro()

# Reads povray-src/upstream.json (or the file PIN) into UPSTREAM_* and, for each file name,
# UPSTREAM_SIZE_<name> and UPSTREAM_SHA256_<name>.
macro(upstream_read_pin pin)
    file(READ "${pin}" upstream_json)
    string(JSON UPSTREAM_PACKAGE GET "${upstream_json}" package)
    string(JSON UPSTREAM_VERSION GET "${upstream_json}" upstream_version)
    string(JSON UPSTREAM_SOURCE_FOLDER GET "${upstream_json}" source_folder)
    upstream_read_file(UPSTREAM_TARBALL tarball)
    string(JSON upstream_count LENGTH "${upstream_json}" revisions)
    math(EXPR upstream_last "${upstream_count} - 1")
    set(UPSTREAM_REVISIONS "")
    set(UPSTREAM_TABLE "")
    foreach(upstream_index RANGE ${upstream_last})
        string(JSON upstream_version GET "${upstream_json}" revisions ${upstream_index} version)
        string(JSON upstream_releases GET "${upstream_json}" revisions ${upstream_index} releases)
        string(REGEX REPLACE "[^a-z,]" "" upstream_releases "${upstream_releases}")
        string(REPLACE "," ", " upstream_releases "${upstream_releases}")
        list(APPEND UPSTREAM_REVISIONS "${upstream_version}")
        string(APPEND UPSTREAM_TABLE "  ${upstream_version} (${upstream_releases})\n")
        foreach(upstream_role IN ITEMS dsc debian)
            upstream_read_file(UPSTREAM_${upstream_role}_${upstream_index} revisions ${upstream_index} ${upstream_role})
        endforeach()
    endforeach()
endmacro()

# Sets OUT to what is wrong with FOLDER/NAME, or to "" where it is the pinned file.
function(upstream_file_fault out folder name)
    set(path "${folder}/${name}")
    set(fault "")
    if(NOT EXISTS "${path}")
        set(fault "is missing")
    else()
        file(SIZE "${path}" size)
        if(NOT size EQUAL UPSTREAM_SIZE_${name})
            set(fault "has ${size} bytes, expected ${UPSTREAM_SIZE_${name}}")
        else()
            file(SHA256 "${path}" sha256)
            if(NOT sha256 STREQUAL UPSTREAM_SHA256_${name})
                set(fault "has SHA-256 ${sha256}, expected ${UPSTREAM_SHA256_${name}}")
            endif()
        endif()
    endif()
    set(${out} "${fault}" PARENT_SCOPE)
endfunction()

# Looks for a whole revision in FOLDER, the newest first. Sets INDEX to its number in the table and FAULTS to "", or
# FAULTS to a text that says what the folder lacks.
function(upstream_find_revision index faults folder)
    upstream_file_fault(fault "${folder}" "${UPSTREAM_TARBALL}")
    set(lacking "")
    if(fault)
        set(lacking "  ${UPSTREAM_TARBALL} ${fault}\n")
    endif()
    set(lacking_packaging "")
    list(LENGTH UPSTREAM_REVISIONS number)
    while(number GREATER 0)
        math(EXPR number "${number} - 1")
        list(GET UPSTREAM_REVISIONS ${number} version)
        set(lacking_here "")
        foreach(name IN ITEMS "${UPSTREAM_dsc_${number}}" "${UPSTREAM_debian_${number}}")
            upstream_file_fault(fault "${folder}" "${name}")
            if(fault)
                string(APPEND lacking_here "  ${name} ${fault} (revision ${version})\n")
            endif()
        endforeach()
        if(NOT lacking_here)
            set(lacking_packaging "")
            break()
        endif()
        string(APPEND lacking_packaging "${lacking_here}")
    endwhile()
    set(${index} ${number} PARENT_SCOPE)
    set(${faults} "${lacking}${lacking_packaging}" PARENT_SCOPE)
endfunction()

# Sets OUT to a text on the packaging revisions in FOLDER that are not in the table ("" where there is none).
function(upstream_unknown_revisions out folder)
    file(GLOB found RELATIVE "${folder}" "${folder}/${UPSTREAM_PACKAGE}_*.dsc")
    list(LENGTH UPSTREAM_REVISIONS count)
    math(EXPR last "${count} - 1")
    foreach(number RANGE ${last})
        list(REMOVE_ITEM found "${UPSTREAM_dsc_${number}}")
    endforeach()
    set(text "")
    if(found)
        list(JOIN found ", " found)
        string(CONCAT text "The folder holds ${found}, a packaging revision that is not pinned. Pinned are:\n"
            "${UPSTREAM_TABLE}docs/patching.md, \"Add a revision of Debian's package\", says how to add it.\n")
    endif()
    set(${out} "${text}" PARENT_SCOPE)
endfunction()

# Downloads into a folder of this attempt alone and hands over checked files only, so that whatever
# ends this attempt, the next one starts clean. Sets INDEX to the revision's number.
function(upstream_download index downloads)
    set(attempt "${downloads}/attempt")
    file(REMOVE_RECURSE "${attempt}")
    file(MAKE_DIRECTORY "${attempt}")
    message(STATUS "Downloading Debian's source package ${UPSTREAM_PACKAGE} ${UPSTREAM_VERSION} (53 MB)")
    execute_process(
        COMMAND "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/fetch-debian-source" fetch
            "${UPSTREAM_PACKAGE}" "${attempt}" ${UPSTREAM_REVISIONS}
        RESULT_VARIABLE result ERROR_VARIABLE said)
    if(NOT result EQUAL 0)
        file(REMOVE_RECURSE "${attempt}")
        message(FATAL_ERROR "POV-Ray's source could not be downloaded.\n${said}\n"
            "Pinned in povray-src/upstream.json are these revisions of Debian's package:\n${UPSTREAM_TABLE}"
            "Without a network: copy the files of one of them into a folder and configure with "
            "-DPOVRAY_TARBALL=FOLDER.")
    endif()
    upstream_find_revision(number faults "${attempt}")
    if(faults)
        file(REMOVE_RECURSE "${attempt}")
        message(FATAL_ERROR "The mirror's files are not those pinned in povray-src/upstream.json; nothing "
            "of them was kept:\n${faults}")
    endif()
    foreach(name IN ITEMS "${UPSTREAM_TARBALL}" "${UPSTREAM_dsc_${number}}" "${UPSTREAM_debian_${number}}")
        file(RENAME "${attempt}/${name}" "${downloads}/${name}")
    endforeach()
    file(REMOVE_RECURSE "${attempt}")
    set(${index} ${number} PARENT_SCOPE)
endfunction()

# Sets OUT to a list of two files as pinned, upstream's tarball and the archive of one of Debian's revisions,
# fetching them where needed.
function(upstream_obtain out downloads)
    if(POVRAY_TARBALL)
        get_filename_component(folder "${POVRAY_TARBALL}" ABSOLUTE BASE_DIR "${CMAKE_BINARY_DIR}")
        if(EXISTS "${folder}" AND NOT IS_DIRECTORY "${folder}")
            get_filename_component(folder "${folder}" DIRECTORY)
        endif()
        upstream_find_revision(number faults "${folder}")
        if(faults)
            upstream_unknown_revisions(unknown "${folder}")
            message(FATAL_ERROR "POVRAY_TARBALL: the folder ${folder} does not hold Debian's source package "
                "${UPSTREAM_PACKAGE} ${UPSTREAM_VERSION} as pinned in povray-src/upstream.json:\n"
                "${faults}${unknown}Give the folder with upstream's tarball and the two files of one revision, or drop "
                "the option (-UPOVRAY_TARBALL) to download them.")
        endif()
    else()
        set(folder "${downloads}")
        upstream_find_revision(number faults "${folder}")
        if(faults)
            file(REMOVE "${folder}/${UPSTREAM_TARBALL}")
            upstream_download(number "${folder}")
        endif()
    endif()
    set(${out} "${folder}/${UPSTREAM_TARBALL}" "${folder}/${UPSTREAM_debian_${number}}" PARENT_SCOPE)
endfunction()

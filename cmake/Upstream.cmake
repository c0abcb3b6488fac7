# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
#
# The pinned source package of upstream: reads the pin, checks files against it, and finds the files
# (a folder given by POVRAY_TARBALL, the download folder, or the network, in this order).
#
# Sets in the caller's scope:
#   UPSTREAM_PACKAGE, UPSTREAM_DEBIAN_VERSION, UPSTREAM_VERSION, UPSTREAM_SOURCE_FOLDER
#   UPSTREAM_FILES         the package's file names
#   UPSTREAM_FILE_<role>   the file name of role dsc, orig or debian
include_guard()

# Reads povray-src/upstream.json (or the file PIN) into UPSTREAM_* and, for each file name,
# UPSTREAM_SIZE_<name> and UPSTREAM_SHA256_<name>.
macro(upstream_read_pin pin)
    file(READ "${pin}" upstream_json)
    string(JSON UPSTREAM_PACKAGE GET "${upstream_json}" package)
    string(JSON UPSTREAM_DEBIAN_VERSION GET "${upstream_json}" version)
    string(JSON UPSTREAM_VERSION GET "${upstream_json}" upstream_version)
    string(JSON UPSTREAM_SOURCE_FOLDER GET "${upstream_json}" source_folder)
    string(JSON upstream_count LENGTH "${upstream_json}" files)
    math(EXPR upstream_last "${upstream_count} - 1")
    set(UPSTREAM_FILES "")
    foreach(upstream_index RANGE ${upstream_last})
        string(JSON upstream_role GET "${upstream_json}" files ${upstream_index} role)
        string(JSON upstream_name GET "${upstream_json}" files ${upstream_index} name)
        string(JSON UPSTREAM_SIZE_${upstream_name} GET "${upstream_json}" files ${upstream_index} size)
        string(JSON UPSTREAM_SHA256_${upstream_name} GET "${upstream_json}" files ${upstream_index} sha256)
        set(UPSTREAM_FILE_${upstream_role} "${upstream_name}")
        list(APPEND UPSTREAM_FILES "${upstream_name}")
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

# Sets OUT to one line for each pinned file that FOLDER does not hold as pinned ("" where all are well).
function(upstream_folder_faults out folder)
    set(faults "")
    foreach(name IN LISTS UPSTREAM_FILES)
        upstream_file_fault(fault "${folder}" "${name}")
        if(fault)
            string(APPEND faults "  ${name} ${fault}\n")
        endif()
    endforeach()
    set(${out} "${faults}" PARENT_SCOPE)
endfunction()

# Downloads into a folder of this attempt alone and hands over checked files only, so that whatever
# ends this attempt, the next one starts clean.
function(upstream_download downloads)
    set(attempt "${downloads}/attempt")
    file(REMOVE_RECURSE "${attempt}")
    file(MAKE_DIRECTORY "${attempt}")
    message(STATUS "Downloading Debian's source package ${UPSTREAM_PACKAGE} ${UPSTREAM_DEBIAN_VERSION} (53 MB)")
    execute_process(
        COMMAND "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/fetch-debian-source" fetch
            "${UPSTREAM_PACKAGE}" "${UPSTREAM_DEBIAN_VERSION}" "${attempt}"
        RESULT_VARIABLE result ERROR_VARIABLE said)
    if(NOT result EQUAL 0)
        file(REMOVE_RECURSE "${attempt}")
        message(FATAL_ERROR "POV-Ray's source could not be downloaded.\n${said}\n"
            "Without a network: copy the files of the source package into a folder and configure with "
            "-DPOVRAY_TARBALL=FOLDER.")
    endif()
    upstream_folder_faults(faults "${attempt}")
    if(faults)
        file(REMOVE_RECURSE "${attempt}")
        message(FATAL_ERROR "The mirror's files are not those pinned in povray-src/upstream.json; nothing "
            "of them was kept:\n${faults}")
    endif()
    foreach(name IN LISTS UPSTREAM_FILES)
        file(RENAME "${attempt}/${name}" "${downloads}/${name}")
    endforeach()
    file(REMOVE_RECURSE "${attempt}")
endfunction()

# Sets OUT to a folder that holds all files of the package as pinned, fetching them where needed.
function(upstream_obtain out downloads)
    if(POVRAY_TARBALL)
        get_filename_component(folder "${POVRAY_TARBALL}" ABSOLUTE BASE_DIR "${CMAKE_BINARY_DIR}")
        if(EXISTS "${folder}" AND NOT IS_DIRECTORY "${folder}")
            get_filename_component(folder "${folder}" DIRECTORY)
        endif()
        upstream_folder_faults(faults "${folder}")
        if(faults)
            message(FATAL_ERROR "POVRAY_TARBALL: the folder ${folder} does not hold Debian's source package "
                "${UPSTREAM_PACKAGE} ${UPSTREAM_DEBIAN_VERSION} as pinned in povray-src/upstream.json:\n"
                "${faults}Give the folder with these files, or drop the option "
                "(-UPOVRAY_TARBALL) to download them.")
        endif()
        set(${out} "${folder}" PARENT_SCOPE)
        return()
    endif()
    upstream_folder_faults(faults "${downloads}")
    if(faults)
        foreach(name IN LISTS UPSTREAM_FILES)
            file(REMOVE "${downloads}/${name}")
        endforeach()
        upstream_download("${downloads}")
    endif()
    set(${out} "${downloads}" PARENT_SCOPE)
endfunction()

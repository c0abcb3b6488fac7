# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
#
# The pinned source: reads the pin, checks and finds the files in POVRAY_TARBALL, the download folder, or the network, in this order.
#
# Upstream's tarball and Debian's patches are pinned. Any packaging with these patches will do.
#
# upstream_read_pin sets in the caller's scope:
#   UPSTREAM_PACKAGE, UPSTREAM_VERSION, UPSTREAM_SOURCE_FOLDER
#   UPSTREAM_TARBALL, UPSTREAM_SIZE, UPSTREAM_SHA256    upstream's archive: its name, size and hash
#   UPSTREAM_PATCHES                 names of the packaging's patches, in the order in which they are applied
#   UPSTREAM_SHA256_<N>              hash of patch N of the list, counted from 0
include_guard()

# From povray-src/upstream.json, or the file PIN.
macro(upstream_read_pin pin)
    file(READ "${pin}" upstream_json)
    string(JSON UPSTREAM_PACKAGE GET "${upstream_json}" package)
    string(JSON UPSTREAM_VERSION GET "${upstream_json}" upstream_version)
    string(JSON UPSTREAM_SOURCE_FOLDER GET "${upstream_json}" source_folder)
    string(JSON UPSTREAM_TARBALL GET "${upstream_json}" tarball name)
    string(JSON UPSTREAM_SIZE GET "${upstream_json}" tarball size)
    string(JSON UPSTREAM_SHA256 GET "${upstream_json}" tarball sha256)
    string(JSON upstream_count LENGTH "${upstream_json}" packaging_patches)
    math(EXPR upstream_last "${upstream_count} - 1")
    set(UPSTREAM_PATCHES "")
    foreach(upstream_index RANGE ${upstream_last})
        string(JSON upstream_name GET "${upstream_json}" packaging_patches ${upstream_index} name)
        list(APPEND UPSTREAM_PATCHES "${upstream_name}")
        string(JSON UPSTREAM_SHA256_${upstream_index} GET "${upstream_json}" packaging_patches ${upstream_index} sha256)
    endforeach()
endmacro()

# Sets OUT to the tarball's faults in FOLDER, or "".
function(upstream_tarball_fault out folder)
    set(path "${folder}/${UPSTREAM_TARBALL}")
    set(fault "")
    if(NOT EXISTS "${path}")
        set(fault "is missing")
    else()
        file(SIZE "${path}" size)
        if(NOT size EQUAL UPSTREAM_SIZE)
            set(fault "has ${size} bytes, expected ${UPSTREAM_SIZE}")
        else()
            file(SHA256 "${path}" sha256)
            if(NOT sha256 STREQUAL UPSTREAM_SHA256)
                set(fault "has SHA-256 ${sha256}, expected ${UPSTREAM_SHA256}")
            endif()
        endif()
    endif()
    if(fault)
        set(fault "  ${UPSTREAM_TARBALL} ${fault}\n")
    endif()
    set(${out} "${fault}" PARENT_SCOPE)
endfunction()

# Unpacks ARCHIVE into FOLDER, made anew. Sets OUT to "", or to the fault; then there is no FOLDER.
function(upstream_unpack out archive folder)
    file(REMOVE_RECURSE "${folder}")
    file(MAKE_DIRECTORY "${folder}")
    execute_process(
        COMMAND tar --extract --no-same-owner --file "${archive}"
        WORKING_DIRECTORY "${folder}"
        RESULT_VARIABLE result ERROR_VARIABLE said)
    set(fault "")
    if(NOT result EQUAL 0)
        file(REMOVE_RECURSE "${folder}")
        get_filename_component(archive_name "${archive}" NAME)
        set(fault "  ${archive_name} could not be unpacked into ${folder} (is it damaged, or the disk full?): ${said}\n")
    endif()
    set(${out} "${fault}" PARENT_SCOPE)
endfunction()

# Unpacks a packaging into the new folder SCRATCH. Sets OUT to its faults, or "" if SCRATCH/debian holds every pinned patch.
function(upstream_packaging_faults out archive scratch)
    upstream_unpack(faults "${archive}" "${scratch}")
    if(faults)
        set(${out} "${faults}" PARENT_SCOPE)
        return()
    endif()
    get_filename_component(archive_name "${archive}" NAME)
    if(NOT EXISTS "${scratch}/debian/copyright")
        string(APPEND faults "  ${archive_name}: debian/copyright is missing\n")
    endif()
    set(number 0)
    foreach(name IN LISTS UPSTREAM_PATCHES)
        set(path "${scratch}/debian/patches/${name}")
        if(NOT EXISTS "${path}")
            string(APPEND faults "  ${archive_name}: debian/patches/${name} is missing\n")
        else()
            file(SHA256 "${path}" sha256)
            if(NOT sha256 STREQUAL UPSTREAM_SHA256_${number})
                string(APPEND faults "  ${archive_name}: debian/patches/${name} has SHA-256 ${sha256}, "
                    "expected ${UPSTREAM_SHA256_${number}}\n")
            endif()
        endif()
        math(EXPR number "${number} + 1")
    endforeach()
    set(${out} "${faults}" PARENT_SCOPE)
endfunction()

# Looks in FOLDER for the tarball and the newest packaging with every pinned patch. Sets PACKAGING, unpacked in SCRATCH, and FAULTS to "";
# or FAULTS to a text.
function(upstream_find packaging faults folder scratch)
    upstream_tarball_fault(lacking "${folder}")
    file(GLOB archives "${folder}/${UPSTREAM_PACKAGE}_${UPSTREAM_VERSION}-*.debian.tar.*")
    list(FILTER archives EXCLUDE REGEX "\\.(asc|sig)$")
    list(SORT archives COMPARE NATURAL ORDER DESCENDING)
    set(lacking_packaging "")
    if(NOT archives)
        set(lacking_packaging "  ${UPSTREAM_PACKAGE}_${UPSTREAM_VERSION}-REVISION.debian.tar.xz is missing, whatever its REVISION\n")
    endif()
    set(chosen "")
    foreach(archive IN LISTS archives)
        upstream_packaging_faults(lacking_here "${archive}" "${scratch}")
        if(NOT lacking_here)
            set(lacking_packaging "")
            set(chosen "${archive}")
            break()
        endif()
        string(APPEND lacking_packaging "${lacking_here}")
    endforeach()
    set(${packaging} "${chosen}" PARENT_SCOPE)
    set(${faults} "${lacking}${lacking_packaging}" PARENT_SCOPE)
endfunction()

# Sets OUT to the advice after each message about a wrong source.
function(upstream_advice out)
    string(CONCAT text "Two files are needed, ${UPSTREAM_TARBALL} and a packaging whose patches are those pinned in "
        "povray-src/upstream.json. The mirrors of Debian have both in pool/main/p/${UPSTREAM_PACKAGE}. Put them into a folder and "
        "call ./render --source FOLDER (cmake: -DPOVRAY_TARBALL=FOLDER). docs/patching.md, \"Take another packaging\", tells "
        "how to pin a packaging whose patches differ.")
    set(${out} "${text}" PARENT_SCOPE)
endfunction()

# Hands over checked files only, so that the next attempt starts clean. Sets PACKAGING, unpacked in SCRATCH.
function(upstream_download packaging downloads scratch)
    set(attempt "${downloads}/attempt")
    file(REMOVE_RECURSE "${attempt}")
    file(MAKE_DIRECTORY "${attempt}")
    upstream_advice(advice)
    message(STATUS "Downloading the source package ${UPSTREAM_PACKAGE} ${UPSTREAM_VERSION} (53 MB)")
    execute_process(
        COMMAND "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/fetch-debian-source" fetch
            "${UPSTREAM_PACKAGE}" "${attempt}" "${UPSTREAM_VERSION}"
        RESULT_VARIABLE result ERROR_VARIABLE said)
    if(NOT result EQUAL 0)
        file(REMOVE_RECURSE "${attempt}")
        message(FATAL_ERROR "POV-Ray's source could not be downloaded.\n${said}\nBy hand: ${advice}")
    endif()
    upstream_find(found faults "${attempt}" "${scratch}")
    if(faults)
        file(REMOVE_RECURSE "${attempt}")
        message(FATAL_ERROR "The mirror's files are not those pinned in povray-src/upstream.json; nothing "
            "of them was kept:\n${faults}${advice}")
    endif()
    get_filename_component(name "${found}" NAME)
    file(RENAME "${attempt}/${UPSTREAM_TARBALL}" "${downloads}/${UPSTREAM_TARBALL}")
    file(RENAME "${found}" "${downloads}/${name}")
    file(REMOVE_RECURSE "${attempt}")
    set(${packaging} "${downloads}/${name}" PARENT_SCOPE)
endfunction()

# Sets TARBALL to upstream's pinned archive, fetched where needed; a packaging with the pinned patches is unpacked in SCRATCH/debian.
function(upstream_obtain tarball downloads scratch)
    if(POVRAY_TARBALL)
        get_filename_component(folder "${POVRAY_TARBALL}" ABSOLUTE BASE_DIR "${CMAKE_BINARY_DIR}")
        if(EXISTS "${folder}" AND NOT IS_DIRECTORY "${folder}")
            get_filename_component(folder "${folder}" DIRECTORY)
        endif()
        upstream_find(packaging faults "${folder}" "${scratch}")
        if(faults)
            upstream_advice(advice)
            message(FATAL_ERROR "POVRAY_TARBALL: the folder ${folder} does not hold the source package "
                "${UPSTREAM_PACKAGE} ${UPSTREAM_VERSION} as pinned in povray-src/upstream.json:\n"
                "${faults}${advice}\nTo download them instead, drop the option (-UPOVRAY_TARBALL).")
        endif()
    else()
        set(folder "${downloads}")
        upstream_find(packaging faults "${folder}" "${scratch}")
        if(faults)
            file(REMOVE "${folder}/${UPSTREAM_TARBALL}")
            upstream_download(packaging "${folder}" "${scratch}")
        endif()
    endif()
    get_filename_component(name "${packaging}" NAME)
    message(STATUS "Upstream's ${UPSTREAM_TARBALL} with the patches of ${name}")
    set(${tarball} "${folder}/${UPSTREAM_TARBALL}" PARENT_SCOPE)
endfunction()

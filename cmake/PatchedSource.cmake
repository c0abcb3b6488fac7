# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
#
# The patched source tree: unpacks the pinned archive, applies Debian's pinned patches and our series without fuzz, and updates
# build/upstream/povray file by file, so that a changed patch recompiles only its files.
#
# Each run starts from the archives: no tree is patched twice.
include_guard()
include("${CMAKE_CURRENT_LIST_DIR}/Upstream.cmake")

set(PATCHED_SOURCE_PARTS source vfe unix distribution/include distribution/ini LICENSE changes.txt)

# Sets OUT to the patches of SERIES, without the folders ARGN; "#" starts a comment.
function(patched_source_read_series out series)
    file(STRINGS "${series}" lines)
    set(names "")
    foreach(line IN LISTS lines)
        string(REGEX REPLACE "#.*" "" line "${line}")
        string(STRIP "${line}" line)
        get_filename_component(folder "${line}" DIRECTORY)
        list(FIND ARGN "${folder}" left_out)
        if(NOT line STREQUAL "" AND left_out EQUAL -1)
            list(APPEND names "${line}")
        endif()
    endforeach()
    set(${out} "${names}" PARENT_SCOPE)
endfunction()

# Applies the patches ARGN of FOLDER to TREE, and appends their names to the file RECORD.
function(patched_source_apply tree folder record)
    foreach(name IN LISTS ARGN)
        if(NOT EXISTS "${folder}/${name}")
            message(FATAL_ERROR "${folder}/series lists ${name}, which does not exist.")
        endif()
        execute_process(
            COMMAND patch -p1 -F0 --forward --batch --no-backup-if-mismatch --reject-file=-
                --input "${folder}/${name}"
            WORKING_DIRECTORY "${tree}"
            RESULT_VARIABLE result OUTPUT_VARIABLE said ERROR_VARIABLE said)
        if(NOT result EQUAL 0)
            message(FATAL_ERROR "The patch ${folder}/${name} does not apply to the source of POV-Ray "
                "${UPSTREAM_VERSION}:\n${said}\ndocs/patching.md tells how to mend a patch.")
        endif()
        file(APPEND "${record}" "${name}\n")
    endforeach()
endfunction()

# Makes parts of TREE equal to FRESH's; only different files are written. They are dated now, never as in the archive: a file of 2018 would
# be older than its object.
function(patched_source_update tree fresh)
    foreach(part IN LISTS PATCHED_SOURCE_PARTS)
        foreach(side IN ITEMS fresh tree)
            set(${side}_files "")
            if(IS_DIRECTORY "${${side}}/${part}")
                file(GLOB_RECURSE ${side}_files LIST_DIRECTORIES false RELATIVE "${${side}}" "${${side}}/${part}/*")
            elseif(EXISTS "${${side}}/${part}")
                set(${side}_files "${part}")
            endif()
        endforeach()
        foreach(name IN LISTS tree_files)
            if(NOT EXISTS "${fresh}/${name}")
                file(REMOVE "${tree}/${name}")
            endif()
        endforeach()
        foreach(name IN LISTS fresh_files)
            get_filename_component(folder "${tree}/${name}" DIRECTORY)
            file(MAKE_DIRECTORY "${folder}")
            file(COPY_FILE "${fresh}/${name}" "${tree}/${name}" RESULT result ONLY_IF_DIFFERENT)
            if(result)
                message(FATAL_ERROR "${tree}/${name} could not be written (is the disk full?): ${result}")
            endif()
        endforeach()
    endforeach()
endfunction()

# Sets OUT to a hash of all that the patched tree depends on, without patches of the folders ARGN.
function(patched_source_key out pin series_folder use_patches)
    file(SHA256 "${pin}" key)
    file(SHA256 "${CMAKE_CURRENT_FUNCTION_LIST_FILE}" recipe)
    string(APPEND key "${recipe}")
    if(use_patches)
        patched_source_series_hash(series "${series_folder}" ${ARGN})
        string(APPEND key "${series}")
    endif()
    string(SHA256 key "${key}")
    set(${out} "${key}" PARENT_SCOPE)
endfunction()

# Sets OUT to a hash of the series, without the folders ARGN.
function(patched_source_series_hash out series_folder)
    patched_source_read_series(names "${series_folder}/series" ${ARGN})
    set(text "")
    foreach(name IN LISTS names)
        set(hash missing)
        if(EXISTS "${series_folder}/${name}")
            file(SHA256 "${series_folder}/${name}" hash)
        endif()
        string(APPEND text "${name} ${hash}\n")
    endforeach()
    string(SHA256 hash "${text}")
    set(${out} "${hash}" PARENT_SCOPE)
endfunction()

# Updates WORK/povray, without patches of the folders ARGN. WORK/applied-patches lists the patches, WORK/debian-copyright the licences,
# WORK/key the inputs; the key is removed first and written last, so that an interrupted run counts as none.
function(patched_source_prepare work downloads pin series_folder use_patches)
    upstream_read_pin("${pin}")
    patched_source_key(key "${pin}" "${series_folder}" "${use_patches}" ${ARGN})
    set(old_key "")
    if(EXISTS "${work}/key")
        file(READ "${work}/key" old_key)
    endif()
    if(old_key STREQUAL key)
        return()
    endif()
    message(STATUS "Preparing the source of POV-Ray ${UPSTREAM_VERSION}")
    set(packaging "${work}/packaging")
    upstream_obtain(tarball "${downloads}" "${packaging}")
    file(REMOVE "${work}/key")
    set(fresh "${work}/fresh")
    upstream_unpack(fault "${tarball}" "${fresh}")
    if(fault)
        message(FATAL_ERROR "POV-Ray's source:\n${fault}")
    endif()
    set(record "${fresh}/applied-patches")
    set(tree "${fresh}/${UPSTREAM_SOURCE_FOLDER}")
    patched_source_apply("${tree}" "${packaging}/debian/patches" "${record}" ${UPSTREAM_PATCHES})
    if(use_patches)
        patched_source_read_series(series "${series_folder}/series" ${ARGN})
        patched_source_apply("${tree}" "${series_folder}" "${record}" ${series})
    endif()
    patched_source_update("${work}/povray" "${tree}")
    file(RENAME "${record}" "${work}/applied-patches")
    file(COPY_FILE "${packaging}/debian/copyright" "${work}/debian-copyright")
    file(REMOVE_RECURSE "${fresh}" "${packaging}")
    file(WRITE "${work}/key" "${key}")
endfunction()

# A changed pin, series or patch configures and prepares again.
function(patched_source_configure_depends pin series_folder)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${pin}" "${series_folder}/series")
    patched_source_read_series(names "${series_folder}/series")
    foreach(name IN LISTS names)
        set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${series_folder}/${name}")
    endforeach()
endfunction()

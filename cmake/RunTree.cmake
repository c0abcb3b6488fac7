# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
#
# Files beside the program: include files with fonts, ini files, I/O permissions.
#
# The program in <prefix>/bin finds <prefix>/share/povray-3.7 and <prefix>/etc/povray/3.7 (install_folders.cpp). The build folder is a
# prefix, too.
include_guard()

set(data_folder share/povray-3.7)
set(conf_folder etc/povray/3.7)
set(scenes "${CMAKE_SOURCE_DIR}/scenes")

# Sets OUT to povray.ini: upstream's, with Library_Path lines for FOLDERS.
function(run_tree_ini out)
    file(READ "${POVRAY_SOURCE}/distribution/ini/povray.ini" text)
    string(APPEND text "\n;; Search path for include and ini files that are not in the current folder.\n")
    foreach(folder IN LISTS ARGN)
        string(APPEND text "Library_Path=\"${folder}\"\n")
    endforeach()
    string(APPEND text "\nOutput_to_File=true\nOutput_File_Type=N8    ;; PNG, 8 bits per colour\n")
    set(${out} "${text}" PARENT_SCOPE)
endfunction()

# run_tree_conf(OUT PROTECTED...): povray.conf: upstream's, without permissions for foreign folders. Scenes never write in PROTECTED.
function(run_tree_conf out)
    file(READ "${POVRAY_SOURCE}/unix/povray.conf" text)
    string(FIND "${text}" "\nread* = " first)
    string(SUBSTRING "${text}" 0 ${first} text)
    list(JOIN ARGN "\npath=" protected)
    string(APPEND text "\nread* = %INSTALLDIR%/include\nread* = /usr/share/fonts\nread* = .\nread+write = .
; Beside these a scene reads its own folder and those of Library_Path (+L), and reads and writes the folder of its picture.
; The option --unrestricted permits all files.\n
; The program's own folders, where no scene writes.
[Protected Folder]\npath=${protected}\n")
    set(${out} "${text}" PARENT_SCOPE)
endfunction()

# build folder: links to the patched tree
file(MAKE_DIRECTORY "${CMAKE_BINARY_DIR}/${data_folder}")
foreach(part IN ITEMS include ini)
    file(CREATE_LINK "${POVRAY_SOURCE}/distribution/${part}" "${CMAKE_BINARY_DIR}/${data_folder}/${part}" SYMBOLIC)
endforeach()
set(built_data "${CMAKE_BINARY_DIR}/${data_folder}")
run_tree_ini(ini "${built_data}" "${built_data}/ini" "${built_data}/include" "${scenes}/include")
run_tree_conf(conf "${CMAKE_SOURCE_DIR}" "${CMAKE_BINARY_DIR}")
# unchanged files keep their time
file(CONFIGURE OUTPUT "${CMAKE_BINARY_DIR}/${conf_folder}/povray.ini" CONTENT "${ini}" @ONLY)
file(CONFIGURE OUTPUT "${CMAKE_BINARY_DIR}/${conf_folder}/povray.conf" CONTENT "${conf}" @ONLY)

# Only installing shows the prefix that povray.ini names.
run_tree_ini(ini "INSTALL_DATA" "INSTALL_DATA/ini" "INSTALL_DATA/include")
run_tree_conf(conf "%INSTALLDIR%/scenes")
set(staged "${CMAKE_BINARY_DIR}/install")
file(CONFIGURE OUTPUT "${staged}/povray.ini" CONTENT "${ini}" @ONLY)
file(CONFIGURE OUTPUT "${staged}/povray.conf" CONTENT "${conf}" @ONLY)

install(TARGETS povray RUNTIME DESTINATION bin)
install(DIRECTORY "${POVRAY_SOURCE}/distribution/include" "${POVRAY_SOURCE}/distribution/ini"
    DESTINATION ${data_folder})
install(DIRECTORY "${scenes}/include/" DESTINATION ${data_folder}/include OPTIONAL)
foreach(part IN ITEMS gallery tutorial)
    install(DIRECTORY "${scenes}/${part}" DESTINATION ${data_folder}/scenes OPTIONAL)
endforeach()
install(FILES "${staged}/povray.conf" DESTINATION ${conf_folder})
install(CODE "
    file(READ \"${staged}/povray.ini\" ini)
    string(REPLACE INSTALL_DATA \"\${CMAKE_INSTALL_PREFIX}/${data_folder}\" ini \"\${ini}\")
    set(target \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${conf_folder}/povray.ini\")
    message(STATUS \"Installing: \${target}\")
    file(WRITE \"\${target}\" \"\${ini}\")")
install(FILES "${POVRAY_SOURCE}/unix/povray.1" DESTINATION share/man/man1)
install(FILES "${CMAKE_SOURCE_DIR}/docs/man/povray-tilt-lens.7" DESTINATION share/man/man7)

# run_tree_install_pages(DOC DATA ...): pages in the folder DOC, and scenes as links to DATA's, relative to the prefix. Further arguments
# are install()'s.
function(run_tree_install_pages doc data)
    install(FILES "${CMAKE_SOURCE_DIR}/README.md" DESTINATION ${doc} ${ARGN})
    install(DIRECTORY "${CMAKE_SOURCE_DIR}/docs" "${CMAKE_SOURCE_DIR}/editors" DESTINATION ${doc} ${ARGN}
        PATTERN figures EXCLUDE
        PATTERN man EXCLUDE)
    foreach(link IN ITEMS include=include gallery=scenes/gallery tutorial=scenes/tutorial)
        string(REGEX MATCH "^(.*)=(.*)$" whole "${link}")
        file(RELATIVE_PATH target "/${doc}/scenes" "/${data}/${CMAKE_MATCH_2}")
        install(CODE "
            set(scenes \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${doc}/scenes\")
            file(MAKE_DIRECTORY \"\${scenes}\")
            file(CREATE_LINK \"${target}\" \"\${scenes}/${CMAKE_MATCH_1}\" SYMBOLIC)" ${ARGN})
    endforeach()
endfunction()

set(doc_folder share/doc/povray-tilt-lens)
install(FILES "${CMAKE_SOURCE_DIR}/LICENSE" DESTINATION ${doc_folder})
run_tree_install_pages(${doc_folder} ${data_folder})

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
#
# The Debian package ("cmake --build build --target package") and the source archive ("--target package_source").
#
# It installs beside Debian's povray, in a prefix of its own, because the program finds its files from its own place (RunTree.cmake).
#
#   /usr/lib/povray-tilt-lens/bin/povray          the program; /usr/bin/povray-tilt-lens is a link to it
#   /usr/lib/povray-tilt-lens/share/povray-3.7    a link to /usr/share/povray-tilt-lens: include and ini files, scenes
#   /usr/lib/povray-tilt-lens/etc/povray/3.7      a link to /etc/povray-tilt-lens: povray.ini, povray.conf
include_guard()

set(package_files "${CMAKE_BINARY_DIR}/package")
set(package_templates "${CMAKE_CURRENT_LIST_DIR}/package")
set(package_prefix usr/lib/povray-tilt-lens)
set(package_data usr/share/povray-tilt-lens)
set(package_conf etc/povray-tilt-lens)
set(package_doc usr/share/doc/povray-tilt-lens)
set(for_package COMPONENT debian EXCLUDE_FROM_ALL)      # "cmake --install" leaves these files out

run_tree_ini(ini "/${package_data}" "/${package_data}/ini" "/${package_data}/include")
run_tree_conf(conf "read* = /${package_data}" "read* = /${package_conf}")
file(CONFIGURE OUTPUT "${package_files}/povray.ini" CONTENT "${ini}" @ONLY)
file(CONFIGURE OUTPUT "${package_files}/povray.conf" CONTENT "${conf}" @ONLY)
install(TARGETS povray RUNTIME DESTINATION ${package_prefix}/bin ${for_package})
install(DIRECTORY "${POVRAY_SOURCE}/distribution/include" "${POVRAY_SOURCE}/distribution/ini" DESTINATION ${package_data}
    FILE_PERMISSIONS OWNER_READ OWNER_WRITE GROUP_READ WORLD_READ ${for_package})
install(DIRECTORY "${scenes}/include/" DESTINATION ${package_data}/include ${for_package})
install(DIRECTORY "${scenes}/gallery" "${scenes}/tutorial" DESTINATION ${package_data}/scenes ${for_package}
    PATTERN make_pictures EXCLUDE)
install(FILES "${package_files}/povray.ini" "${package_files}/povray.conf" DESTINATION ${package_conf} ${for_package})
install(CODE "
    set(root \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}\")
    file(MAKE_DIRECTORY \"\${root}/usr/bin\" \"\${root}/${package_prefix}/share\" \"\${root}/${package_prefix}/etc/povray\")
    file(CREATE_LINK ../lib/povray-tilt-lens/bin/povray \"\${root}/usr/bin/povray-tilt-lens\" SYMBOLIC)
    file(CREATE_LINK ../../../share/povray-tilt-lens \"\${root}/${package_prefix}/share/povray-3.7\" SYMBOLIC)
    file(CREATE_LINK /${package_conf} \"\${root}/${package_prefix}/etc/povray/3.7\" SYMBOLIC)" ${for_package})

# package_gzip(NAME TEXT): TEXT in ${package_files}/NAME.gz, without a date.
function(package_gzip name text)
    file(WRITE "${package_files}/${name}" "${text}")
    execute_process(COMMAND gzip -9nf "${package_files}/${name}" COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(READ "${POVRAY_SOURCE}/unix/povray.1" page)
string(REGEX REPLACE "\\.TH POV-Ray 1" ".TH POVRAY-TILT-LENS 1" page "${page}")
string(REGEX REPLACE "povray( \\\\- POV)" "povray-tilt-lens\\1" page "${page}")
string(REPLACE "\\fBpovray\\fP" "\\fBpovray\\-tilt\\-lens\\fP" page "${page}")
string(REPLACE "PREFIX/etc/povray/3.7" "/${package_conf}" page "${page}")
string(REPLACE "PREFIX/share/povray\\-3.7" "/${package_data}" page "${page}")
string(REPLACE "PREFIX/share/doc/povray-3.7" "/usr/share/doc/povray\\-tilt\\-lens" page "${page}")
string(REGEX REPLACE ", where PREFIX is [^.]*\\." "." page "${page}")
string(REGEX REPLACE " The PREFIX directory can[^.]*\\." "" page "${page}")
package_gzip(povray-tilt-lens.1 "${page}")
file(READ "${CMAKE_SOURCE_DIR}/docs/man/povray-tilt-lens.7" page)
string(REPLACE ".BR povray (1)" ".BR povray-tilt-lens (1)" page "${page}")
string(REPLACE ".IR PREFIX /share/povray-3.7/scenes" ".I /${package_data}/scenes" page "${page}")
string(REPLACE ".IR PREFIX /share" ".I /usr/share" page "${page}")
package_gzip(povray-tilt-lens.7 "${page}")
foreach(section IN ITEMS 1 7)
    install(FILES "${package_files}/povray-tilt-lens.${section}.gz" DESTINATION usr/share/man/man${section} ${for_package})
endforeach()

install(FILES "${CMAKE_SOURCE_DIR}/editors/vim/after/syntax/pov.vim" DESTINATION usr/share/vim/vimfiles/after/syntax
    ${for_package})
install(FILES "${CMAKE_SOURCE_DIR}/editors/bash/povray-tilt-lens.bash" DESTINATION usr/share/bash-completion/completions
    RENAME povray-tilt-lens ${for_package})

# The licences ask for the source. Debian's list of upstream's licences holds their text.
run_tree_install_pages(${package_doc} ${package_data} ${for_package})
file(READ "${CMAKE_BINARY_DIR}/upstream/debian-copyright" copyright)
file(READ "${package_templates}/copyright" own_copyright)
file(WRITE "${package_files}/copyright" "${copyright}\n${own_copyright}")
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
package_gzip(changelog "povray-tilt-lens (${PROJECT_VERSION}) unstable; urgency=medium

  * POV-Ray ${UPSTREAM_VERSION} as ${TILT_LENS_BUILD_NAME}.

 -- povray-tilt-lens <noreply@example.org>  ${date}
")
configure_file("${package_templates}/SOURCE.in" "${package_files}/SOURCE" @ONLY)
install(FILES "${package_files}/copyright" "${package_files}/SOURCE" "${package_files}/changelog.gz" DESTINATION ${package_doc} ${for_package})
# linked libraries' licences ask to be named
install(FILES /usr/share/doc/libjemalloc-dev/copyright DESTINATION ${package_doc} RENAME copyright.jemalloc ${for_package})
install(CODE "
    set(doc \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${package_doc}\")
    file(CREATE_LINK copyright \"\${doc}/LICENSE\" SYMBOLIC)
    execute_process(COMMAND \"${CMAKE_CPACK_COMMAND}\" --config \"${CMAKE_BINARY_DIR}/CPackSourceConfig.cmake\"
            -B \"${package_files}/source\"
        OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
    file(COPY_FILE \"${package_files}/source/povray-tilt-lens-${PROJECT_VERSION}.tar.xz\"
        \"\${doc}/povray-tilt-lens-${PROJECT_VERSION}.tar.xz\")"
    ${for_package})

set(CPACK_PACKAGE_NAME povray-tilt-lens)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_FILE_NAME "povray-tilt-lens-${PROJECT_VERSION}")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "ray tracer POV-Ray with a tilt-shift camera (unofficial version)")
file(READ "${package_templates}/description" CPACK_DEBIAN_DEBIAN_DESCRIPTION)
set(CPACK_SOURCE_PACKAGE_FILE_NAME "povray-tilt-lens-${PROJECT_VERSION}")
set(CPACK_SOURCE_GENERATOR TXZ)
set(CPACK_SOURCE_IGNORE_FILES "^${CMAKE_SOURCE_DIR}/build/" "^${CMAKE_BINARY_DIR}/" "/[.]git/" "/__pycache__/"
    "^${CMAKE_SOURCE_DIR}/[^/]*[.]png$" "[.]pov-state$")
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_GENERATOR DEB)
set(CPACK_COMPONENTS_ALL debian)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_PACKAGING_INSTALL_PREFIX "/")
set(CPACK_STRIP_FILES ON)
set(CPACK_PROJECT_CONFIG_FILE "${package_templates}/cpack.cmake")
set(CPACK_DEBIAN_DEBIAN_PACKAGE_NAME povray-tilt-lens)
set(CPACK_DEBIAN_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# loaded with the first window, unseen by dpkg-shlibdeps
set(CPACK_DEBIAN_DEBIAN_PACKAGE_RECOMMENDS libsdl1.2debian)
set(CPACK_DEBIAN_DEBIAN_PACKAGE_CONTROL_EXTRA "${package_templates}/conffiles")
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
include(CPack)

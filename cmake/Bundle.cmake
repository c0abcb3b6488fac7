# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
#
# An archive for any Linux with this system's glibc or a newer one: "cmake --build build --target bundle". Its folder is laid out like this
# repository, for ./render and links, and like an installation, for the program:
#
#   render, cmake/setup.sh            the command, with a set-up that has nothing to do
#   bin/povray, lib/                  the program, and all libraries that it loads but glibc's
#   share/povray-3.7, etc/povray/3.7  include and ini files, fonts, scenes, settings
#   README.md, docs/, editors/        the pages
#   LICENSE, SOURCE, licences/        licences of all that is in it, and where its source is
include_guard()

set(bundle_name "povray-tilt-lens-${PROJECT_VERSION}-linux-${CMAKE_SYSTEM_PROCESSOR}")
set(bundle_files "${CMAKE_BINARY_DIR}/bundle")
set(for_bundle COMPONENT bundle EXCLUDE_FROM_ALL)

# DT_RPATH, not DT_RUNPATH, also holds for libraries of libraries.
add_povray_program(povray_bundled)
set_target_properties(povray_bundled PROPERTIES EXCLUDE_FROM_ALL $<NOT:$<BOOL:${TILT_LENS_TESTS}>> OUTPUT_NAME povray
    RUNTIME_OUTPUT_DIRECTORY "${bundle_files}/bin" BUILD_WITH_INSTALL_RPATH ON INSTALL_RPATH "$ORIGIN/../lib")
target_link_options(povray_bundled PRIVATE -Wl,--disable-new-dtags)

# No folders: the program adds its own.
run_tree_ini(ini)
run_tree_conf(conf "%INSTALLDIR%/../..")
file(CONFIGURE OUTPUT "${bundle_files}/povray.ini" CONTENT "${ini}" @ONLY)
file(CONFIGURE OUTPUT "${bundle_files}/povray.conf" CONTENT "${conf}" @ONLY)
install(TARGETS povray_bundled RUNTIME DESTINATION bin OPTIONAL ${for_bundle})
install(DIRECTORY "${POVRAY_SOURCE}/distribution/include" "${POVRAY_SOURCE}/distribution/ini" DESTINATION ${data_folder} ${for_bundle})
install(DIRECTORY "${scenes}/include/" DESTINATION ${data_folder}/include ${for_bundle})
install(DIRECTORY "${scenes}/gallery" "${scenes}/tutorial" DESTINATION ${data_folder}/scenes ${for_bundle} PATTERN make_pictures EXCLUDE)
install(FILES "${bundle_files}/povray.ini" "${bundle_files}/povray.conf" DESTINATION ${conf_folder} ${for_bundle})
install(PROGRAMS "${CMAKE_SOURCE_DIR}/render" DESTINATION . ${for_bundle})
install(FILES "${CMAKE_CURRENT_LIST_DIR}/bundle/setup.sh" DESTINATION cmake ${for_bundle})
install(FILES "${CMAKE_SOURCE_DIR}/LICENSE" DESTINATION . ${for_bundle})
install(FILES "${POVRAY_SOURCE}/unix/povray.1" DESTINATION share/man/man1 ${for_bundle})
install(FILES "${CMAKE_SOURCE_DIR}/docs/man/povray-tilt-lens.7" DESTINATION share/man/man7 ${for_bundle})
run_tree_install_pages(. ${data_folder} ${for_bundle})

configure_file("${package_templates}/SOURCE.in" "${bundle_files}/SOURCE" @ONLY)
set(make_bundle "${CMAKE_COMMAND}" "-DNAME=${bundle_name}" "-DBUILD=${CMAKE_BINARY_DIR}" "-DVERSION=${PROJECT_VERSION}"
    "-DSOURCE_CONFIG=${CMAKE_BINARY_DIR}/CPackSourceConfig.cmake" "-DCPACK=${CMAKE_CPACK_COMMAND}" "-DOBJDUMP=${CMAKE_OBJDUMP}"
    "-DJEMALLOC=${JEMALLOC_LIBRARY}")
add_custom_target(bundle
    COMMAND ${make_bundle} "-DWORK=${bundle_files}" -P "${CMAKE_CURRENT_LIST_DIR}/bundle/make.cmake"
    COMMAND ${make_bundle} "-DWORK=${bundle_files}" -P "${CMAKE_CURRENT_LIST_DIR}/bundle/pack.cmake"
    COMMENT "Making ${bundle_name}.tar.xz" VERBATIM)
add_dependencies(bundle povray_bundled)

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
#
# Puts this project's source, which the licence asks for, into WORK/NAME and makes BUILD/NAME.tar.xz, for Bundle.cmake.
set(source "povray-tilt-lens-${VERSION}.tar.xz")
execute_process(COMMAND "${CPACK}" --config "${SOURCE_CONFIG}" -B "${WORK}/source" OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
file(COPY_FILE "${WORK}/source/${source}" "${WORK}/${NAME}/${source}")
execute_process(COMMAND tar --create --xz --sort=name --owner=0 --group=0 --numeric-owner --mode=u=rwX,go=rX
    --file "${BUILD}/${NAME}.tar.xz" --directory "${WORK}" "${NAME}" COMMAND_ERROR_IS_FATAL ANY)
message(STATUS "The bundle: ${BUILD}/${NAME}.tar.xz")

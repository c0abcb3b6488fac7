# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
#
# Read by CPack: the package's owner, in the way of Debian's tools.
if(CPACK_GENERATOR STREQUAL "DEB")
    set(name "$ENV{DEBFULLNAME}")
    set(mail "$ENV{DEBEMAIL}")
    if(NOT name OR NOT mail)
        message(FATAL_ERROR "A Debian package names who made it. Set the environment variables DEBFULLNAME (your name) "
            "and DEBEMAIL (your mail address), and make the package again.")
    endif()
    set(CPACK_DEBIAN_PACKAGE_MAINTAINER "${name} <${mail}>")
    foreach(tool IN ITEMS dpkg-shlibdeps file)
        find_program(package_${tool} ${tool})
        if(NOT package_${tool})
            message(FATAL_ERROR "${tool} is missing, which the package's dependencies are found with. Install the Debian "
                "packages dpkg-dev and file.")
        endif()
    endforeach()
endif()

# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
#
# The one set-up step of ./render, ./batch, ./focus and ./check, to be sourced: installs missing packages, configures, builds.
#
#   setup render|batch|focus|check  leaves the program (check: and the tests) built in $repository/build
#
# All it prints goes to standard error, so that a picture may go to standard output. With nothing to do it
# asks dpkg and ninja, needs no network and stays well under a second.

repository=$(dirname -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")")
build=$repository/build

say() { printf '%s\n' "$@" >&2; }
die() { printf '%s: ' "${0##*/}" >&2; say "$@"; exit 1; }

# quoted TEXT: in quotation marks, which povray needs around a name that holds spaces.
quoted()
{
    case $1 in
        *\"*) printf "'%s'" "$1" ;;
        *)    printf '"%s"' "$1" ;;
    esac
}

# packages_of render|batch|focus|check: the names in cmake/debian-packages that this command needs.
packages_of()
{
    awk -v group="$1" '!/^#/ && NF == 2 && ($1 == "render" || $1 == group || group == "check") { print $2 }' \
        "$repository/cmake/debian-packages"
}

missing_packages()
{
    local -a wanted
    mapfile -t wanted < <(packages_of "$1")
    local installed
    installed=$(dpkg-query --show --showformat='${db:Status-Status} ${Package}\n' "${wanted[@]}" 2>/dev/null \
        | awk '$1 == "installed" { print $2 }')
    local package
    for package in "${wanted[@]}"; do
        grep -qxF -- "$package" <<< "$installed" || printf '%s\n' "$package"
    done
}

install_packages()
{
    local -a missing as_root=()
    mapfile -t missing < <(missing_packages "$1")
    [ ${#missing[@]} -gt 0 ] || return 0
    local by_hand="sudo apt-get install --no-install-recommends ${missing[*]}"
    if [ "$(id -u)" -ne 0 ]; then
        # Without a terminal sudo cannot ask for a password; it must not wait for one.
        if command -v sudo >/dev/null && { [ -t 0 ] || sudo -n true 2>/dev/null; }; then
            as_root=(sudo)
        else
            die "these Debian packages are missing, and neither root nor sudo is at hand to install them." \
                "Have somebody who may run:" "  $by_hand"
        fi
    fi
    say "Installing Debian packages: ${missing[*]}"
    # A failed update need not matter: the lists at hand may do.
    "${as_root[@]}" apt-get -q update >&2 || say "(the package lists could not be renewed; trying with those at hand)"
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
        apt-get -q --yes --no-install-recommends install "${missing[@]}" >&2 \
        || die "the packages could not be installed (see above; is there a network?). By hand:" "  $by_hand"
}

# A build folder remembers where it lies. After a move all of it but the downloads is made anew.
forget_moved_build()
{
    local cache=$build/CMakeCache.txt
    [ -f "$cache" ] || return 0
    grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$repository" "$cache" \
        && grep -qxF "CMAKE_CACHEFILE_DIR:INTERNAL=$build" "$cache" && return 0
    say "The repository has moved: building anew."
    find "$build" -mindepth 1 -maxdepth 1 ! -name downloads ! -name setup.lock -exec rm -rf {} +
}

# configure render|batch|focus|check: where there is no finished configuration, or the tests are not yet part of it.
# Once on, the tests stay on: the two commands must not turn each other's configuration back.
configure()
{
    local -a options=()
    if [ "$1" = check ] && ! grep -qx 'TILT_LENS_TESTS:BOOL=ON' "$build/CMakeCache.txt" 2>/dev/null; then
        options=(-DTILT_LENS_TESTS=ON)
    elif [ -f "$build/build.ninja" ]; then
        return 0
    fi
    say "Configuring (the first time this downloads POV-Ray's source)"
    ( cd "$repository" && cmake --preset release "${options[@]}" ) >&2 \
        || die "the configuration failed (see above)."
}

# Passes on what ninja says, without its remarks on having nothing to do; on a terminal its progress
# lines overwrite each other.
show_progress()
{
    local line columns=0
    if [ -t 2 ]; then
        columns=$(tput cols 2>/dev/null) || columns=80
    fi
    while IFS= read -r line; do
        case $line in
            'ninja: no work to do.'|*'Re-checking globbed directories...'|'ninja: Entering directory'*) ;;
            '['[0-9]*) if [ "$columns" -gt 0 ]; then
                           printf '\r\033[K%s' "${line:0:columns - 1}" >&2
                       else
                           say "$line"
                       fi ;;
            *)         say "$line" ;;
        esac
    done
    [ "$columns" -eq 0 ] || printf '\r\033[K' >&2
}

setup()
{
    local target=povray
    [ "$1" != check ] || target=all
    command -v dpkg-query apt-get >/dev/null || die "this set-up is for Debian: dpkg and apt-get are missing. docs/building.md says how to build elsewhere."
    install_packages "$1"
    mkdir -p "$build" || die "cannot create $build."
    [ -w "$build" ] || die "cannot write into $build (it belongs to $(stat -c %U -- "$build"))."
    # One set-up at a time: two builds in one folder would spoil each other.
    exec {setup_lock}> "$build/setup.lock" || die "cannot write into $build."
    flock -n "$setup_lock" || { say "Waiting for another set-up in $build"; flock "$setup_lock"; }
    forget_moved_build
    configure "$1"
    ninja -C "$build" -j "$(nproc)" "$target" 2>&1 {setup_lock}>&- | show_progress
    [ "${PIPESTATUS[0]}" -eq 0 ] || die "the build failed (see above)."
    exec {setup_lock}>&-
}

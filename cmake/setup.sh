# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
#
# Set-up step of ./render, ./batch, ./focus and ./check, to be sourced: installs missing packages, configures, builds.
#
#   setup render|batch|focus|check [FOLDER]  leaves the program (check: and the tests) in $repository/build; FOLDER
#                                            holds POV-Ray's source; without it, apt's mirrors do
#
# Messages go to standard error. With nothing to do it needs no network, waits for no other such command, and stays well under a second.

repository=$(dirname -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")")
build=$repository/build

say() { printf '%s\n' "$@" >&2; }
die() { printf '%s: ' "${0##*/}" >&2; say "$@"; exit 1; }

# quoted TEXT: povray needs quotation marks around spaces.
quoted()
{
    case $1 in
        *\"*) printf "'%s'" "$1" ;;
        *)    printf '"%s"' "$1" ;;
    esac
}

has_apt() { command -v dpkg-query >/dev/null && command -v apt-get >/dev/null; }

# packages_of GROUP: a name a line, or alternatives with | between them.
packages_of()
{
    awk -v group="$1" '!/^#/ && NF == 2 && ($1 == "render" || $1 == group || group == "check") { print $2 }' \
        "$repository/cmake/debian-packages"
}

# missing_packages GROUP: lines of packages_of with nothing installed for this processor.
missing_packages()
{
    local -a wanted names
    mapfile -t wanted < <(packages_of "$1")
    local installed
    installed=$(dpkg-query --show --showformat='${db:Status-Status} ${Package} ${Architecture}\n' ${wanted[@]//|/ } 2>/dev/null \
        | awk -v native="$(dpkg --print-architecture)" '$1 == "installed" && ($3 == native || $3 == "all") { print $2 }')
    local package name
    for package in "${wanted[@]}"; do
        IFS='|' read -ra names <<< "$package"
        for name in "${names[@]}"; do
            ! grep -qxF -- "$name" <<< "$installed" || continue 2
        done
        printf '%s\n' "$package"
    done
}

# choose_packages NAMES...: for each the first alternative that apt can install, else the first.
choose_packages()
{
    local package name
    local -a names
    for package in "$@"; do
        IFS='|' read -ra names <<< "$package"
        for name in "${names[@]}" "${names[0]}"; do
            [ ${#names[@]} -gt 1 ] && apt-cache policy "$name" 2>/dev/null | grep -q '^ *Candidate: [^(]' && break
        done
        printf '%s\n' "$name"
    done
}

install_packages()
{
    local -a missing as_root=()
    mapfile -t missing < <(missing_packages "$1")
    [ ${#missing[@]} -gt 0 ] || return 0
    local by_hand="sudo apt-get install --no-install-recommends ${missing[*]%%|*}"
    if [ "$(id -u)" -ne 0 ]; then
        # Without a terminal, sudo must not wait for a password.
        if command -v sudo >/dev/null && { [ -t 0 ] || sudo -n true 2>/dev/null; }; then
            as_root=(sudo)
        else
            die "these Debian packages are missing, and neither root nor sudo is at hand to install them." \
                "Have somebody who may run:" "  $by_hand"
        fi
    fi
    say "Installing Debian packages: ${missing[*]%%|*}"
    # The lists at hand may do.
    "${as_root[@]}" apt-get -q update >&2 || say "(the package lists could not be renewed; trying with those at hand)"
    mapfile -t missing < <(choose_packages "${missing[@]}")
    # A new machine often updates itself and holds the lock; apt-get waits up to 300 s and says so.
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
        apt-get -q -o DPkg::Lock::Timeout=300 --yes --no-install-recommends install "${missing[@]}" >&2 \
        || die "the packages could not be installed (see above; is there a network?). By hand:" "  $by_hand"
}

# Missing commands and a CMake that is too old, one a line.
lacking_tools()
{
    local tool least found
    for tool in cmake ninja c++ patch tar gzip xz; do
        command -v "$tool" >/dev/null || printf '%s\n' "$tool"
    done
    least=$(sed -n 's/^cmake_minimum_required(VERSION \(.*\))/\1/p' "$repository/CMakeLists.txt")
    found=$(cmake --version 2>/dev/null | sed -n '1s/^cmake version //p')
    if [ -n "$found" ] && [ "$(printf '%s\n' "$least" "$found" | sort -V | head -n 1)" != "$least" ]; then
        printf '%s\n' "CMake $least or later (found is $found)"
    fi
}

die_elsewhere()
{
    die "$1" \
        "Without building: the bundle povray-tilt-lens-VERSION-linux-$(uname -m).tar.xz runs on any Linux with glibc 2.36 or later;" \
        "unpack it and call its ./render. docs/building.md, \"A bundle for any Linux\", says how one is made." \
        "Building here: a compiler for C++17, CMake, Ninja and the libraries of docs/building.md, \"What the build needs\"; and a folder" \
        "with two files of Debian's source package povray:  ./render --source FOLDER"
}

# check_system FOLDER: fails if this system cannot build, with POV-Ray's source from FOLDER, or from apt's mirrors for "".
check_system()
{
    local lacking
    lacking=$(lacking_tools | paste -sd ,)
    [ -z "$lacking" ] || die_elsewhere "this system lacks what the build needs: ${lacking//,/, }."
    has_apt || [ -n "$1" ] || [ -f "$build/build.ninja" ] || compgen -G "$build/downloads/*.orig.tar.*" >/dev/null \
        || die_elsewhere "this system has no apt-get and dpkg, by which POV-Ray's source would be downloaded."
}

# A build folder remembers where it lies.
is_moved()
{
    local cache=$build/CMakeCache.txt
    [ -f "$cache" ] || return 1
    ! { grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$repository" "$cache" && grep -qxF "CMAKE_CACHEFILE_DIR:INTERNAL=$build" "$cache"; }
}

# After a move all but the downloads is made anew.
forget_moved_build()
{
    is_moved || return 0
    say "The repository has moved: building anew."
    find "$build" -mindepth 1 -maxdepth 1 ! -name downloads ! -name setup.lock -exec rm -rf {} +
}

in_cache() { grep -qxF -- "$1" "$build/CMakeCache.txt" 2>/dev/null; }

# new_options GROUP [FOLDER]: CMake options that the configuration lacks, one a line.
new_options()
{
    if [ "$1" = check ] && ! in_cache TILT_LENS_TESTS:BOOL=ON; then
        printf '%s\n' -DTILT_LENS_TESTS=ON
    fi
    if [ -n "${2:-}" ] && ! in_cache "POVRAY_TARBALL:PATH=$2"; then
        printf '%s\n' "-DPOVRAY_TARBALL=$2"
    fi
}

is_configured() { [ -f "$build/build.ninja" ] && [ -z "$(new_options "$@")" ]; }

# configure GROUP [FOLDER]: tests stay on once they are; commands must not undo each other's configuration.
configure()
{
    local -a options
    ! is_configured "$@" || return 0
    mapfile -t options < <(new_options "$@")
    check_system "${2:-}"
    say "Configuring (the first time this fetches POV-Ray's source)"
    ( cd "$repository" && cmake --preset release "${options[@]}" ) >&2 \
        || die "the configuration failed (see above)."
}

# Hides ninja's messages on nothing to do, and CMake's lists of source files.
show_progress()
{
    local line columns=0
    if [ -t 2 ]; then
        columns=$(tput cols 2>/dev/null) || columns=80
    fi
    while IFS= read -r line; do
        case $line in
            'ninja: no work to do.'|*'Re-checking globbed directories...'|'ninja: Entering directory'*) ;;
            '-- GLOB mismatch!'|'The following files were '*:|'  '[+-]/*) ;;
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

# is_built TARGET GROUP [FOLDER]: a dry run on build.ninja would end at the check whether CMake must run, which is therefore made here.
is_built()
{
    local target=$1 input
    is_configured "${@:2}" && ! is_moved || return 1
    if [ -f "$build/CMakeFiles/VerifyGlobs.cmake" ]; then
        cmake -P "$build/CMakeFiles/VerifyGlobs.cmake" >/dev/null 2>&1 || return 1
    fi
    while read -r input; do
        [[ $input == /* ]] || input=$build/$input
        [ -e "$input" ] && [ ! "$input" -nt "$build/build.ninja" ] || return 1
    done < <(ninja -C "$build" -n -t query build.ninja 2>/dev/null | sed -n '/^  input:/,/^  outputs:/s/^    |* *//p')
    [[ $(ninja -C "$build" -n -f <(echo include build.ninja) "$target" 2>&1) == *"ninja: no work to do." ]]
}

setup()
{
    local target=povray folder=${2:-}
    [ "$1" != check ] || target=all
    if [ -n "$folder" ]; then
        [ -d "$folder" ] || die "--source: there is no folder $folder"
        folder=$(readlink -f -- "$folder")
    fi
    ! has_apt || install_packages "$1"
    mkdir -p "$build" || die "cannot create $build."
    [ -w "$build" ] || die "cannot write into $build (it belongs to $(stat -c %U -- "$build"))."
    exec {setup_lock}>> "$build/setup.lock" || die "cannot write into $build."
    # A build must be the only one: two in one folder would spoil each other.
    if ! { flock -n -s "$setup_lock" && is_built "$target" "$1" "$folder"; }; then
        flock -n "$setup_lock" || { say "Waiting for another set-up in $build"; flock "$setup_lock"; }
        forget_moved_build
        configure "$1" "$folder"
        ninja -C "$build" -j "$(nproc)" "$target" 2>&1 {setup_lock}>&- | show_progress
        [ "${PIPESTATUS[0]}" -eq 0 ] || die "the build failed (see above)."
    fi
    exec {setup_lock}>&-
}

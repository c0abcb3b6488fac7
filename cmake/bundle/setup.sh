# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
#
# ./render's set-up step in a bundle, to be sourced.
repository=$(dirname -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")")
build=$repository

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

setup() { [ -z "${2:-}" ] || die "--source is for building; this bundle is built."; }

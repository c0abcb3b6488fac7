# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
# shellcheck shell=bash
#
# Completion for ./render, ./check and ./batch in Bash:   . editors/bash/povray-tilt-lens.bash

_tilt_lens_home=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." && pwd)
# Debian's package has this file in /usr/share/bash-completion/completions, the scenes elsewhere below /usr/share.
[ -d "$_tilt_lens_home/scenes" ] || _tilt_lens_home=$_tilt_lens_home/povray-tilt-lens

# The word that is being completed, without the marks that keep blanks together: an opening quotation mark, backslashes.
_tilt_lens_word()
{
    local word=${COMP_WORDS[COMP_CWORD]}
    case $word in
        [\"\']*) printf '%s' "${word:1}" ;;
        *)       printf '%s' "${word//\\/}" ;;
    esac
}

# Scenes of the project whose name, written as seen from here, begins with $1.
_tilt_lens_scenes()
{
    local scene
    for scene in "$_tilt_lens_home"/scenes/{gallery,tutorial,paper}/*.pov; do
        [ -e "$scene" ] || continue
        [ "$_tilt_lens_home" != "$PWD" ] || scene=${scene#"$PWD/"}
        case $scene in "$1"*) printf '%s\n' "$scene" ;; esac
    done
}

# Folders, and files that end in one of the further words, whose name begins with $1.
_tilt_lens_files()
{
    local word=$1 name ending
    shift
    while IFS= read -r name; do
        if [ -d "$name" ]; then
            printf '%s/\n' "$name"
            continue
        fi
        for ending in "$@"; do
            case $name in *"$ending") printf '%s\n' "$name" ;; esac
        done
    done < <(compgen -f -- "$word")
}

# Sets COMPREPLY to the lines of the file $1, each once and as the shell takes it: behind an opening quotation mark as it
# is, elsewhere with blanks and the like escaped. A folder, or an option without its value, gets no blank behind it.
_tilt_lens_reply()
{
    local i
    mapfile -t COMPREPLY < <(sort -u -- "$1")
    case ${COMP_WORDS[COMP_CWORD]} in
        [\"\']*) ;;
        *) for i in "${!COMPREPLY[@]}"; do
               case ${COMPREPLY[i]} in
                   *[[:space:]\"\'\$\`\&\;\(\)\<\>\|\*\?\[\#\!\\]*) COMPREPLY[i]=$(printf '%q' "${COMPREPLY[i]}") ;;
               esac
           done ;;
    esac
    case ${COMPREPLY[0]-} in
        */|*=|[-+][A-Z]) [ ${#COMPREPLY[@]} -ne 1 ] || compopt -o nospace 2>/dev/null ;;
    esac
}

_tilt_lens_render()
{
    local word
    word=$(_tilt_lens_word)
    local options='+W +H +A0.1 +FN16 +FE +FE32 +N +O +L +WT +SR +ER +SC +EC +C +UA -GA Output_Layers=on Declare= --unrestricted --help --version'
    _tilt_lens_reply <(
        compgen -W "$options" -- "$word"
        case $word in
            [-+]*) ;;
            *)     _tilt_lens_scenes "$word"
                   _tilt_lens_files "$word" .pov .ini ;;
        esac)
}

_tilt_lens_check()
{
    local word=${COMP_WORDS[COMP_CWORD]} list
    case ${COMP_WORDS[COMP_CWORD-1]} in
        -L) # the labels are the folders of tests
            _tilt_lens_reply <(
                for list in "$_tilt_lens_home"/tests/*/CMakeLists.txt; do
                    list=${list%/CMakeLists.txt}
                    compgen -W "${list##*/}" -- "$word"
                done) ;;
        -R|-E|-j) COMPREPLY=() ;;
        *)  _tilt_lens_reply <(compgen -W '-L -R -E -N -V -j --output-on-failure --rerun-failed --print-labels' -- "$word") ;;
    esac
}

_tilt_lens_batch()
{
    local word kinds='still film sweep status'
    local options='--bands --frames --only --set --then --on --workers --output --work --retries --limit --anew --quiet --povray --sbatch --detach --help'
    word=$(_tilt_lens_word)
    case ${COMP_WORDS[COMP_CWORD-1]} in
        --on) _tilt_lens_reply <(compgen -W 'local slurm' -- "$word"); return ;;
        --output|--work|--povray) _tilt_lens_reply <(_tilt_lens_files "$word" ''); return ;;
        --bands|--frames|--only|--set|--then|--workers|--retries|--limit|--sbatch) COMPREPLY=(); return ;;
    esac
    if [ "$COMP_CWORD" -eq 1 ]; then
        _tilt_lens_reply <(compgen -W "$kinds --help" -- "$word")
        return
    fi
    if [ "${COMP_WORDS[1]}" = status ]; then # of a folder, or of a picture
        _tilt_lens_reply <(
            case $word in
                -*) compgen -W '--help' -- "$word" ;;
                *)  _tilt_lens_files "$word" .png .exr ;;
            esac)
        return
    fi
    _tilt_lens_reply <(
        case $word in
            -*) compgen -W "$options" -- "$word" ;;
            *)  _tilt_lens_scenes "$word"
                _tilt_lens_files "$word" .pov ;;
        esac)
}

complete -F _tilt_lens_render ./render render povray-tilt-lens
complete -F _tilt_lens_check ./check
complete -F _tilt_lens_batch ./batch

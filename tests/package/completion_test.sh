#!/bin/sh
# completion_test.sh PROGRAM COMPLETION: what bash, zsh and fish offer, once COMPLETION.sh is sourced (of fish COMPLETION.fish), is what the program's help and lists
# say. Catches an option, a name, a modifier or a preset that completion does not know, and words of the wrong place.
set -eu
program=$1
completion=$2
PATH=$(dirname "$program"):$PATH
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
touch rows.csv
failed=0

# Each prints, a line each, what may stand at the end of a command line.
bash_offers() {
    COMP_LINE=$1 bash --norc -c '. "$0"; COMP_POINT=${#COMP_LINE}; _rotconv; printf "%s\n" "${COMPREPLY[@]-}"' "$completion.sh"
}
zsh_offers() {
    zsh -f -c '
        compdef() {}
        compadd() { print -l -- ${(P)@[-1]} }
        _files() { print -l -- * }
        . "$0"
        words=("${(@s: :)1}") CURRENT=${#words}
        _rotconv' "$completion.sh" "$1"
}

fish_offers() {
    fish --no-config -c 'source $argv[1]; complete -C $argv[2]' "$completion.fish" "$1" | cut -f 1
}

# check SHELL LINE WORD...: the words are among those that the shell offers; !WORD: is not.
check() {
    shell=$1
    line=$2
    "${shell}_offers" "$line" > offered
    shift 2
    [ $# -gt 0 ] || fail "nothing to look for after '$line'"
    for word; do
        case $word in
        !*) ! grep -qxF -e "${word#!}" offered || fail "$shell offers ${word#!} after '$line'" ;;
        *) grep -qxF -e "$word" offered || fail "$shell does not offer $word after '$line'" ;;
        esac
    done
}
fail() {
    echo "FAILED: $*"
    failed=1
}

# Readline takes what stands behind a colon or an equals sign for the word, zsh and fish the whole.
check_part() { # LINE, what stands before the word, WORD...
    line=$1
    before=$2
    shift 2
    check bash "$line" "$@"
    whole=
    for word; do
        case $word in
        !*) whole="$whole !$before${word#!}" ;;
        *) whole="$whole $before$word" ;;
        esac
    done
    for shell in $shells; do
        # shellcheck disable=SC2086 # the words have no blanks
        [ "$shell" = bash ] || check "$shell" "$line" $whole
    done
}

shells=bash
for shell in zsh fish; do
    if command -v $shell > /dev/null; then
        shells="$shells $shell"
    else
        echo "$shell is not installed, and is left out"
    fi
done
# Columns of the program's own lists.
names=$("$program" list | sed -n '2,/^$/p' | sed 's/euler:SEQ/euler/' | awk 'NF { print $1 }')
commands=$("$program" --help | sed -n '/^Commands:/,/^$/s/^  \([a-z]*\) .*/\1/p')
modifiers=$("$program" list quat | sed -n 's/^  modifiers *//p')
presets=$("$program" list quat | sed -n '/^  presets/,$p' | sed 's/^  presets/ /' | awk '{ print $1 }')
[ "$(echo "$names $presets" | wc -w)" -gt 18 ] || fail "the lists were not read: $names $presets"

# shellcheck disable=SC2086 # likewise
for shell in $shells; do
    for command in '' $commands; do
        options=$("$program" $command --help | grep -oE '^ +(-[a-z],)?--[a-z0-9-]+|^  shared:.*' | grep -oE -- '--?[a-z0-9-]+')
        check "$shell" "rotconv ${command:+$command }-" $options
    done
    check "$shell" "rotconv " $commands rows.csv
    check "$shell" "rotconv -f " $names !rows.csv !--to
    check "$shell" "rotconv -f quat -t " $names !list
    check "$shell" "rotconv propagate -t " $names
    check "$shell" "rotconv identify -f " $names
    check "$shell" "rotconv list " $names $presets methods !rows.csv
    check "$shell" "rotconv -f quat -t rpy " rows.csv $commands
    check "$shell" "rotconv survey -f quat " rows.csv !list
    check "$shell" "rotconv -i " rows.csv !list
    check "$shell" "rotconv --method " fast trace !quat
    check "$shell" "rotconv sample --kind " half-turn many-turns !quat
    check "$shell" "rotconv compare --body-axes " frd:flu !quat
    check "$shell" "rotconv propagate --integrator " rk4 magnus6 !quat
    check "$shell" "rotconv --format " csv json pretty f64 !quat
    check "$shell" "rotconv compare --format " csv json pretty !f64
    check "$shell" "rotconv survey --format " json !csv
    check "$shell" "rotconv --header " auto yes no add !rows.csv
    check "$shell" "rotconv sample --header " no add !auto
    check "$shell" "rotconv --on-error " stop nan skip
    check "$shell" "rotconv --diagnostics " off summary rows columns
    check "$shell" "rotconv --input-format " csv f64 !json
    check "$shell" "rotconv --delimiter " comma tab semicolon blank
    check "$shell" "rotconv compare --align " reference body both yaw first
    check "$shell" "rotconv compare --allow-unpaired " file reference both
    check "$shell" "rotconv compose --allow-unpaired " reference !both
    check "$shell" "rotconv compare --reference-time-unit " s ms us ns
    check "$shell" "rotconv rates --frame " body reference
    check "$shell" "rotconv propagate --interpolation " linear cubic
    check "$shell" "rotconv sample --kind uniform," uniform,small !small
    check "$shell" "rotconv -f quat -t quat,rp" quat,rpy !rpy !quat
    check "$shell" "rotconv rates -" --inverse !--lock-margin
done
check_part "rotconv -f quat:" quat: $modifiers $presets !deg
check_part "rotconv -f euler:" euler: ZYX xyz ZXZ !deg !XXZ
check_part "rotconv -f euler:ZYX:" euler:ZYX: deg passive ros !xyzw !ZYX
check_part "rotconv -f dcm:passive:" dcm:passive: col spice !xyzw
check_part "rotconv -f gibbs:" gibbs: passive !deg
check_part "rotconv -f quat -t rpy,euler:ZYX:" rpy,euler:ZYX: deg passive !ZYX
check_part "rotconv propagate --to=quat," --to= quat,rpy
check_part "rotconv compare -f quat:xyzw -t rpy," rpy, !rpy,quat !quat
check_part "rotconv --format=" --format= csv !quat
check_part "rotconv --from=" --from= quat euler
check_part "rotconv --reference-axes ned:" ned: enu
check_part "rotconv --from=rotvec:" --from=rotvec: deg
check_part "rotconv compose -f quat --by=axang:" --by=axang: deg

exit "$failed"

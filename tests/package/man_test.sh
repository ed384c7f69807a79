#!/bin/sh
# man_test.sh PROGRAM FOLDER: the manual pages are clean, they and the program name the same options and commands, texts name
# no others, and the numbers of the worked example and the commands for files of other programs are right.
set -eu
program=$1
page=$2/rotconv.1
conventions=$2/rotconv-conventions.7
failed=0
fail() {
    echo "FAILED: $*"
    failed=1
}

# Examples come first, and no page is installed.
lint=$(mandoc -T lint "$page" "$conventions" 2>&1 | grep -v 'date in the future\|referenced manual not found\|conventional order: Sh EXIT STATUS') || true
[ -z "$lint" ] || fail "mandoc -T lint: $lint"
if command -v man > /dev/null; then
    warnings=$(LC_ALL=C.UTF-8 MANWIDTH=80 man --warnings -l "$page" "$conventions" 2>&1 > /dev/null) || true
    [ -z "$warnings" ] || fail "man -l: $warnings"
fi
text=$(mandoc -T ascii "$page" | sed 's/.\x08//g')

# Options: those of --help are those of the page.
of_help=$("$program" --help | grep -oE '^ +(-[a-z],)?--[a-z0-9-]+' | grep -oE -- '--[a-z0-9-]+' | sort -u)
of_page=$(printf '%s\n' "$text" | sed -n '/^OPTIONS/,/^COMMANDS/p' | grep -E '^ {5}-' | grep -oE -- '--[a-z0-9-]+' | sort -u)
[ -n "$of_help" ] || fail "no options in --help"
[ "$of_help" = "$of_page" ] || fail "options of --help: $of_help; of the page: $of_page"

# Commands and their own options.
commands=$("$program" --help | sed -n '/^Commands:/,/^$/s/^  \([a-z]*\) .*/\1/p')
[ "$(printf '%s\n' "$commands" | wc -l)" -ge 5 ] || fail "not all commands were seen: $commands"
for command in $commands; do
    printf '%s\n' "$text" | sed -n '/^COMMANDS/,/^INPUT/p' | grep -qE "^ {5}$command\\b" || fail "the page does not explain $command"
    of_command=$("$program" "$command" --help | grep -oE '^ +(-[a-z],)?--[a-z0-9-]+|^  shared:.*' | grep -oE -- '--[a-z0-9-]+' | sort -u)
    [ -n "$of_command" ] || fail "no options in $command --help"
    for option in $of_command; do
        printf '%s\n' "$text" | grep -qE "^ {5}.*$option\\b" || fail "the page does not explain $option of $command"
    done
done

# Options that texts name, of the program and of the pages, are those of a command: --list is a word for list, --complete what
# shells ask, --csv is of ros2, --allow-... are two, and --deg to --quiet are second names.
known=$({
    "$program" --help
    for command in $commands; do "$program" "$command" --help; done
} | grep -oE -- '--[a-z0-9-]+')
named=$({
    grep -ohE '"([^"\]|\\.)*"' "$2"/../src/cli/*.cpp "$2"/../src/cli/*/*.cpp
    mandoc -T ascii -O width=1000 "$page" "$conventions" | sed 's/.\x08//g'
} | grep -oE -- '(^|[^a-z-])--[a-z][a-z-]+' | sed 's/^[^-]//' | sort -u)
for option in $named; do
    printf '%s\n' --list --complete --csv --allow- --deg --cols --prec --json --quiet "$known" | grep -qxF -- "$option" || fail "a text names $option, which no command has"
done

# The worked example: all representations, each line written from the quaternion and read back.
lines=$(sed -n '/^\.Sh A WORKED EXAMPLE/,/^\.Sh PROJ/p' "$conventions" | grep -E '^[a-z0-9-]+(:[a-zA-Z]+)* +-?[0-9.]+ ')
for name in $("$program" list | sed -n '2,/^$/s/^\([a-z0-9-]*\).*/\1/p'); do
    printf '%s\n' "$lines" | grep -qE "^${name}[: ]" || fail "the worked example has no $name"
done
while read -r spec numbers; do
    written=$("$program" -f quat -t "$spec" -p 8 0.96 0.08 0.12 0.24)
    [ "$written" = "$numbers" ] || fail "the worked example in $spec: $numbers, not $written"
    # shellcheck disable=SC2086 # the numbers are words
    "$program" compare -f "$spec" -t quat --within 1e-7rad --diagnostics off $numbers 0.96 0.08 0.12 0.24 > /dev/null ||
        fail "the worked example from $spec: $numbers"
done << EOF
$lines
EOF

# The commands for files of other programs, on the least of each; the rows are ours.
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
printf 'FMT, 129, 31, ATT, QccccCC, TimeUS,DesRoll,Roll,DesPitch,Pitch,DesYaw,Yaw\nATT, 1000, 0.1, 0, 0.2, 0, 0.3, 180\n' \
    > "$work/flight.log"
printf 'CCSDS_AEM_VERS = 1.0\nDATA_START\n2026-11-01T00:00:00.0 0.5 0.5 0.5 0.5\nDATA_STOP\n' > "$work/sat.aem"
expected=$(printf 'ATT, 1000, 0.1,0,0,0,1, 0.2, 0.3\n2026-11-01T00:00:00.0 90 0 90')
commands=$(sed -n "/^grep '^ATT/,/^\.Ed/p" "$page" | grep -v '^\.' | sed 's/\\e/\\/g')
answers=$(cd "$work" && PATH=$(dirname "$program"):$PATH sh -c "$commands" 2>&1) || true
[ "$answers" = "$expected" ] || fail "the commands for files of other programs print: $answers"

exit "$failed"

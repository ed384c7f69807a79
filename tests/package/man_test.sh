#!/bin/sh
# man_test.sh PROGRAM PAGE: the manual page is clean, and it and the program name the same things.
set -eu
program=$1
page=$2
failed=0
fail() {
    echo "FAILED: $*"
    failed=1
}

lint=$(mandoc -T lint "$page" 2>&1 | grep -v 'date in the future') || true
[ -z "$lint" ] || fail "mandoc -T lint: $lint"
if command -v man > /dev/null; then
    warnings=$(LC_ALL=C.UTF-8 MANWIDTH=80 man --warnings -l "$page" 2>&1 > /dev/null) || true
    [ -z "$warnings" ] || fail "man -l: $warnings"
fi
text=$(mandoc -T ascii "$page" | sed 's/.\x08//g')

# Options: those of --help are those of the page.
of_help=$("$program" --help | grep -oE '^ +(-[a-z],)?--[a-z-]+' | grep -oE -- '--[a-z-]+' | sort -u)
of_page=$(printf '%s\n' "$text" | sed -n '/^OPTIONS/,/^COMMANDS/p' | grep -E '^ {5}-' | grep -oE -- '--[a-z-]+' | sort -u)
[ -n "$of_help" ] || fail "no options in --help"
[ "$of_help" = "$of_page" ] || fail "options of --help: $of_help; of the page: $of_page"

# Commands and their own options.
commands=$("$program" --help | sed -n '/^Subcommands:/,/^$/s/^  \([a-z]*\) .*/\1/p')
[ "$(printf '%s\n' "$commands" | wc -l)" -eq 4 ] || fail "not all commands were seen: $commands"
for command in $commands; do
    printf '%s\n' "$text" | sed -n '/^COMMANDS/,/^INPUT/p' | grep -qE "^ {5}$command\\b" || fail "the page does not explain $command"
    of_command=$("$program" "$command" --help | grep -oE '^ +(-[a-z],)?--[a-z-]+' | grep -oE -- '--[a-z-]+' | sort -u)
    [ -n "$of_command" ] || fail "no options in $command --help"
    for option in $of_command; do
        printf '%s\n' "$text" | grep -qE "^ {5}.*$option\\b" || fail "the page does not explain $option of $command"
    done
done

# Names, aliases, modifiers and presets: each that the program lists stands in the page.
names=$("$program" list | sed -n '2,/^$/p' | cut -c1-28 | tr ' ' '\n' | sed 's/:SEQ//' | grep . | sort -u)
[ "$(printf '%s\n' "$names" | wc -l)" -ge 18 ] || fail "too few names: $names"
words=$(for name in $names; do "$program" list "$name"; done |
    sed -n -e 's/^  modifiers//p' -e 's/^  presets *\([a-z]*\).*/\1/p' -e 's/^ \{13\}\([a-z]*\)  .*/\1/p' | tr ' ' '\n' | grep . | sort -u)
[ "$(printf '%s\n' "$words" | wc -l)" -ge 14 ] || fail "too few modifiers and presets: $words"
for word in $names $words; do
    printf '%s\n' "$text" | grep -qw -- "$word" || fail "the page does not name $word"
done

# Kinds of diagnostic, each made to appear.
kinds=$({
    "$program" -f quat -t euler:ZYX --tolerance 1 1 0 1.1 0
    "$program" -f euler:ZXZ -t euler:ZXZ 1 1e-8 1
    "$program" -f quat -t mrp 0 0 1 0
    "$program" -f quat -t cayley 0 0 1 0
    "$program" -f quat -t axis-angle 1 0 0 0
    "$program" -f euler:ZYX:deg -t rpy 10 90 20
    "$program" -f dcm -t quat --method baruh -1 0 0 0 1 0 0 0 -1
} 2>&1 > /dev/null | sed -n 's/^rotconv: argument: \([a-z-]*\): .*/\1/p' | sort -u)
[ "$(printf '%s\n' "$kinds" | wc -l)" -eq 7 ] || fail "not all kinds were seen: $kinds"
for kind in $kinds; do
    printf '%s\n' "$text" | grep -qE "^ {5}$kind\$" || fail "the page does not explain $kind"
done
exit "$failed"

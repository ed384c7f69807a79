#!/bin/sh
# man_test.sh PROGRAM PAGE: the manual page is clean, and it and the program name the same options and commands.
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
[ "$(printf '%s\n' "$commands" | wc -l)" -ge 5 ] || fail "not all commands were seen: $commands"
for command in $commands; do
    printf '%s\n' "$text" | sed -n '/^COMMANDS/,/^INPUT/p' | grep -qE "^ {5}$command\\b" || fail "the page does not explain $command"
    of_command=$("$program" "$command" --help | grep -oE '^ +(-[a-z],)?--[a-z-]+' | grep -oE -- '--[a-z-]+' | sort -u)
    [ -n "$of_command" ] || fail "no options in $command --help"
    for option in $of_command; do
        printf '%s\n' "$text" | grep -qE "^ {5}.*$option\\b" || fail "the page does not explain $option of $command"
    done
done

exit "$failed"

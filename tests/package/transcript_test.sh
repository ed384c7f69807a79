#!/bin/sh
# transcript_test.sh: what differs from a transcript is seen. Catches a runner that finds all as it should be.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

failed=0
check() { # the exit status of run_commands.sh, the transcript
    printf '%b' "$2" > "$work/made-up.txt"
    status=0
    "$here/run_commands.sh" "$work/made-up.txt" > "$work/log" || status=$?
    [ "$status" -eq "$1" ] || {
        cat "$work/log"
        echo "FAILED: exit $status with the transcript $2"
        failed=1
    }
}
check 0 'Text.\n$ echo a; echo b >&2; exit 3\na\n! b\nexit 3\n\nMore text.\n'
check 0 '$ seq 4\n1\n...\n4\n$ echo hello world\nh...o...d\n$ echo\n.\n$ true\n...\n$ echo \\\n    a\na\n'
check 1 '$ echo a\n! a\n'
check 1 '$ exit 3\n'
check 1 '$ seq 2\n1\n'
check 1 '$ seq 2\n1\n2\n3\n'
check 1 '$ seq 3\n...\n4\n'
check 1 '$ echo abc\nab...bc\n'
check 1 '$ echo abc\nb...\n'
exit "$failed"

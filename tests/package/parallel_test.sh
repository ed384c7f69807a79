#!/bin/sh
# parallel_test.sh FOLDER: the example for GNU parallel has the bytes of a single run, with good rows and with bad ones. 77, which
# is skipped, where GNU parallel is not installed; moreutils has another program of that name.
set -eu
cd "$1"
parallel --version 2>/dev/null < /dev/null | grep -q '^GNU parallel' || {
    echo "GNU parallel is not installed"
    exit 77
}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export PARALLEL_HOME="$work" # no settings of the user's

failed=0
check() { # what, expected, found
    [ "$2" = "$3" ] || {
        echo "FAILED: $1 is $3, not $2"
        failed=1
    }
}

# compare TABLE: a single run selects by name, so that a header which is lost, repeated or unconverted shows.
compare() {
    status=0
    ./euroc-with-parallel.sh --block 2k --joblog "$work/jobs" < "$1" > "$work/chunks" 2> "$work/messages" || status=$?
    chunks=$(($(wc -l < "$work/jobs") - 1))
    [ "$chunks" -ge 10 ] || check "the number of chunks" "10 or more" "$chunks"
    for threads in "" "--threads 1"; do
        # shellcheck disable=SC2086 # no word or two
        rotconv -f quat -t rpy:deg --columns q_RS_w,q_RS_x,q_RS_y,q_RS_z --on-error nan $threads \
            < "$1" > "$work/single" 2>/dev/null || true
        cmp "$work/single" "$work/chunks" || failed=1
    done
}

table=data/euroc.csv
{
    cat "$table"
    for _ in 1 2 3 4 5 6 7 8 9 10 11 12; do sed 1d "$table"; done
} > "$work/table"
compare "$work/table"
check "the exit status" 0 "$status"
check "what is on stderr" "" "$(cat "$work/messages")"

# Words in the place of all four numbers: a chunk that guessed would take its first row as a header.
awk -F, -v OFS=, 'NR > 1 { $5 = $6 = $7 = $8 = "lost" } { print }' "$work/table" > "$work/bad"
compare "$work/bad"
check "the exit status with bad rows in each chunk" "$chunks" "$status"

# One bad row fails one chunk.
sed '50s/,[^,]*,/,lost,/4' "$work/table" > "$work/bad"
compare "$work/bad"
check "the exit status with one bad row" 1 "$status"
check "the line of the bad row" 50 "$(grep -n nan "$work/chunks" | cut -d : -f 1)"
exit "$failed"

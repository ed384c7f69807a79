#!/bin/sh
# short_run.sh FUZZER FOLDER RUNS [DICTIONARY SEEDS], all absolute: runs a fuzzer on RUNS inputs, a copy of its seeds and
# what it makes of them, prints what it reached, and fails where it reached something that it counts less than LEAST times
# (50). Inputs are counted, not seconds, so that a slow machine reaches no less; what takes a minute hangs.
set -eu
fuzzer=$1 folder=$2 runs=$3 dictionary=${4:+-dict=$4} seeds=${5:-}
rm -rf "$folder"
mkdir -p "$folder/corpus"
cd "$folder"
[ -z "$seeds" ] || cp "$seeds"/* corpus
"$fuzzer" $dictionary -runs="$runs" -max_len=4096 -timeout=60 -seed=1 -print_final_stats=1 corpus >log 2>&1 || {
    tail -n 60 log
    exit 1
}
grep -E '^(reached|stat::number_of_executed_units)' log || true
awk -F ': ' -v least="${LEAST:-50}" '/^reached / { ++names; if ($NF < least) { print "too few: " $0; bad = 1 } }
    END { exit bad || !names }' log

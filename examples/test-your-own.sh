#!/bin/bash
# test-your-own.sh [SPEC COMMAND]: prints on which kinds of rows a program fails. COMMAND reads matrices from standard input, one a
# line, and writes the attitudes in SPEC. Without it, the programs of filters are tested. In the environment, FROM is another SPEC
# to read, KINDS are other kinds, TOLERANCE is that of compare. The exit status is 1 if a cell of the table is not "pass".
set -u
from=${FROM:-dcm}
kinds=uniform,small,half-turn,lock,border,cube
[ "$from" != dcm ] || kinds=$kinds,noise
kinds=${KINDS:-$kinds}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
for kind in ${kinds//,/ }; do
    rotconv sample -t "$from" --kind "$kind" || exit 2
done > "$work/in"
failed=0

check() { # NAME SPEC COMMAND: prints a line of the table
    bash -c "$3" < "$work/in" > "$work/out" || echo "exit status $?: $3" >&2
    rotconv compare -f "$2" -t "$from" --header no --tolerance "${TOLERANCE:-0.002}" --on-error nan --diagnostics off --format csv \
        --within 1e-12rad "$work/out" "$work/in" 2> "$work/errors" | awk -F '[, \t]+' -v line="| $1 | $2 |" -v rows="$(wc -l < "$work/in")" '
        $NF != "nan" { angle[NR] = $NF + 0 }
        END {
            for (first = 0; first < rows; first += 1000) { # those of a kind
                worst = -1
                for (i = 1; i <= 1000; ++i) {
                    a = first + i in angle ? angle[first + i] : 9 # no answer
                    if (a > worst) { worst = a; at = i }
                }
                bad += worst > 1e-12
                verdict = worst > 1e-6 ? "**fails** " : "digits "
                line = line " " (worst > 1e-12 ? verdict (worst == 9 ? "nan" : sprintf("%.2g", worst)) " @" at : "pass") " |"
            }
            print line
            exit bad > 0
        }' || failed=1
}

echo "| program | writes | ${kinds//,/ | } |"
echo "| --- | --- |$(printf ' --- |%.0s' ${kinds//,/ })"
if [ $# -gt 0 ]; then
    check "${2%% *}" "$1" "$2"
    exit "$failed"
fi
cd "$(dirname "$0")/filters" || exit 2
g++ -O2 -I/usr/include/eigen3 eigen.cpp -o "$work/eigen" 2> "$work/errors"
for line in "textbook.py rpy quat rotvec" "scipy_rotation.py euler:ZYX quat:xyzw rotvec" "eigen euler:ZYX quat:xyzw rotvec"; do
    program=${line%% *}
    # What can tell its version runs here.
    for command in "python3 $program" "/usr/bin/python3 $program" "$work/$program" ""; do
        name=$($command version 2> "$work/errors") && break
    done
    [ -n "$command" ] || echo "left out, because it does not run here: $program" >&2
    for spec in ${command:+${line#* }}; do
        check "$name" "$spec" "$command $spec"
    done
done
exit "$failed"

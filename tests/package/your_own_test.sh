#!/bin/bash
# your_own_test.sh EXAMPLES: the table of test-your-own.md has the verdicts of test-your-own.sh on the programs that are installed
# here in the page's versions; the page's other commands run; broken programs are found. Catches a script that passes programs with
# wrong answers, without answers or with too few; rows on which a known failure does not show; a page that has gone stale.
set -u
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp -r "$1" "$work/examples"
mkdir "$work/bin"
cd "$work/examples/data" || exit 1
page=../test-your-own.md
failed=0
fail() {
    echo "FAILED: $*"
    failed=1
}

# Angles and rows may differ with the processor, so that only the verdicts are compared.
run() { # ARGUMENT...: its table, and 1 if not all pass
    ../test-your-own.sh "$@" > "$work/printed" 2> "$work/errors"
    [ $? -eq "$(grep -c -m 1 -e digits -e fails "$work/printed")" ] || fail "exit status: $*"
}
run
other_versions=
cat "$work/printed" "$work/errors"
! grep -v '^left out' "$work/errors" || fail "a program does not run to its end"
verdicts() { sed 's/ [^ |]* @[0-9]*//g' "$1"; }
while IFS= read -r line; do
    key=$(echo "$line" | cut -d '|' -f 1-3)
    found=$(verdicts "$work/printed" | grep -F "$key|")
    [ -n "$found" ] || other_versions=$key
    [ -z "$found" ] || [ "$found" = "$line" ] || fail "the page has: $line"
done < <(sed -n '/^| program /,/^$/p' "$page" | sed '/^$/,$d' | verdicts /dev/stdin)
[ -z "$other_versions" ] || echo "not compared, because other versions are installed or none:$other_versions and others"

# The commands for the shell: each comparison finds an answer to each row, right or wrong, and its verdict is that of the page.
for python in python3 /usr/bin/python3 ""; do
    "${python:-false}" -c 'import scipy' 2> /dev/null && ln -s "$(command -v "$python")" "$work/bin/python3" && break
done
PATH=$work/bin:$PATH
while IFS= read -r line; do
    case $line in
    *python3*) [ -n "$python" ] || continue ;;
    *eigen*) [ -d /usr/include/eigen3 ] || continue ;;
    esac
    bash -c "$line" > "$work/out" 2> "$work/errors"
    status=$?
    case $line in
    *compare*) [ "$status" -le 1 ] && grep -qx 'unpaired  0' "$work/out" && ! grep Traceback "$work/errors" &&
        { [ -n "$other_versions" ] || tail -n 1 "$work/out" | grep -q "^${line##*# }"; } ;;
    *) [ "$status" -eq 0 ] ;;
    esac || fail "exit status $status: $line $(tail -n 5 "$work/out" "$work/errors")"
done < <(sed -n '/^```sh$/,/^```$/{/^```/!p;}' "$page")

# The commands for a workflow, with a program that is right and with one that is wrong.
mkdir build
sed -n '/^```yaml$/,/^```$/s/^    \(rotconv\|build\)/\1/p' "$page" > "$work/step"
[ "$(wc -l < "$work/step")" -eq 2 ] || fail "the step of the page has other commands"
for verdict in "rpy pass" "euler:ZYX fail: max"; do
    printf '#!/bin/sh\nrotconv -f quat -t %s --diagnostics off\n' "${verdict%% *}" > build/mytool
    chmod +x build/mytool
    bash -e "$work/step" > "$work/out" 2> "$work/errors"
    [ $? -eq "$(grep -c fail: "$work/out")" ] && tail -n 1 "$work/out" | grep -q "^${verdict#* }" ||
        fail "the step of the page with $verdict: $(cat "$work/out" "$work/errors")"
done

# Programs with a known fault, and the verdicts that they must have on uniform, small, half-turn, lock, border, cube and noise.
own() { # EXPECTED SPEC COMMAND: P passes, d loses digits, f fails
    run "$2" "$3"
    found=$(tail -n 1 "$work/printed" | cut -d '|' -f 4- | sed 's/pass/P/g; s/digits[^|]*/d/g; s/[*][*]fails[^|]*/f/g' | tr -d ' |')
    [ "$found" = "$1" ] || fail "$found instead of $1: $3 $(cat "$work/errors")"
}
right='rotconv -f dcm -t rpy --tolerance inf --diagnostics off'
own PPPPPPP rpy "$right"
own fffffff rpy 'rotconv -f dcm -t rpy --columns 1,4,7,2,5,8,3,6,9 --tolerance inf --diagnostics off' # the inverse
own fffffff rpy "$right | awk -F , '{ print \$3 \",\" \$2 \",\" \$1 }'" # another order
own fffffff rpy "$right --degrees"
own PPffPff rotvec "awk -F , -v OFMT=%.17g -v OFS=, '{ # the logarithm without a case for half-turns
    c = (\$1 + \$5 + \$9 - 1) / 2; x = \$8 - \$6; y = \$3 - \$7; z = \$4 - \$2; s = sqrt(x * x + y * y + z * z) / 2
    k = s < 1e-5 ? 1 / 2 : atan2(s, c) / (2 * s); print k * x, k * y, k * z }'"
own ddddddd rpy "$right -p 8"
own fffffff rpy false
own fffffff rpy "$right | sed 5d"
own PPPPPPf rpy "$right | head -n -1"
exit "$failed"

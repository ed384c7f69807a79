#!/bin/sh
# comparison_test.sh FOLDER: the errors, drifts and times of examples/comparison.md are those of the measurement beside it.
set -eu
cd "$1"
work=$(mktemp)
trap 'rm -f "$work"' EXIT
awk -F, '$1 == "work" && $2 == "tumbling" && $5 == 0.01 && $6 == 0 && $12 == "ok" {
        printf "%s %s %.1e %.1e %.3g\n", $3, $4, $8, $11, $9
    }' charts/kinematics.csv | sed 's/e-0/e-/g' > "$work"

found=0
while IFS='|' read -r _ set _ _ error drift time _; do
    set=$(echo "$set" | tr -d '`,')
    # shellcheck disable=SC2086 # words
    set -- $set
    case "$*" in
    *magnus*) integrator=$2 ;;
    *) integrator=rk4 ;;
    esac
    measured=$(grep "^$1 $integrator " "$work") || {
        echo "not measured: $1 $integrator"
        exit 1
    }
    error=$(echo $error)
    drift=$(echo $drift)
    seconds=$(echo "$time" | tr -d ' ' | awk '{ printf "%.3g", $1 }')
    expected="$1 $integrator $error ${drift:-0.0e+00}"
    case "$measured" in
    "$expected "*) ;;
    *)
        echo "the page says $expected, the measurement $measured"
        exit 1
        ;;
    esac
    echo "$measured $seconds" | awk '{ exit !($6 > 0.99 * $5 && $6 < 1.01 * $5) }' || {
        echo "the page says $seconds ns, the measurement $measured"
        exit 1
    }
    found=$((found + 1))
done <<END
$(grep '^| `' comparison.md | grep -v half-turn)
END
sets=$(sed -n 's/^| `\([^`:]*\).*/\1/p' comparison.md | sort -u | wc -l)
head -n 1 comparison.md | grep -q " eight " && [ "$sets" -eq 8 ] || {
    echo "$sets sets are listed: $(head -n 1 comparison.md)"
    exit 1
}
[ "$found" -eq 9 ] || {
    echo "$found rows of the table were checked, not 9"
    exit 1
}

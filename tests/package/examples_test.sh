#!/bin/sh
# examples_test.sh FOLDER: each example runs, and the source documents' examples print what the documents print.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
cd "$1"
failed=0
check() { # what, expected line, text
    printf '%s\n' "$3" | grep -qxF -- "$2" || {
        echo "FAILED: $1 does not print: $2"
        printf '%s\n' "$3"
        failed=1
    }
}

# Baruh's six digits; the parameters of the first example with the sign of part c).
baruh=$(./baruh.sh)
check baruh.sh "0.986048 -0.150702 -0.070700 0.146981 0.987598 -0.055195 0.078141 0.044033 0.995969" "$baruh"
check baruh.sh "-0.024902 0.037352 -0.074705 0.996195" "$baruh"
check baruh.sh "-0.232467 0.641122 0.731383 -0.969780 -0.095527 -0.224503 -0.074067 -0.761471 0.643954" "$baruh"
check baruh.sh "0.234043 -0.351065 0.702130 0.573576" "$baruh"
check baruh.sh "-0.285714 0.428571 -0.857143 10.000000" "$baruh"
check baruh.sh "0.285714 -0.428571 0.857143 110.000000" "$baruh"

# cos(-phi + psi) = 0.6 and sin(-phi + psi) = 0.8 with psi = 0: phi = -53.1301 degrees.
stuelpnagel=$(./stuelpnagel.sh 2>&1)
check stuelpnagel.sh "-53.1301 90 0" "$stuelpnagel"
check stuelpnagel.sh "0 0 180" "$stuelpnagel"
check stuelpnagel.sh "0 0 inf" "$stuelpnagel"
check stuelpnagel.sh "0 0 0 -0.414214 0" "$stuelpnagel"
for kind in gimbal-lock half-turn infinite; do
    printf '%s\n' "$stuelpnagel" | grep -q "$kind" || {
        echo "FAILED: stuelpnagel.sh does not report $kind"
        failed=1
    }
done

made=$(mktemp -d)
data/make "$made"
for file in euroc.csv kitti.txt; do
    cmp "data/$file" "$made/$file" || failed=1
done
rm -r "$made"
[ "$(./tum-to-rpy.sh 2>/dev/null | wc -l)" -eq "$(wc -l < data/tum_fr1_xyz.txt)" ] || failed=1
[ "$(./euroc-to-matrices.sh 2>/dev/null | wc -l)" -eq "$(wc -l < data/euroc.csv)" ] || failed=1
[ "$(./kitti-to-quaternions.sh 2>/dev/null | wc -l)" -eq "$(wc -l < data/kitti.txt)" ] || failed=1

conventions=$(./identify.sh)
for answer in quat:xyzw:1-4 rpy:deg:1-3 dcm:col:1-9; do
    check identify.sh "-f ${answer%:*} --columns ${answer##*:}" "$conventions"
done
check identify.sh "ambiguous: 97 fit; all turn about one axis, (0, 0, 1)" "$conventions"

motion=$(./survey-and-propagate.sh)
check survey-and-propagate.sh "The smallest set that serves: mrp" "$motion"
printf '%s\n' "$motion" | awk '/^rows/ && $2 > 10 { rows = 1 } /^max/ && $2 < 0.1 && $3 == "mrad" { found = 1 } END { exit !(rows && found) }' || {
    printf '%s\n' "$motion"
    echo "FAILED: survey-and-propagate.sh does not come back to the attitudes"
    failed=1
}

# The three checks hold; the first fails when one digit of one row of the golden file is another, and the others still hold.
checks=$(./check-conversion.sh 2> /dev/null) && [ "$(printf '%s\n' "$checks" | grep -c '^pass: ')" -eq 3 ] || {
    printf '%s\n' "$checks"
    echo "FAILED: check-conversion.sh"
    failed=1
}
golden=$(mktemp)
for digit in 2 9 15; do
    awk -v digit=$digit 'NR == 7 { $7 = substr($7, 1, digit) (substr($7, digit + 1, 1) + 5) % 10 substr($7, digit + 2) } 1' data/tum_fr1_xyz_rpy.txt > "$golden"
    status=0
    changed=$(./check-conversion.sh "$golden" 2>&1) || status=$?
    [ "$status" -eq 1 ] && check check-conversion.sh "beyond    1" "$changed" &&
        [ "$(printf '%s\n' "$changed" | grep -c '^pass: ')" -eq 2 ] || {
        echo "FAILED: check-conversion.sh does not see digit $digit: exit $status"
        failed=1
    }
done
rm "$golden"

# check-situations.sh prints situations.txt, and the table of README.md is at most eight of its rows.
./check-situations.sh | diff "$here/situations.txt" - || {
    echo "FAILED: check-situations.sh does not print situations.txt"
    failed=1
}
table=$(sed -n '/^| situation /,/^$/p' README.md)
others=$(printf '%s\n' "$table" | grep -vxFf "$here/situations.txt") || true
rows=$(printf '%s\n' "$table" | sed 1,2d | wc -l)
[ -z "$others" ] && [ "$rows" -gt 0 ] && [ "$rows" -le 8 ] || {
    printf '%s\n' "FAILED: the table of situations of README.md has $rows rows, and these are not in situations.txt:" "$others"
    failed=1
}

# The command of the example for Spark, run on pieces of the rows (the last one empty) as Spark runs it on partitions.
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
command=$(sed -n 's/^COMMAND = "\(.*\)"$/\1/p' euroc-with-spark.py)
grep -v '^#' data/euroc.csv | split -l 5 - "$work/part-"
: > "$work/part-empty"
for part in "$work"/part-*; do
    $command < "$part" || failed=1
done > "$work/pieces"
rotconv -f quat -t rpy:deg --columns q_RS_w,q_RS_x,q_RS_y,q_RS_z < data/euroc.csv | sed 1d | cmp - "$work/pieces" || failed=1
! echo "1,0,0,0,1,0,0,lost" | $command 2>/dev/null || {
    echo "FAILED: the example for Spark does not notice a bad row"
    failed=1
}
exit "$failed"

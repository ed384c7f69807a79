#!/bin/sh
# check-situations.sh: what compare answers in fifteen situations that a check of attitudes meets; README.md shows some of them. The
# files are made from a TUM trajectory, truth.txt with the columns t qw qx qy qz.
set -eu
cd "$(dirname "$0")/data"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
grep -v '^#' tum_fr1_xyz.txt | cut -d ' ' -f 1,5-8 | rotconv -f quat:tum -t quat --columns 2-5 |
    sed '1i t qw qx qy qz' > "$work/truth.txt"
cd "$work"

made() { rotconv -f quat -t "$1" --columns 2-5 truth.txt; } # the truth in another representation
try() { # SITUATION OPTIONS-AND-FILE
    status=0
    eval "rotconv compare -t quat --reference-columns 2-5 --key t --within 0.3deg -p 3 $2 truth.txt" > answer 2> messages || status=$?
    [ "$status" -ne 2 ] || cp messages answer
    printf '| %s | `%s` | %s | %d |\n' "$1" "$2" "$(tail -n 1 answer)" "$status"
}

echo '| situation | options and FILE | last line | exit |'
echo '| --- | --- | --- | --- |'

made rpy:deg | awk 'NR > 1 { $2 += 0.1 * sin(NR); $3 += 0.1 * sin(2 * NR); $4 += 0.1 * sin(3 * NR) } 1' |
    sed '1s/.*/t r p y/' > noise.txt
try 'noise of 0.1 degrees' '-f rpy:deg --columns 2-4 noise.txt'
sed 's/^\(.*8.7058 [^ ]*\) [^ ]*/\1 5/' noise.txt > outlier.txt
try 'an outlier' '-f rpy:deg --columns 2-4 outlier.txt'
sed '5d;8d' truth.txt > dropped.txt
try 'dropped rows' '-f quat --columns 2-5 dropped.txt'
try 'dropped rows' '-f quat --columns 2-5 --allow-unpaired reference dropped.txt'
awk 'NR == 1 { print; next } NR % 3 == 2 { $1 = sprintf("%.4f", $1 + 0.002); print }' truth.txt > rate.txt
try 'another rate' '-f quat --columns 2-5 rate.txt'
try 'another rate' '-f quat --columns 2-5 --key-within 0.005 --allow-unpaired reference rate.txt'
awk 'NR > 1 { $1 = sprintf("%.4f", $1 + 60) } 1' truth.txt > late.txt
try 'an offset in time' '-f quat --columns 2-5 late.txt'
try 'an offset in time' '-f quat --columns 2-5 --key-offset -60 late.txt'
awk 'NR > 1 && NR % 2 { for (i = 2; i <= 5; ++i) $i = -$i } 1' truth.txt > flipped.txt
try 'flipped signs' '-f quat --columns 2-5 flipped.txt'
made quat | rotconv -f quat -t quat --columns 2-5 --right 'rpy:deg: 0 0 30' > mounted.txt
try 'a mounting' '-f quat --columns 2-5 mounted.txt'
try 'a mounting' '-f quat --columns 2-5 --align body mounted.txt'
rotconv -f quat -t quat --columns 2-5 --reference-axes enu:ned truth.txt > ned.txt
try 'NED against ENU' '-f quat --columns 2-5 ned.txt'
try 'NED against ENU' '-f quat --columns 2-5 --reference-axes ned:enu ned.txt'
made rpy:deg > degrees.txt
try 'the wrong unit' '-f rpy --columns 2-4 degrees.txt'
try 'the wrong unit' '-f rpy:deg --columns 2-4 degrees.txt'
made quat:xyzw > order.txt
try 'another order of columns' '-f quat --columns 2-5 order.txt'
try 'another order of columns' '-f quat --columns qw,qx,qy,qz order.txt'
awk 'NR == 4 { $2 = $3 = $4 = $5 = "nan" } 1' truth.txt > lost.txt
try 'nan rows' '-f quat --columns 2-5 lost.txt'
try 'nan rows' '-f quat --columns 2-5 --on-error skip lost.txt'
try 'nan rows' '-f quat --columns 2-5 --on-error skip --allow-failed lost.txt'
awk 'NR != 1 && NR != 6 { $2 = $3 = $4 = $5 = "nan" } 1' truth.txt > nans.txt
try 'all nan but one' '-f quat --columns 2-5 --on-error skip --allow-failed nans.txt'
awk 'NR > 2 { $1 = sprintf("%.4f", $1 + 0.003) } 1' truth.txt > met.txt
try 'one row met' '-f quat --columns 2-5 --allow-unpaired both met.txt'
head -n 4 truth.txt > died.txt
try 'ended after three rows' '-f quat --columns 2-5 --allow-unpaired reference died.txt'
try 'ended after three rows' '-f quat --columns 2-5 --allow-unpaired reference --min-pairs 10 died.txt'
: > empty.txt
try 'an empty file' '-f quat --columns 2-5 empty.txt'

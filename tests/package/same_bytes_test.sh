#!/bin/sh
# same_bytes_test.sh PROGRAM [COMMAND]...: the program prints the same bytes with one thread and with many, on a processor without
# AVX2 and FMA, and under a C library that does without them; and so does each COMMAND, a program of another compiler or, such as
# "qemu-aarch64 build/aarch64/rotconv", for another machine. 77, which is skipped, where something was left out.
set -eu
data=$(cd "$(dirname "$0")/../data" && pwd)
program=$(realpath "$1")
shift
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

specs="dcm dcm:passive 6d 5d quat axis-angle axis-angle:deg rotvec rotvec:deg cayley mrp rpy euler:zxz:deg"
sequences="XYX XYZ XZX XZY YXY YXZ YZX YZY ZXY ZXZ ZYX ZYZ"
sequences="$sequences $(echo "$sequences" | tr XYZ xyz)"

# Integers that are the same under every awk.
random='function uniform() { seed = seed * 16807 % 2147483647; return seed / 1073741823.5 - 1 }'
# Quaternions of all attitudes, and with vectors or scalars down to 1e-12.
awk "$random"' BEGIN {
    seed = 14
    for (i = 0; i < 160; ++i) {
        for (k = 0; k < 4; ++k) q[k] = uniform()
        for (k = i % 13; k > 0; --k)
            if (i % 3 == 1) q[0] /= 10
            else if (i % 3 == 2) { q[1] /= 10; q[2] /= 10; q[3] /= 10 }
        norm = sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3])
        printf "%.17g %.17g %.17g %.17g\n", q[0] / norm, q[1] / norm, q[2] / norm, q[3] / norm
    }
}' > "$work/attitudes"
awk "$random"' BEGIN { seed = 15; for (i = 0; i < 1500; ++i) printf "%.17g %.17g %.17g\n", uniform(), uniform(), uniform() }' > "$work/vectors"

# rows SPEC: the file of these attitudes in all digits, in four and in one, which is noise, and of those of attitudes.csv.
rows() {
    if [ ! -e "$work/$1" ]; then
        for digits in "" "-p 4" "-p 1"; do
            # shellcheck disable=SC2086 # no word or two
            "$program" -f quat -t "$1" --diagnostics off $digits "$work/attitudes"
        done > "$work/$1"
        awk -F, -v spec="$1" '$1 == spec { row = $3; for (i = 4; i <= 11 && $i != ""; ++i) row = row " " $i; print row }' \
            "$data/attitudes.csv" >> "$work/$1"
    fi
    echo "$work/$1"
}

# A line for each run: the part that it belongs to, and its arguments.
cases() {
    for from in $specs; do
        for to in $specs; do
            echo "conversion -f $from -t $to --diagnostics off $(rows "$from")"
        done
        echo "diagnostics -f $from -t rpy --diagnostics columns $(rows "$from")"
        echo "diagnostics -f quat -t $from --diagnostics columns $(rows quat)"
        echo "diagnostics -f quat -t $from --diagnostics rows $(rows quat)"
        echo "fast -f $from -t quat --method fast --diagnostics off $(rows "$from")"
        echo "fast -f quat -t $from --method fast --diagnostics off $(rows quat)"
    done
    for sequence in $sequences; do
        for spec in "euler:$sequence" "euler:$sequence:deg"; do
            echo "conversion -f $spec -t quat --diagnostics off $(rows "$spec")"
            echo "conversion -f quat -t $spec --diagnostics off $(rows quat)"
        done
    done
    for to in quat axis-angle:deg rotvec rpy:deg euler:ZXZ; do
        echo "conversion -f quat -t $to --continuous --diagnostics off $(rows quat)"
        echo "conversion -f dcm -t $to -d --left quat:.5,.5,.5,.5 --right rpy:10,20,30 --diagnostics off $(rows dcm)"
    done
    for format in "-p 6" "-p 17" "--format json" "--format f64" "--format pretty"; do
        echo "conversion -f quat -t rpy:deg --diagnostics off $format $(rows quat)"
    done

    echo "values -f rpy:deg -t quat 1° 0 0" # char has a sign here and none on aarch64

    for spec in dcm 6d 5d quat rotvec rotvec:deg cayley mrp rpy euler:ZYX:deg euler:zxz; do
        numbers=$(rows "$spec")
        head -n "$(wc -l < "$numbers")" "$work/vectors" | paste -d ' ' "$numbers" - > "$numbers-velocity"
        "$program" rates -f "$spec" --on-error nan --tolerance inf --diagnostics off "$numbers-velocity" 2> "$work/messages" |
            paste -d ' ' "$numbers" - > "$numbers-rates"
        echo "rates rates -f $spec --diagnostics columns $numbers-velocity"
        echo "rates rates -f $spec --inverse --frame reference --diagnostics off $numbers-rates"
    done
    head -n 300 "$work/vectors" | awk '{ print NR / 100, $0 }' > "$work/motion"
    for with in quat dcm 6d 5d rotvec mrp cayley euler:ZYX "quat --integrator magnus6" \
        "quat --integrator rk4 --interpolation cubic --renormalise" "mrp --substeps 3 --continuous"; do
        echo "propagate propagate -t rpy:deg --with $with --diagnostics columns $work/motion"
    done

    paste -d ' ' "$(rows rpy)" "$(rows quat)" | head -n 500 > "$work/both"
    head -n 60 "$work/both" > "$work/known"
    echo "survey survey -f quat $work/attitudes"
    echo "survey survey -f quat --format json $work/attitudes"
    echo "compare compare -f rpy -t quat $work/both"
    echo "compare compare -f rpy -t quat --format csv $work/both"
    echo "compose compose -f rpy --by quat:passive -t rpy:deg --diagnostics columns $work/both"
    echo "rotate rotate -f quat --diagnostics off $(rows quat)-velocity"
    echo "identify identify -t quat $work/known"
    for to in quat dcm 5d:passive rotvec:deg euler:ZYX:deg euler:xyx cayley mrp; do
        echo "sample sample -t $to --rows 6000"
    done
    echo "sample sample -t quat --kind scaled"
    echo "sample sample -t dcm --kind noise --noise 0.5"
    echo "sample sample -t axis-angle --kind many-turns --seed 1"
}
cases > "$work/cases"

# answer FILE COMMAND...: what it prints on both streams, and how it ends.
answer() {
    to=$1
    shift
    status=0
    case $* in
    *" sample "*) ;; # reads nothing
    *) set -- "$@" --on-error nan --tolerance inf ;;
    esac
    "$@" > "$to" 2> "$work/messages" < /dev/null || status=$?
    { grep -v '^wine: ' "$work/messages" || true; echo "exit $status"; } >> "$to" # wine's own, now and then
}

# answers COMMAND FOLDER: in all cases.
answers() {
    mkdir -p "$2"
    number=0
    while read -r _ arguments; do
        number=$((number + 1))
        # shellcheck disable=SC2086 # words
        answer "$2/$number" $1 $arguments
    done < "$work/cases"
}

# check COMMAND: its answers are those of the program.
check() {
    echo "$1:"
    answers "$1" "$work/found"
    number=0
    while read -r part arguments; do
        number=$((number + 1))
        if cmp -s "$work/expected/$number" "$work/found/$number"; then
            echo "same $part"
            continue
        fi
        echo "other $part"
        diff -a "$work/expected/$number" "$work/found/$number" > "$work/difference" || true
        echo "FAILED: rotconv $arguments: $(grep -ac '^>' "$work/difference") lines" >> "$work/failures"
        head -n 4 "$work/difference" >> "$work/failures"
    done < "$work/cases" > "$work/outcomes"
    sort "$work/outcomes" | uniq -c
}
: > "$work/failures"
answers "$program" "$work/expected"
if grep -ah -B 1 '^exit 2$' "$work"/expected/* || [ "$(cat "$work"/expected/* | wc -l)" -lt 100000 ]; then
    echo "FAILED: the cases do not run to their end, or have no rows"
    exit 1
fi

left_out=
if ! grep -qsw avx2 /proc/cpuinfo || ! grep -qsw fma /proc/cpuinfo; then
    left_out="this processor has no AVX2 and FMA to do without"
elif ! command -v qemu-x86_64 > /dev/null; then
    left_out="qemu-x86_64, which runs a program as if on an old processor, is not installed"
else
    check "qemu-x86_64 -cpu Nehalem $program"
    check "env GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2,-FMA $program"
fi
for command in "$@"; do
    check "$command"
done

# Many threads work on many blocks of text.
for _ in 1 2 3 4 5 6 7 8 9 10; do
    cat "$work/both"
done > "$work/long"
for arguments in "-f rpy -t dcm --columns 1-3" "-f quat -t rpy:deg --columns 4-7 --continuous" \
    "-f quat -t mrp --columns 4-7 --method fast --diagnostics columns" "rates -f rpy --columns 1-6" \
    "compare -f rpy -t quat --format csv"; do
    for threads in 1 7; do
        # shellcheck disable=SC2086 # words
        answer "$work/threads-$threads" "$program" $arguments "$work/long" --threads $threads
    done
    [ "$(wc -l < "$work/threads-1")" -gt 5000 ] && cmp "$work/threads-1" "$work/threads-7" ||
        echo "FAILED: rotconv $arguments with 7 threads" >> "$work/failures"
done

cat "$work/failures"
[ ! -s "$work/failures" ] || exit 1
[ -z "$left_out" ] || {
    echo "left out: $left_out"
    exit 77
}

#!/bin/sh
# survey-and-propagate.sh [FILE]: which set serves the motion of an EuRoC table? Its attitudes become angular velocities by
# differences, these are propagated in that set, and come back as attitudes: how far from those of the table?
set -eu
file=${1:-$(dirname "$0")/data/euroc_v102.csv}
columns=q_RS_w,q_RS_x,q_RS_y,q_RS_z
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

rotconv survey -f quat --columns $columns "$file" > "$work/sets" 2> "$work/notes" || {
    cat "$work/notes" >&2
    exit 1
}
set=$(tail -n 1 "$work/sets")
echo "The smallest set that serves: $set"

# Rows t,qw,qx,qy,qz, the signs as the motion goes on; of the nanoseconds the last 12 digits, which a double holds exactly, in seconds.
rotconv -f quat -t quat --continuous --columns $columns --diagnostics off "$file" |
    awk -F, 'NR > 1 { printf "%.9f,%s,%s,%s,%s\n", substr($1, length($1) - 11) / 1e9, $5, $6, $7, $8 }' > "$work/attitudes"

# Rows t, quaternion, its rate: the slope at the row of the parabola through it and its neighbours (at the ends, of the nearest).
awk -F, '
    function slope(t, i, x0, x1, x2,    a, b, c) { # of the parabola through rows i, i + 1, i + 2
        a = x0 * (2 * t - T[i + 1] - T[i + 2]) / ((T[i] - T[i + 1]) * (T[i] - T[i + 2]))
        b = x1 * (2 * t - T[i] - T[i + 2]) / ((T[i + 1] - T[i]) * (T[i + 1] - T[i + 2]))
        c = x2 * (2 * t - T[i] - T[i + 1]) / ((T[i + 2] - T[i]) * (T[i + 2] - T[i + 1]))
        return a + b + c
    }
    {
        T[NR] = $1
        for (k = 2; k <= 5; k++) Q[NR, k] = $k
    }
    END {
        for (i = 1; i <= NR; i++) {
            first = i == 1 ? 1 : i == NR ? NR - 2 : i - 1
            line = T[i]
            for (k = 2; k <= 5; k++) line = line "," Q[i, k]
            for (k = 2; k <= 5; k++) line = line sprintf(",%.17g", slope(T[i], first, Q[first, k], Q[first + 1, k], Q[first + 2, k]))
            print line
        }
    }' "$work/attitudes" > "$work/slopes"

rotconv rates -f quat --inverse --columns 2-9 --diagnostics off "$work/slopes" > "$work/velocities"
rotconv propagate -t quat --with "$set" --interpolation cubic --initial "quat: $(head -n 1 "$work/attitudes" | cut -d, -f2-)" \
    "$work/velocities" > "$work/propagated"

echo "The propagated attitudes against those of the table, at the same times, in radians:"
rotconv compare -f quat --columns 2-5 --key 1 -p 2 --diagnostics off "$work/propagated" "$work/attitudes"

#!/bin/sh
# survey-and-propagate.sh [FILE]: which set serves the motion of an EuRoC table? Its attitudes become angular velocities by
# differences, these are propagated in that set, and come back as attitudes: how far from those of the table?
set -eu
file=${1:-$(dirname "$0")/data/euroc.csv}
columns=q_RS_w,q_RS_x,q_RS_y,q_RS_z
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

rotconv survey -f quat --columns $columns "$file" > "$work/sets" 2> "$work/notes" || {
    cat "$work/notes" >&2
    exit 1
}
set=$(tail -n 1 "$work/sets")
echo "The smallest set that serves: $set"

# Rows t,qw,qx,qy,qz. Each row of differences has the angular velocity of the interval before it; the velocity at a row is the
# mean of the intervals before and after it.
cut -d, -f1,5-8 "$file" | rotconv -f quat -t quat --columns $columns > "$work/attitudes"
rotconv rates --differences -f quat --time-unit ns --columns 1-5 "$work/attitudes" |
    awk -F, -v OFS=, '
        NR > 2 { print t, (x + $2) / 2, (y + $3) / 2, (z + $4) / 2 }
        { t = $1; x = $2; y = $3; z = $4 }
        END { print }' > "$work/velocities"
rotconv propagate -t quat --with "$set" --interpolation cubic --time-unit ns \
    --initial "quat: $(sed -n 2p "$work/attitudes" | cut -d, -f2-)" "$work/velocities" > "$work/propagated"

echo "The propagated attitudes against those of the table, at the same times:"
rotconv compare -f quat --columns 2-5 --key 1 --within 0.1mrad -p 2 "$work/propagated" "$work/attitudes"

#!/bin/sh
# check-conversion.sh [GOLDEN]: the three checks that scripts need. Each prints its figures and a verdict; the exit status is 1 if
# one of them fails. Here each makes the file that it checks from the data.
set -eu
cd "$(dirname "$0")/data"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failed=0

# A conversion against a golden file, row by row of the same time, however either of them writes its angles.
golden() { # FILE GOLDEN
    rotconv compare -f rpy:deg --columns roll,pitch,yaw --key timestamp --within 1e-15rad "$1" "$2"
}

# An estimate against the truth, which has more rows and other times. All rows of the estimate must have a partner within 5 ms.
estimate() { # ESTIMATE TRUTH
    rotconv compare -f quat:tum -d --columns qx,qy,qz,qw --key timestamp --key-within 0.005 --allow-unpaired reference \
        --within 0.5deg --within 0.3deg@95 --diagnostics off "$1" "$2"
}

# PX4's attitudes (north, east, down; forward, right, down) against ROS's (east, north, up; forward, left, up).
convention() { # FILE REFERENCE
    rotconv compare -f quat -t quat:tum --columns 2-5 --reference-columns 5-8 --key 1 --reference-axes ned:enu --body-axes frd:flu \
        --within 1e-12deg "$1" "$2"
}

echo "A conversion against a golden file:"
rotconv -f quat:tum -t rpy:deg --columns 5-8 tum_fr1_xyz.txt > "$work/angles"
golden "$work/angles" "${1:-tum_fr1_xyz_rpy.txt}" || failed=1

echo "An estimate, of each third row, 2 ms late and 0.2 degrees off, against the truth:"
rotconv -f quat:tum -t quat:tum --columns 5-8 --right 'rotvec:deg: 0 0.2 0' tum_fr1_xyz.txt |
    awk '/^#/ { print; next } ++row % 3 == 1 { $1 = sprintf("%.4f", $1 + 0.002); print }' > "$work/estimate"
estimate "$work/estimate" tum_fr1_xyz.txt || failed=1

echo "The same attitudes in the axes of PX4 and of ROS:"
cut -d ' ' -f 1,5-8 tum_fr1_xyz.txt |
    rotconv -f quat:tum -t quat --columns 2-5 --reference-axes enu:ned --body-axes flu:frd > "$work/px4"
convention "$work/px4" tum_fr1_xyz.txt || failed=1
exit "$failed"

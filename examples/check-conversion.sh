#!/bin/sh
# check-conversion.sh [GOLDEN]: a regression check. A TUM trajectory becomes roll, pitch and yaw; the result must agree with a
# golden file, row by row of the same time, to 1e-15 rad, however either of them writes its angles.
set -eu
cd "$(dirname "$0")/data"
golden=${1:-tum_fr1_xyz_rpy.txt}
rotconv -f quat:tum -t rpy:deg --columns 5-8 --diagnostics off tum_fr1_xyz.txt |
    rotconv compare -f rpy:deg --columns roll,pitch,yaw --key timestamp --within 1e-15 - "$golden"

#!/bin/sh
# EuRoC ground truth: the quaternion columns, by name, become the matrix; the header follows.
set -eu
cd "$(dirname "$0")/data"
rotconv -f quat -t dcm --columns q_RS_w,q_RS_x,q_RS_y,q_RS_z euroc.csv

#!/bin/sh
# KITTI poses (3x4 matrices [R t] row by row): the quaternion of R is appended to each row.
set -eu
cd "$(dirname "$0")/data"
rotconv -f dcm -t quat --columns 1-3,5-7,9-11 --append kitti.txt

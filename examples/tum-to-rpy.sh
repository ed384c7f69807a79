#!/bin/sh
# TUM trajectories (timestamp tx ty tz qx qy qz qw): the quaternion becomes roll, pitch and yaw in degrees; all else passes.
set -eu
cd "$(dirname "$0")/data"
rotconv -f quat:tum -t rpy:deg --columns 5-8 tum_fr1_xyz.txt

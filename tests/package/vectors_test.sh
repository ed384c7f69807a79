#!/bin/sh
# vectors_test.sh FOLDER: two of the examples with vectors, by SciPy, and the lines of Python in the README. Catches the inverse,
# columns that are taken for each other, and lines that do not run.
set -eu
cd "$1"
for python in python3 /usr/bin/python3 ""; do
    [ -n "$python" ] || {
        echo "SciPy is not installed"
        exit 77
    }
    ! "$python" -c 'import scipy.spatial' 2> /dev/null || break
done
bias=$(rotconv rotate -f quat --columns q_RS_w,q_RS_x,q_RS_y,q_RS_z,b_a_RS_S_x,b_a_RS_S_y,b_a_RS_S_z euroc.csv |
    sed '/^#/d' | tr -d '\r' | awk -F , 'NF > 9 { print $5, $6, $7; next } { exit 1 }' | tr '\n' ';')
sight=$(grep -v '^#' tum_fr1_xyz.txt | sed 's/$/ 0 0 1/' |
    rotconv rotate -f quat:tum --columns 5-11 --diagnostics off | cut -d ' ' -f 5-7 | tr '\n' ';')
BIAS=$bias SIGHT=$sight "$python" - <<'END'
import os
import numpy as np
from scipy.spatial.transform import Rotation

def rows_of(name):
    return np.array([[float(x) for x in row.split()] for row in os.environ[name].strip(";").split(";")])

euroc = np.loadtxt("euroc.csv", delimiter=",")
tum = np.loadtxt("tum_fr1_xyz.txt")
bias = Rotation.from_quat(np.roll(euroc[:, 4:8], -1, axis=1)).apply(euroc[:, 14:17])
sight = Rotation.from_quat(tum[:, 4:8]).apply([0, 0, 1])
assert rows_of("BIAS").shape == bias.shape and rows_of("SIGHT").shape == sight.shape
worst = max(np.abs(rows_of("BIAS") - bias).max(), np.abs(rows_of("SIGHT") - sight).max())
assert worst < 1e-15, worst
END
{
    sed -n '/^```python$/,/^```$/{/^```/!p;}' ../../README.md
    echo 'turn = np.degrees(2 * np.arctan2(0.6, 0.8))'
    echo 'assert np.allclose(angles, [[0, 0, turn], [0, turn, 0]], rtol=0, atol=1e-12), angles'
} | "$python" -

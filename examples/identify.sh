#!/bin/sh
# What do the numbers of another program mean? Each row has them first, and then the same attitude in a convention that is known.
set -eu

echo "Four numbers called a quaternion, with roll, pitch and yaw in degrees; is the scalar first or last?"
rotconv identify -t rpy:deg <<END | tail -n 1
0 0 0.6 0.8       0 0 73.7398
0.6 0 0 0.8       73.7398 0 0
0.5 0.5 0.5 0.5   90 0 90
END

echo
echo "Three angles called roll, pitch and yaw, and a matrix with six digits: turns about the body's axes or about fixed ones?"
echo "(rpy of columns 1-3 is euler:ZYX of columns 3,2,1)"
rotconv identify -t dcm <<END | tail -n 1
10 20 30     0.813798 -0.44097 0.378522  0.469846 0.882564 0.0180283  -0.34202 0.163176 0.925417
-50 60 100   -0.0868241 -0.517822 -0.851071  0.492404 -0.764954 0.415191  -0.866025 -0.383022 0.321394
END

echo
echo "A matrix and the quaternion that it should mean: is it transposed?"
rotconv identify -t quat <<END | tail -n 1
0 1 0  -1 0 0  0 0 1   0.707107 0 0 0.707107
1 0 0  0 0 1  0 -1 0   0.707107 0.707107 0 0
END

echo
echo "Rows that do not tell:"
rotconv identify -t dcm <<END | tail -n 1
0 0 90   0 -1 0  1 0 0  0 0 1
0 0 180  -1 0 0  0 -1 0  0 0 1
END

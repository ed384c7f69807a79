#!/bin/sh
# The worked examples of the conversion of direction cosines to Euler parameters after Baruh (Analytical Dynamics, 1999), with the
# digits printed there. His [R] takes reference to body, his parameters are (e1, e2, e3, e4) with the scalar last.
set -eu

echo "Example 1: 350 degrees about (2, -3, 6)/7"
echo "[R]:"
rotconv -f axis-angle:deg:baruh -t dcm:baruh -p 6 2 -3 6 350
echo "e1 e2 e3 e4 (the negatives of those put in are the same attitude):"
rotconv -f axis-angle:deg:baruh -t quat:baruh -p 5 2 -3 6 350
echo "axis and angle from the printed matrix:"
rotconv -f dcm:baruh -t axis-angle:deg:baruh -p 5 --diagnostics off \
    0.986048 -0.150702 -0.070700 0.146981 0.987598 -0.055195 0.078141 0.044033 0.995969

echo
echo "Example 2: -250 degrees about (2, -3, 6)/7"
echo "[R]:"
rotconv -f axis-angle:deg:baruh -t dcm:baruh -p 6 2 -3 6 -250
echo "e1 e2 e3 e4:"
rotconv -f axis-angle:deg:baruh -t quat:baruh -p 6 2 -3 6 -250
echo "axis and angle from the printed matrix:"
rotconv -f dcm:baruh -t axis-angle:deg:baruh -p 6 --diagnostics off \
    -0.232467 0.641122 0.731383 -0.969780 -0.095527 -0.224503 -0.074067 -0.761471 0.643954

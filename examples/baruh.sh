#!/bin/sh
# The worked examples of the conversion of direction cosines to Euler parameters after Baruh (Analytical Dynamics, 1999), with the
# digits printed there. His [R] takes reference to body, his parameters are (e1, e2, e3, e4) with the scalar last.
set -eu

# Six decimals, as the document prints them.
six_decimals() {
    awk '{ for (i = 1; i <= NF; i++) printf "%.6f%s", $i, i < NF ? " " : "\n" }'
}

echo "Example 1: 350 degrees about (2, -3, 6)/7"
echo "[R]:"
rotconv -f axis-angle:deg:baruh -t dcm:baruh 2 -3 6 350 | six_decimals
echo "e1 e2 e3 e4 (the negatives of those put in are the same attitude):"
rotconv -f axis-angle:deg:baruh -t quat:baruh 2 -3 6 350 | six_decimals
echo "axis and angle from the matrix:"
rotconv -f axis-angle:deg:baruh -t dcm:baruh 2 -3 6 350 | rotconv -f dcm:baruh -t axis-angle:deg:baruh | six_decimals

echo
echo "Example 2: -250 degrees about (2, -3, 6)/7"
echo "[R]:"
rotconv -f axis-angle:deg:baruh -t dcm:baruh 2 -3 6 -250 | six_decimals
echo "e1 e2 e3 e4:"
rotconv -f axis-angle:deg:baruh -t quat:baruh 2 -3 6 -250 | six_decimals
echo "axis and angle from the matrix:"
rotconv -f axis-angle:deg:baruh -t dcm:baruh 2 -3 6 -250 | rotconv -f dcm:baruh -t axis-angle:deg:baruh | six_decimals

#!/bin/sh
# Two singular attitudes of Stuelpnagel, On the Parametrization of the Three-Dimensional Rotation Group, SIAM Review 6(4), 1964.
set -eu

echo "Gimbal lock (section 6): with x7 = -1, so theta = pi/2, only -phi + psi is defined, here by x5 = 0.6, -x2 = 0.8."
echo "X, row by row -> roll pitch yaw in degrees; psi = 0 is a choice, and is reported:"
rotconv -f dcm:stuelpnagel -t rpy:stuelpnagel:deg -p 6 --diagnostics rows 0 0 -1 -0.8 0.6 0 0.6 0.8 0

echo
echo "A half-turn (section 6, trace -1) has two exponential vectors S and -S:"
rotconv -f dcm:stuelpnagel -t rotvec:stuelpnagel:deg --diagnostics rows -1 0 0 0 -1 0 0 0 1
echo "and no finite Cayley vector:"
rotconv -f dcm:stuelpnagel -t cayley:stuelpnagel --diagnostics rows -1 0 0 0 -1 0 0 0 1
echo "while the five numbers of section 4 know no singular attitude:"
rotconv -f dcm:stuelpnagel -t 5d:stuelpnagel -p 6 -1 0 0 0 -1 0 0 0 1

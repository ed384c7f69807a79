#!/usr/bin/env python3
"""textbook.py rpy|quat|rotvec|version: matrices of standard input, one a line, to SPEC by the formulas of textbooks, in NumPy."""
import sys

import numpy as np

if sys.argv[1] == "version":
    sys.exit(print("textbook in NumPy", np.__version__))
np.seterr(all="ignore")
R = np.loadtxt(sys.stdin, delimiter=",").reshape(-1, 3, 3)
trace = np.trace(R, axis1=1, axis2=2)
axis = np.stack([R[:, 2, 1] - R[:, 1, 2], R[:, 0, 2] - R[:, 2, 0], R[:, 1, 0] - R[:, 0, 1]])
if sys.argv[1] == "rpy":
    out = np.arctan2(R[:, 2, 1], R[:, 2, 2]), np.arcsin(-R[:, 2, 0]), np.arctan2(R[:, 1, 0], R[:, 0, 0])
elif sys.argv[1] == "quat":
    w = np.sqrt(1 + trace) / 2
    out = w, *(axis / (4 * w))
else:
    angle = np.arccos((trace - 1) / 2)
    out = axis * angle / (2 * np.sin(angle))
np.savetxt(sys.stdout, np.transpose(out), delimiter=",", fmt="%.17g")

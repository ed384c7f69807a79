#!/usr/bin/env python3
"""scipy_rotation.py euler:ZYX|quat:xyzw|rotvec|version: matrices of standard input, one a line, to SPEC by SciPy's Rotation."""
import sys
import warnings

import numpy as np
import scipy
from scipy.spatial.transform import Rotation

if sys.argv[1] == "version":
    sys.exit(print("SciPy", scipy.__version__))
warnings.simplefilter("ignore")  # of gimbal lock
attitudes = Rotation.from_matrix(np.loadtxt(sys.stdin, delimiter=",").reshape(-1, 3, 3))
if sys.argv[1] == "euler:ZYX":
    out = attitudes.as_euler("ZYX")
else:
    out = attitudes.as_rotvec() if sys.argv[1] == "rotvec" else attitudes.as_quat()
np.savetxt(sys.stdout, out, delimiter=",", fmt="%.17g")

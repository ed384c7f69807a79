# python3 pandas_scipy.py: SciPy's rotations, read and written by pandas as it does unless told otherwise.

import sys

import pandas
from scipy.spatial.transform import Rotation

matrices = pandas.read_csv(sys.stdin, header=None).to_numpy().reshape(-1, 3, 3)
angles = Rotation.from_matrix(matrices).as_euler("xyz", degrees=True)
pandas.DataFrame(angles).to_csv(sys.stdout, header=False, index=False)

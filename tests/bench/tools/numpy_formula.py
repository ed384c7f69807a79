# python3 numpy_formula.py: the textbook's formula, with NumPy's own reader and writer of text.

import sys

import numpy

m = numpy.loadtxt(sys.stdin, delimiter=",")
roll = numpy.arctan2(m[:, 7], m[:, 8])
pitch = numpy.arctan2(-m[:, 6], numpy.hypot(m[:, 7], m[:, 8]))
yaw = numpy.arctan2(m[:, 3], m[:, 0])
numpy.savetxt(sys.stdout, numpy.degrees(numpy.column_stack((roll, pitch, yaw))), fmt="%.17g", delimiter=",")

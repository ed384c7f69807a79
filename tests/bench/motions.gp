# The motions of the charts, each with its definition in a line.

motions = "'spin' 'coning' 'symmetric body' 'gentle' 'through lock' 'tumbling'"
definitions = "'1.5 rad/s about one axis' 'an axis 0.1 rad off the vertical, 5 rad/s round it' " \
    . "'precession 1.1, spin 0.9 rad/s, nutation 0.7 rad' 'yaw, pitch and roll swing by up to 0.6 rad' " \
    . "'pitch grows by 1 rad/s, past 90° at 1.6 s' 'up to 3 rad/s about changing axes'"

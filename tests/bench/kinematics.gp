# The charts of bench_kinematics' figures: gnuplot -e "csv='kinematics.csv'" -e "out='DIRECTORY'" kinematics.gp

load "common.gp"
load "motions.gp"

# columns: 1 kind, 2 motion, 3 set, 4 integrator, 5 step, 6 renormalised, 7 time, 8 error, 9 ns_per_second, 11 defect
set datafile missing NaN

# One line a way, at most eight: kinematics.csv has all. Sets of three numbers are dashed.
n = 8
array set_of[n] = ["dcm", "5d", "quat", "rotvec", "mrp", "cayley", "euler:ZYX", "quat"]
array by[n] = ["rk4", "rk4", "rk4", "rk4", "rk4", "rk4", "rk4", "magnus6"]
array way_colour[n] = ["#1769aa", "#0b7d7f", "#222222", "#1f8a4d", "#6b7a12", "#7b3fb5", "#8c5a3c", "#c1121f"]
array dash[n] = [1, 1, 1, 2, 2, 2, 2, 1]
named(i) = by[i] eq "rk4" ? set_of[i] : set_of[i] . ", " . by[i]
of_way(i, kind, motion) = stringcolumn(1) eq kind && stringcolumn(2) eq motion && \
    stringcolumn(3) eq set_of[i] && stringcolumn(4) eq by[i] && column(6) == 0

# What ends at a singularity, in words.
why(set) = set eq "cayley" ? "half-turn" : "lock"

set dashtype 2 (6,3)
set logscale xy
set grid lc rgb "#e6e6e6" lw 0.5

# --- Work and precision --------------------------------------------------------------------------------------------

high = 950
wide = 294.0
tall = 200.0
names_left = 1
name_x = 98
kind = "work"
finest = 0.000625
axis = 9
what = 8
x_low = 5.0
x_high = 1e6
y_low = 1e-16
y_high = 1.0
x_title = "computing time, ns a simulated second"
y_title = "largest error of attitude, rad"
heading = "In the same time, exponential steps gain about four digits over Runge-Kutta"
eval begin("work-precision")
set xtics ("10^3" 1e3, "10^4" 1e4, "10^5" 1e5, "10^6" 1e6) scale 0.4 nomirror font small tc rgb ink offset 0,0.3
set ytics ("10^{-15}" 1e-15, "10^{-12}" 1e-12, "10^{-9}" 1e-9, "10^{-6}" 1e-6, "10^{-3}" 1e-3, "1" 1) scale 0.4 nomirror font small tc rgb ink
set multiplot
set label 1 heading at screen 0.5,down(18) center font sized(16) tc rgb ink
set label 2 "Runge-Kutta steps of 0.08 s (left) to 0.6 ms (right);  magnus6: exponential steps;  dashed: sets of three numbers" \
    at screen 0.5,down(42) center tc rgb ink
do for [p = 1:6] {
    motion = word(motions, p)
    over = motion
    defined = word(definitions, p)
    left = 74 + (p - 1) % 2 * 375
    top = 106 + (p - 1) / 2 * 290
    load "kinematics-panel.gp"
}
unset multiplot
unset output
system described(heading, "Six panels, one a motion: the largest error of eight ways to integrate the attitude by their computing " \
    . "time. The exponential steps of the quaternion are right to the last digits at the least time. The figures are in kinematics.csv.")

# --- Error and drift against time ----------------------------------------------------------------------------------

high = 646
wide = 184.0
names_left = 0
name_x = wide + 22
kind = "drift"
finest = 0.01
axis = 7
x_low = 1.0
x_high = 1e4
x_title = "simulated time, s"
heading = "Error and drift: a million steps of 0.01 s"
eval begin("drift")
set xtics ("1" 1, "10" 10, "100" 100, "1000" 1e3, "10^4" 1e4)
set multiplot
set label 1 heading at screen 0.5,down(18) center font sized(16) tc rgb ink
set label 2 "Runge-Kutta steps;  magnus6: exponential steps;  dashed: sets of three numbers, which have nothing to drift off" at screen 0.5,down(42) center tc rgb ink
do for [p = 1:4] {
    motion = p % 2 == 1 ? "gentle" : "tumbling"
    what = p > 2 ? 11 : 8
    over = motion . (p > 2 ? ": drift" : ": error")
    defined = word(definitions, place_in(motions, motion))
    y_title = p > 2 ? "distance of the numbers from the set" : "largest error so far, rad"
    y_low = 1e-16
    y_high = p == 1 ? 1e-7 : p == 2 ? 1.0 : 1e-4
    left = 74 + (p - 1) % 2 * 374
    top = 106 + (p - 1) / 2 * 290
    load "kinematics-panel.gp"
}
unset multiplot
unset output
system described(heading, "Four panels: the error of eight ways to integrate a gentle and a tumbling motion for 10000 s, and how far " \
    . "the numbers of the larger sets drift off. The exponential steps of the quaternion err and drift least. The figures are in kinematics.csv.")

# The charts of bench_kinematics' figures: gnuplot -e "csv='kinematics.csv'" -e "out='DIRECTORY'" kinematics.gp

load "common.gp"
load "motions.gp"

# columns: 1 kind, 2 motion, 3 set, 4 integrator, 5 step, 6 renormalised, 7 time, 8 error, 9 ns_per_second, 11 defect
set datafile missing NaN

# One line a way, at most eight: kinematics.csv has all. The singular sets are dashed.
n = 8
array set_of[n] = ["dcm", "5d", "quat", "rotvec", "mrp", "cayley", "euler:ZYX", "quat"]
array by[n] = ["rk4", "rk4", "rk4", "rk4", "rk4", "rk4", "rk4", "magnus6"]
array way_colour[n] = ["#1769aa", "#0f8b8d", "#222222", "#2a9d5c", "#8c9b2f", "#7b3fb5", "#8c5a3c", "#c1121f"]
array dash[n] = [1, 1, 1, 2, 2, 2, 2, 1]
named(i) = by[i] eq "rk4" ? set_of[i] : by[i]
of_way(i, kind, motion) = stringcolumn(1) eq kind && stringcolumn(2) eq motion && \
    stringcolumn(3) eq set_of[i] && stringcolumn(4) eq by[i] && column(6) == 0

# What ends at a singularity, in words.
why(set) = set eq "cayley" ? "half-turn" : "lock"

set dashtype 2 (6,3)
set logscale xy
set grid lc rgb "#e6e6e6" lw 0.5

# --- Work and precision --------------------------------------------------------------------------------------------

high = 960
wide = 294.0
tall = 200.0
names_left = 1
name_x = 78
kind = "work"
finest = 0.000625
axis = 9
what = 8
x_low = 13.0
x_high = 1e6
y_low = 1e-16
y_high = 1.0
x_title = "computing time, ns a simulated second"
y_title = "largest error of attitude, rad"
eval begin("work-precision")
set xtics ("10^3" 1e3, "10^4" 1e4, "10^5" 1e5, "10^6" 1e6) scale 0.4 nomirror font small tc rgb ink offset 0,0.3
set ytics ("10^{-15}" 1e-15, "10^{-12}" 1e-12, "10^{-9}" 1e-9, "10^{-6}" 1e-6, "10^{-3}" 1e-3, "1" 1) scale 0.4 nomirror font small tc rgb ink
set multiplot
set label 1 "Work and precision: 20 s of six motions" at screen 0.5,down(18) center font sized(16) tc rgb ink
set label 2 "Runge-Kutta steps (rk4) from 0.08 s on the left to 0.6 ms; the quaternion's exponential steps (magnus6) too" \
    at screen 0.5,down(42) center tc rgb ink
do for [p = 1:6] {
    motion = word(motions, p)
    heading = motion
    defined = word(definitions, p)
    left = 72 + (p - 1) % 2 * 380
    top = 106 + (p - 1) / 2 * 290
    load "kinematics-panel.gp"
}
unset multiplot
unset output

# --- Error and drift against time ----------------------------------------------------------------------------------

high = 670
wide = 190.0
names_left = 0
name_x = wide + 26
kind = "drift"
finest = 0.01
axis = 7
x_low = 1.0
x_high = 1e4
x_title = "simulated time, s"
eval begin("drift")
set xtics ("1" 1, "10" 10, "100" 100, "1000" 1e3, "10^4" 1e4)
set multiplot
set label 1 "Error and drift: a million steps of 0.01 s" at screen 0.5,down(18) center font sized(16) tc rgb ink
set label 2 "Runge-Kutta steps (rk4), and the quaternion's exponential steps (magnus6)" at screen 0.5,down(42) center tc rgb ink
do for [p = 1:3] {
    motion = p == 1 ? "gentle" : "tumbling"
    what = p == 3 ? 11 : 8
    heading = p == 1 ? "gentle" : p == 2 ? "tumbling" : "tumbling: drift off the set"
    defined = p == 1 ? word(definitions, 4) : word(definitions, 6)
    y_title = p == 3 ? "defect of the numbers" : "largest error so far, rad"
    y_low = 1e-16
    y_high = p == 3 ? 1e-4 : 1.0
    left = 72 + (p - 1) % 2 * 376
    top = 106 + (p - 1) / 2 * 290
    load "kinematics-panel.gp"
}
left = 72 + 376
top = 106 + 290
set label 1 "Sets with more numbers than an attitude" at screen across(left),down(top + 20) left tc rgb ink
set label 2 "needs leave it by rounding and by each" at screen across(left),down(top + 38) left tc rgb ink
set label 3 "step's error; renormalising takes the drift" at screen across(left),down(top + 56) left tc rgb ink
set label 4 "away, and none of the error above." at screen across(left),down(top + 74) left tc rgb ink
unset border
unset tics
unset grid
plot NaN
unset multiplot
unset output

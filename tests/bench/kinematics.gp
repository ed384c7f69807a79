# The charts of bench_kinematics' figures: gnuplot -e "csv='kinematics.csv'" -e "out='DIRECTORY'" kinematics.gp

set datafile separator comma
set datafile missing NaN
# columns: 1 kind, 2 motion, 3 set, 4 integrator, 5 step, 6 renormalised, 7 time, 8 error, 9 ns_per_second, 11 defect
set encoding utf8

ink = "#333333"

# One line a way: set, integrator, colour, dash, symbol; the singular sets are dashed.
n = 10
array set_of[n] = ["dcm", "6d", "5d", "quat", "rotvec", "mrp", "cayley", "euler:ZYX", "quat", "quat"]
array by[n] = ["rk4", "rk4", "rk4", "rk4", "rk4", "rk4", "rk4", "rk4", "magnus4", "magnus6"]
array colour[n] = ["#1f4e9c", "#4a90d9", "#7bc4c4", "#222222", "#2e8b57", "#8fbc3f", "#b07aa1", "#c08a3e", "#f08060", "#d1495b"]
array dash[n] = [1, 1, 1, 1, 2, 2, 2, 2, 1, 1]
array symbol[n] = [5, 4, 8, 7, 9, 11, 2, 1, 13, 13]
named(i) = set_of[i] . " " . by[i]

of_way(i, kind, motion, renormalised) = stringcolumn(1) eq kind && stringcolumn(2) eq motion && \
    stringcolumn(3) eq set_of[i] && stringcolumn(4) eq by[i] && column(6) == renormalised

# Those that no step brings to the end of the motion; `finest` is the least step of the kind.
fails(kind, motion, finest) = stringcolumn(1) eq kind && stringcolumn(2) eq motion && column(5) == finest && \
    stringcolumn(12) eq "singular"

set dashtype 2 (5,3)
set logscale xy
set border 3 lc rgb ink
set tics nomirror scale 0.5 tc rgb ink
set grid lc rgb "#e4e4e4" lw 0.5
unset key

do for [terminal in "svg pngcairo"] {
    # --- Work and precision --------------------------------------------------
    if (terminal eq "svg") {
        set terminal svg size 900,760 font "DejaVu Sans,11" background "white" enhanced
        set output out . "/work-precision.svg"
    } else {
        set terminal pngcairo size 900,760 font "DejaVu Sans,9" background "white" enhanced
        set output out . "/work-precision.png"
    }
    motions = "'spin' 'coning' 'symmetric body' 'gentle' 'through lock' 'tumbling'"
    set multiplot
    set label 1 "Work and precision: 20 s of six motions, steps from 0.08 s to 0.6 ms" at screen 0.5,0.98 center font ",12" tc rgb ink
    set label 2 "across: computing time, ns a simulated second;  up: largest attitude error, rad" at screen 0.5,0.03 center tc rgb ink
    do for [i = 1:n] {
        x = 0.06 + ((i - 1) % 5) * 0.19
        y = 0.945 - ((i - 1) / 5) * 0.026
        set arrow i from screen x, y to screen x + 0.045, y nohead lc rgb colour[i] lw 1.8 dt dash[i]
        set label 10 + i named(i) at screen x + 0.055, y left tc rgb ink
        set label 30 + i "" at screen x + 0.0225, y point lc rgb colour[i] pt symbol[i] ps 0.7
    }
    do for [p = 1:6] {
        motion = word(motions, p)
        left = 0.075 + ((p - 1) % 3) * 0.315
        top = 0.855 - ((p - 1) / 3) * 0.415
        set lmargin at screen left
        set rmargin at screen left + 0.28
        set tmargin at screen top
        set bmargin at screen top - 0.325
        set xrange [5e2:1e6]
        set yrange [1e-16:1]
        set xtics ("10^3" 1e3, "10^4" 1e4, "10^5" 1e5, "10^6" 1e6)
        if ((p - 1) % 3 == 0) {
            set ytics ("10^{-15}" 1e-15, "10^{-12}" 1e-12, "10^{-9}" 1e-9, "10^{-6}" 1e-6, "10^{-3}" 1e-3, "1" 1)
        } else {
            set ytics ("" 1e-15, "" 1e-12, "" 1e-9, "" 1e-6, "" 1e-3, "" 1)
        }
        set title motion font ",11" tc rgb ink offset 0,-0.6
        names = ""
        stats csv using (fails("work", motion, 0.000625) ? (names = names . "  " . stringcolumn(3), 1e-3) : 1e-3) nooutput
        if (names ne "") {
            set label 50 "singular:" . names at graph 0.98,0.95 right tc rgb "#8a8f98"
        }
        plot for [i = 1:n] csv using (of_way(i, "work", motion, 0) ? column(9) : NaN):8 with linespoints \
            lc rgb colour[i] lw 1.6 dt dash[i] pt symbol[i] ps 0.55
        unset arrow
        unset label
    }
    unset multiplot

    # --- Error and drift against time ----------------------------------------
    if (terminal eq "svg") {
        set terminal svg size 900,480 font "DejaVu Sans,11" background "white" enhanced
        set output out . "/drift.svg"
    } else {
        set terminal pngcairo size 900,480 font "DejaVu Sans,9" background "white" enhanced
        set output out . "/drift.png"
    }
    set multiplot
    set label 1 "A million steps of 0.01 s" at screen 0.5,0.97 center font ",12" tc rgb ink
    set label 2 "across: simulated time, s" at screen 0.5,0.025 center tc rgb ink
    set xrange [1:1e4]
    set xtics ("1" 1, "10" 10, "100" 100, "1000" 1e3, "10^4" 1e4)
    do for [i = 1:n] {
        x = 0.06 + ((i - 1) % 5) * 0.19
        y = 0.91 - ((i - 1) / 5) * 0.042
        set arrow i from screen x, y to screen x + 0.045, y nohead lc rgb colour[i] lw 1.8 dt dash[i]
        set label 10 + i named(i) at screen x + 0.055, y left tc rgb ink
    }
    do for [p = 1:3] {
        set lmargin at screen 0.075 + (p - 1) * 0.315
        set rmargin at screen 0.075 + (p - 1) * 0.315 + 0.265
        set tmargin at screen 0.76
        set bmargin at screen 0.12
        if (p < 3) {
            set yrange [1e-16:1e-2]
            set ytics ("10^{-16}" 1e-16, "10^{-12}" 1e-12, "10^{-8}" 1e-8, "10^{-4}" 1e-4)
            set title (p == 1 ? "gentle: error, rad" : "tumbling: error, rad") font ",11" tc rgb ink offset 0,-0.6
            motion = p == 1 ? "gentle" : "tumbling"
            names = ""
            stats csv using (fails("drift", motion, 0.01) ? (names = names . "  " . stringcolumn(3), 1e-3) : 1e-3) nooutput
            if (names ne "") {
                set label 50 "singular:" . names at graph 0.98,0.95 right tc rgb "#8a8f98"
            }
            plot for [i = 1:n] csv using (of_way(i, "drift", motion, 0) ? column(7) : NaN):8 with lines \
                lc rgb colour[i] lw 1.8 dt dash[i]
        } else {
            set title "tumbling: drift off the set" font ",11" tc rgb ink offset 0,-0.6
            plot for [i = 1:n] csv using (of_way(i, "drift", "tumbling", 0) && column(11) > 0 ? column(7) : NaN):11 \
                with lines lc rgb colour[i] lw 1.8 dt dash[i]
        }
        unset arrow
        unset label
    }
    unset multiplot
}

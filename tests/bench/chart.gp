# The charts of bench_methods' figures: gnuplot -e "csv='methods.csv'; out='DIRECTORY'" chart.gp

set datafile separator comma
# columns: 1 from, 2 to, 3 method, 4 stratum, 6 distance, 8 not_finite, 9 worst, 11 relative, 15 x_eigen
set encoding utf8

strong = "#d1495b"
plain = "#8a8f98"
ink = "#333333"
worst_shown = 1e17
half_turn = pi / 2.0**-52

# Where a row has no finite result it stands at the top.
clamp(error) = error < 0.3 ? 0.3 : error > worst_shown ? worst_shown : error
shown(error, not_finite) = not_finite > 0 ? worst_shown : clamp(error)

pairs = "dcm-quat dcm-rotvec dcm-cayley quat-dcm quat-rotvec quat-euler rotvec-dcm cayley-dcm"
floors = "0.83 1.4 0.5 0.39 1.4 2 0.39 0.39"
titles = "'dcm to quat' 'dcm to rotvec' 'dcm to cayley' 'quat to dcm' 'quat to rotvec' 'quat to euler' 'rotvec to dcm' 'cayley to dcm'"

of_pair(pair) = stringcolumn(1) . "-" . stringcolumn(2) eq pair

# --- Time and error ----------------------------------------------------------

# Labels stand in a column on the right in the order of their dots, at least a line apart, so that none hides another.
x_low = 0.1
x_high = 100.0
x_label = 130.0 # where the labels begin
y_low = 0.1
y_high = 1e18
line = (log10(y_high) - log10(y_low)) / 27.0

array name[40]
array xv[40]
array yv[40]
array zv[40]
array at[40]

do for [terminal in "svg pngcairo"] {
    if (terminal eq "svg") {
        set terminal svg size 900,860 font "DejaVu Sans,10" background "white" enhanced
        set output out . "/speed.svg"
    } else {
        set terminal pngcairo size 900,860 font "DejaVu Sans,8" background "white" enhanced
        set output out . "/speed.png"
    }
    set multiplot
    set label 1 "Time against Eigen and worst error of every method" at screen 0.5,0.985 center font ",12" tc rgb ink
    set label 2 "● clean input   ▲ hostile input (noise, scale, many turns); at the top: some rows without a finite result" \
        at screen 0.5,0.962 center tc rgb ink
    set label 3 "across: time of one row / Eigen's;  up: worst attitude error, units of 2^{-52} rad" \
        at screen 0.5,0.012 center tc rgb ink
    do for [p = 1:8] {
        pair = word(pairs, p)
        names = ""
        xs = ""
        ys = ""
        zs = ""
        stats csv using (of_pair(pair) && stringcolumn(4) eq "clean" \
            ? (names = names . " " . stringcolumn(3), \
               xs = xs . sprintf(" %.6f", column(15)), \
               ys = ys . sprintf(" %.6f", shown(column(9), column(8))), 1) : NaN) nooutput
        stats csv using (of_pair(pair) && stringcolumn(4) eq "hostile" \
            ? (zs = zs . sprintf(" %.6f", shown(column(9), column(8))), 1) : NaN) nooutput
        n = words(names)
        do for [i = 1:n] {
            name[i] = word(names, i)
            xv[i] = word(xs, i) + 0.0
            yv[i] = word(ys, i) + 0.0
            zv[i] = word(zs, i) + 0.0
        }
        # by height, then by time
        do for [i = 1:n] {
            do for [j = 1:n - 1] {
                if (yv[j] * (1 + 1e-3 * xv[j]) > yv[j + 1] * (1 + 1e-3 * xv[j + 1])) {
                    s = name[j]; name[j] = name[j + 1]; name[j + 1] = s
                    v = xv[j]; xv[j] = xv[j + 1]; xv[j + 1] = v
                    v = yv[j]; yv[j] = yv[j + 1]; yv[j + 1] = v
                    v = zv[j]; zv[j] = zv[j + 1]; zv[j + 1] = v
                }
            }
        }
        # up from the bottom, then down from the top
        below = log10(y_low)
        do for [i = 1:n] {
            at[i] = log10(yv[i]) > below + line ? log10(yv[i]) : below + line
            below = at[i]
        }
        above = log10(y_high)
        do for [k = 1:n] {
            i = n + 1 - k
            at[i] = at[i] < above - line ? at[i] : above - line
            above = at[i]
        }
        set print $points
        do for [i = 1:n] {
            print sprintf("%g,%g,%g,%d", xv[i], yv[i], zv[i], name[i] eq "default")
        }
        unset print

        col = (p - 1) % 4
        row = (p - 1) / 4
        left = 0.058 + col * 0.237
        top = 0.925 - row * 0.455
        set lmargin at screen left
        set rmargin at screen left + 0.122
        set tmargin at screen top
        set bmargin at screen top - 0.385
        set logscale xy
        set xrange [x_low:x_high]
        set yrange [y_low:y_high]
        set xtics ("0.1" 0.1, "1" 1, "10" 10, "100" 100) scale 0.5 nomirror tc rgb ink
        if (col == 0) {
            set ytics ("1" 1, "10^4" 1e4, "10^8" 1e8, "10^{12}" 1e12, "10^{16}" 1e16) scale 0.5 nomirror tc rgb ink
        } else {
            set ytics ("" 1, "" 1e4, "" 1e8, "" 1e12, "" 1e16) scale 0.5 nomirror
        }
        set border 3 lc rgb ink
        unset key
        set title word(titles, p) font ",10" tc rgb ink offset 0,-0.6
        floor_here = word(floors, p) + 0.0
        set arrow 1 from x_low,floor_here to x_high,floor_here nohead dt 3 lc rgb "#2a6f97" back
        set arrow 2 from x_low,half_turn to x_high,half_turn nohead dt 3 lc rgb "#2a6f97" back
        set arrow 3 from 1,y_low to 1,y_high nohead dt 3 lc rgb "#2a6f97" back
        do for [i = 1:n] {
            mine = name[i] eq "default"
            set label 10 + i name[i] at x_label,10**at[i] left tc rgb (mine ? strong : ink) \
                font (mine ? ":Bold" : "") noenhanced
            set arrow 10 + i from xv[i],yv[i] to x_label * 0.93,10**at[i] nohead lw 0.6 \
                lc rgb (mine ? strong : "#cfd2d6") back
        }
        plot $points using 1:2:(0):($3 - $2) with vectors nohead lw 1.2 lc rgb plain, \
            "" using 1:2 with points pt 7 ps 0.6 lc rgb plain, \
            "" using 1:3 with points pt 9 ps 0.7 lc rgb plain, \
            "" using ($4 > 0 ? $1 : NaN):2:(0):($3 - $2) with vectors nohead lw 2 lc rgb strong, \
            "" using ($4 > 0 ? $1 : NaN):2 with points pt 7 ps 0.9 lc rgb strong, \
            "" using ($4 > 0 ? $1 : NaN):3 with points pt 9 ps 1 lc rgb strong
        unset label
        unset arrow
    }
    unset multiplot
    unset output
}

# --- Error on the way to a singularity ---------------------------------------

sweeps = "'dcm-quat/to half-turn' 'dcm-quat/noise' 'dcm-rotvec/to half-turn' 'dcm-rotvec/to identity' 'quat-rotvec/to identity' 'quat-euler/to lock'"
headings = "'dcm to quat: to a half-turn' 'dcm to quat: noise of the matrix' 'dcm to rotvec: to a half-turn' 'dcm to rotvec: to the identity' 'quat to rotvec: to the identity, relative' 'quat to euler ZYX: to lock'"
colours = "#1b9e77 #7570b3 #e6ab02 #66a61e #377eb8 #a6761d #984ea3 #17becf #444444 #f781bf #999999 #0b3d91 #b2df8a"
of_sweep(sweep) = stringcolumn(1) . "-" . stringcolumn(2) . "/" . stringcolumn(4) eq sweep

do for [terminal in "svg pngcairo"] {
    if (terminal eq "svg") {
        set terminal svg size 900,1180 font "DejaVu Sans,10" background "white" enhanced
        set output out . "/stability.svg"
    } else {
        set terminal pngcairo size 900,1180 font "DejaVu Sans,8" background "white" enhanced
        set output out . "/stability.png"
    }
    set multiplot
    set label 1 "Worst error on the way to each singularity" at screen 0.5,0.988 center font ",12" tc rgb ink
    set label 2 "across: distance, radians (noise: of each number);  up: worst attitude error, units of 2^{-52} rad; at the top: no finite result" \
        at screen 0.5,0.97 center tc rgb ink
    do for [p = 1:6] {
        sweep = word(sweeps, p)
        error = p == 5 ? 11 : 9
        names = ""
        stats csv using (of_sweep(sweep) && column(6) > 0.05 \
            ? (names = names . " " . stringcolumn(3), 1) : NaN) nooutput
        n = words(names)
        col = (p - 1) % 2
        row = (p - 1) / 2
        left = 0.045 + col * 0.48
        top = 0.935 - row * 0.32
        set lmargin at screen left
        set rmargin at screen left + 0.29
        set tmargin at screen top
        set bmargin at screen top - 0.265
        set logscale xy
        set xrange [0.2:5e-17]
        set yrange [0.1:1e18]
        set xtics ("10^{-1}" 1e-1, "10^{-4}" 1e-4, "10^{-8}" 1e-8, "10^{-12}" 1e-12, "10^{-16}" 1e-16) scale 0.5 nomirror
        set ytics ("1" 1, "10^4" 1e4, "10^8" 1e8, "10^{12}" 1e12, "10^{16}" 1e16) scale 0.5 nomirror
        set grid lc rgb "#e6e8eb" lt 1
        set border 3 lc rgb ink
        set key at screen left + 0.3,top Left reverse left top samplen 2.5 spacing 1.15 noenhanced tc rgb ink
        set title word(headings, p) font ",10" tc rgb ink offset 0,-0.6
        plot for [i = 1:n] csv using (of_sweep(sweep) && stringcolumn(3) eq word(names, i) \
                ? column(6) : NaN):(shown(column(error), column(8))) \
            with linespoints pt (3 + i) ps 0.5 pi 3 lw (word(names, i) eq "default" ? 3.5 : 1.3) \
            lc rgb (word(names, i) eq "default" ? strong : word(colours, i)) title word(names, i)
        unset label
    }
    unset multiplot
    unset output
}

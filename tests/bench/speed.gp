# Time against worst error, one panel a conversion, from bench_methods' figures:
# gnuplot -e "csv='methods.csv'; out='DIRECTORY'" speed.gp, in this folder

load "common.gp"

pairs = "dcm-quat quat-dcm dcm-rotvec quat-euler quat-rotvec rotvec-dcm dcm-cayley cayley-dcm"
floors = "0.83 0.39 1.4 2 1.4 0.39 0.5 0.39" # what rounding the exact numbers to double costs at the worst
of_stratum(pair, stratum) = stringcolumn("from") . "-" . stringcolumn("to") eq pair && stringcolumn("stratum") eq stratum
shown_pair(pair) = pair[1:strstrt(pair, "-") - 1] . " to " . pair[strstrt(pair, "-") + 1:*]

high = 842
wide = 124.0 # of a panel, pixels
tall = 214.0
x_low = 0.25
x_high = 110.0
front_colour = "#f0c04a"
colours = plain . " " . eigen . " " . strong # the last on top

# Pixels in the panel: dots cx, cy; triangles hx, hy; numbers lx, ly
array cx[40]
array cy[40]
array hx[40]
array hy[40]
array lx[40]
array ly[40]
array name[40]
clip(x) = x < x_low ? x_low : x > x_high ? x_high : x
pixel(t) = wide * log10(clip(t) / x_low) / log10(x_high / x_low)
time_at(pixel) = x_low * (x_high / x_low)**(pixel / wide)

# A number goes to the nearest place that is free of dots, lines and other numbers.
near(dx, dy, x, y) = abs(dx) < x && abs(dy) < y
along(x, y, j) = ((x - cx[j]) * (hx[j] - cx[j]) + (y - cy[j]) * (hy[j] - cy[j])) \
    / ((hx[j] - cx[j])**2 + (hy[j] - cy[j])**2 + 1e-9)
unit(t) = t < 0 ? 0 : t > 1 ? 1 : t
on_line(x, y, j) = near(x - cx[j] - unit(along(x, y, j)) * (hx[j] - cx[j]), \
                        y - cy[j] - unit(along(x, y, j)) * (hy[j] - cy[j]), 7, 7)
taken(x, y, i) = (x < 6 || x > wide || y < 4 || y > tall + 8) \
    + (sum [j = 1:n] (near(x - cx[j], y - cy[j], 9, 8) + near(x - hx[j], y - hy[j], 9, 8) + on_line(x, y, j))) \
    + (sum [j = 1:i] (j < i && near(x - lx[j], y - ly[j], 13, 10)))
place_x(i, k) = cx[i] + (10 + 3 * (k / 12)) * cos(pi * k / 6)
place_y(i, k) = cy[i] + (10 + 3 * (k / 12)) * sin(pi * k / 6)

# The Pareto front at x: the least error of the methods that are no slower, but for those that fail altogether.
least(a, b) = a < b ? a : b
useful(y) = y < tall * h(1e15) ? y : tall
clean_front(x, k) = k == 0 ? tall : least(cx[k] <= x ? useful(cy[k]) : tall, clean_front(x, k - 1))
hostile_front(x, k) = k == 0 ? tall : least(hx[k] <= x ? useful(hy[k]) : tall, hostile_front(x, k - 1))
shown_front(y) = y < tall ? y / tall : NaN

do for [kind in "svg png"] {
    eval begin("speed")
    small = sized(10)
    eval error_tics
    set xtics ("0.3" 0.3, "1" 1, "3" 3, "10" 10, "30" 30, "100" 100) scale 0.4 nomirror font small tc rgb ink offset 0,0.4
    set logscale x
    set xrange [x_low:x_high]
    set samples 250
    set multiplot
    set label 1 "Time and worst error of every method" at screen 0.5,down(16) center font sized(15) tc rgb ink
    set label 2 "across: time of a row / Eigen's;  up: worst attitude error in 2^{-52} rad, compressed above 10;  nan: some results not finite" \
        at screen 0.5,down(38) center font sized(11) tc rgb ink
    do for [p = 1:8] {
        pair = word(pairs, p)
        names = ""
        clean = ""
        hostile = ""
        stats csv using (of_stratum(pair, "clean") ? (names = names . " " . stringcolumn("method"), clean = clean \
            . sprintf(" %.6f %.6f", column("x_eigen"), height(column("worst"), column("not_finite"))), 1) : NaN) nooutput
        stats csv using (of_stratum(pair, "hostile") ? (hostile = hostile \
            . sprintf(" %.6f %.6f", column("x_eigen"), height(column("worst"), column("not_finite"))), 1) : NaN) nooutput
        n = words(names)
        x_of(i) = word(clean, 2 * i - 1) + 0.0
        y_of(i) = word(clean, 2 * i) + 0.0
        before(j, i) = y_of(j) < y_of(i) || (y_of(j) == y_of(i) && (x_of(j) < x_of(i) || (x_of(j) == x_of(i) && j < i)))
        do for [i = 1:n] {
            at = 1 + (sum [j = 1:n] before(j, i)) # by error, then by time
            name[at] = word(names, i)
            cx[at] = pixel(x_of(i))
            cy[at] = tall * y_of(i)
            hx[at] = pixel(word(hostile, 2 * i - 1) + 0.0)
            hy[at] = tall * (word(hostile, 2 * i) + 0.0)
        }
        set print $points
        do for [i = 1:n] {
            k = 0
            while (k < 120 && taken(place_x(i, k), place_y(i, k), i)) { k = k + 1 }
            lx[i] = place_x(i, k)
            ly[i] = place_y(i, k)
            print sprintf("%g,%g,%g,%g,%s", time_at(cx[i]), cy[i] / tall, time_at(hx[i]), hy[i] / tall, colour(name[i]))
        }
        unset print

        left = 34 + (p - 1) % 3 * 276
        top = 80 + (p - 1) / 3 * 262
        eval place_panel(left, top)
        set label 10 shown_pair(pair) at screen across(left + wide / 2),down(top - 15) center font bold(12) tc rgb ink
        set object 1 rectangle from graph 0,0 to graph 1,0.5 fc rgb "#f3f4f6" fs noborder behind
        set arrow 1 from x_low,h(word(floors, p) + 0.0) to x_high,h(word(floors, p) + 0.0) nohead dt 3 lc rgb ink back
        set arrow 2 from x_low,h(half_turn) to x_high,h(half_turn) nohead dt 3 lc rgb ink back
        set arrow 3 from 1,0 to 1,1 nohead lw 1 lc rgb "#b8d3e8" back
        do for [i = 1:n] {
            c = colour(name[i])
            line = top + 2 + 14 * (i - 1)
            set label 100 + i sprintf("%d", i) at time_at(lx[i]),ly[i] / tall center font sized(10) tc rgb c front
            set arrow 100 + i from time_at(cx[i]),cy[i] / tall to time_at(lx[i]),ly[i] / tall nohead lw 0.4 lc rgb plain back
            set label 200 + i sprintf("%d", i) at screen across(left + wide + 17),down(line) right font sized(11) tc rgb c
            set label 300 + i label_of(name[i]) at screen across(left + wide + 21),down(line) left \
                font (c eq plain ? sized(11) : bold(11)) tc rgb (c eq plain ? ink : c)
        }
        plot shown_front(clean_front(pixel(x), n)) with steps lw 4 lc rgb front_colour, \
            shown_front(hostile_front(pixel(x), n)) with steps lw 1.2 lc rgb front_colour, \
            for [c in colours] $points using (stringcolumn(5) eq c ? $1 : NaN):2:($3 - $1):($4 - $2) \
                with vectors nohead lw (c eq plain ? 0.7 : 1.5) lc rgb c, \
            for [c in colours] $points using (stringcolumn(5) eq c ? $1 : NaN):2 \
                with points pt 7 ps (c eq plain ? 0.55 : 0.8) lc rgb c, \
            for [c in colours] $points using (stringcolumn(5) eq c ? $3 : NaN):4 \
                with points pt 9 ps (c eq plain ? 0.6 : 0.9) lc rgb c
        unset label
        unset arrow
        unset object
    }
    # The key, in the place of a ninth panel.
    left = 34 + 2 * 276
    top = 80 + 2 * 262
    eval place_panel(left, top)
    unset border
    unset tics
    unset logscale x
    set xrange [0:wide]
    line(i) = 1 - (10 + 26.0 * i) / tall
    set label 1 "clean input" at 40,line(0) tc rgb ink
    set label 2 "hostile: noise, scale, many turns" at 40,line(1) tc rgb ink
    set label 3 "rotconv's default" at 40,line(2) tc rgb strong font bold(11)
    set label 4 "Eigen; the line: its time" at 40,line(3) tc rgb eigen font bold(11)
    set label 5 "Pareto front, clean" at 40,line(4) tc rgb ink
    set label 6 "Pareto front, hostile" at 40,line(5) tc rgb ink
    set label 7 "rounding floor, half-turn" at 40,line(6) tc rgb ink
    set arrow 5 from 0,line(4) to 30,line(4) nohead lw 4 lc rgb front_colour
    set arrow 6 from 0,line(5) to 30,line(5) nohead lw 1.2 lc rgb front_colour
    set arrow 7 from 0,line(6) to 30,line(6) nohead dt 3 lc rgb ink
    plot "+" using (15):(line(0)) every ::0::0 with points pt 7 ps 0.6 lc rgb plain, \
        "+" using (15):(line(1)) every ::0::0 with points pt 9 ps 0.7 lc rgb plain, \
        "+" using (15):(line(2)) every ::0::0 with points pt 7 ps 0.8 lc rgb strong, \
        "+" using (15):(line(3)) every ::0::0 with points pt 7 ps 0.8 lc rgb eigen
    unset label
    unset arrow
    unset multiplot
    unset output
    set border 3 lc rgb ink
}

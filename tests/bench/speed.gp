# Time against worst error, one panel a conversion, from bench_methods' figures:
# gnuplot -e "csv='methods.csv'; out='DIRECTORY'" speed.gp, in this folder

load "common.gp"

pictures = "speed speed-more"
array pairs[2]
pairs[1] = "dcm-quat quat-euler dcm-euler quat-rotvec"
pairs[2] = "quat-dcm dcm-rotvec rotvec-dcm dcm-cayley cayley-dcm rotvec-quat"
of_stratum(pair, stratum) = stringcolumn("from") . "-" . stringcolumn("to") eq pair && stringcolumn("stratum") eq stratum \
    && place_in(shown_methods(pair), stringcolumn("method")) > 0
shown_pair(pair) = pair[1:strstrt(pair, "-") - 1] . " to " . pair[strstrt(pair, "-") + 1:*]

wide = 300.0 # of a panel, pixels
tall = 190.0
heading = "What a conversion costs, and what it loses"
x_low = 0.2
x_high = 160.0

# Pixels in the panel: dots cx, cy; triangles hx, hy; the middles of names lx, ly and half their widths lw; leaders from
# sx, ly to mx, my
array cx[20]
array cy[20]
array hx[20]
array hy[20]
array lx[20]
array ly[20]
array lw[20]
array sx[20]
array mx[20]
array my[20]
array name[20]
array best[20]
clip(x) = x < x_low ? x_low : x > x_high ? x_high : x
pixel(t) = wide * log10(clip(t) / x_low) / log10(x_high / x_low)
time_at(pixel) = x_low * (x_high / x_low)**(pixel / wide)

# What a name at (x, y) would hide: dots and triangles, lines between them, other names and what leads to them, the panel's
# border. What its own leader would cross: other names.
near(dx, dy, x, y) = abs(dx) < x && abs(dy) < y
hides(x, y, w, i, s, u, v) = 30 * (x - w < 4 || x + w > wide + 12 || y < 8 || y > tall + 2) \
    + (sum [j = 1:n] (9 * near(x - cx[j], y - cy[j], w + 4, 10) + 9 * near(x - hx[j], y - hy[j], w + 4, 10) \
        + 0.5 * (sum [k = 1:11] near(x - cx[j] - k / 12.0 * (hx[j] - cx[j]), y - cy[j] - k / 12.0 * (hy[j] - cy[j]), w + 1, 7)))) \
    + (sum [j = 1:n] (j < placed && j != i ? 8 * near(x - lx[j], y - ly[j], w + lw[j] + 3, 13) \
        + 2 * (sum [k = 0:8] (near(x - sx[j] - k / 8.0 * (mx[j] - sx[j]), y - ly[j] - k / 8.0 * (my[j] - ly[j]), w + 2, 8) \
            + near(lx[j] - s - k / 8.0 * (u - s), ly[j] - y - k / 8.0 * (v - y), lw[j] + 2, 8))) : 0))
# Places round the dot (k up to 59) or the triangle, nearest first.
from_x(i, k) = k < 60 ? cx[i] : hx[i]
from_y(i, k) = k < 60 ? cy[i] : hy[i]
ring(k) = (k % 60) / 12
turn(k) = (k % 12) * pi / 6
place_x(i, k) = from_x(i, k) + (9 + 11 * ring(k)) * cos(turn(k)) + (abs(cos(turn(k))) < 0.1 ? 0 : lw[i] * sgn(cos(turn(k))))
place_y(i, k) = from_y(i, k) + (12 + 11 * ring(k)) * sin(turn(k))
start_x(i, k) = place_x(i, k) - (abs(cos(turn(k))) < 0.1 ? 0 : lw[i] * sgn(cos(turn(k))))
goal_x(i, k) = ring(k) > 0 ? from_x(i, k) : start_x(i, k)
goal_y(i, k) = ring(k) > 0 ? from_y(i, k) : place_y(i, k)
cost(i, k) = hides(place_x(i, k), place_y(i, k), lw[i], i, start_x(i, k), goal_x(i, k), goal_y(i, k)) \
    + 0.5 * ring(k) + (k < 60 ? 0 : 0.3)

do for [picture = 1:2] {
    high = 92 + 262 * (words(pairs[picture]) / 2)
    eval begin(word(pictures, picture))
    set logscale x
    set xrange [x_low:x_high]
    eval error_tics
    set xtics ("0.3" 0.3, "1" 1, "3" 3, "10" 10, "30" 30, "100" 100) scale 0.4 nomirror font small tc rgb ink offset 0,0.4
    set multiplot
    set label 1 heading at screen 0.5,down(18) center font sized(16) tc rgb ink
    set label 2 "{/:Bold ●} clean input   {/:Bold ▲} hostile input: noise to 5·10^{-4}, quaternions of any length, many turns" \
        at screen 0.5,down(42) center tc rgb ink
    set label 3 "grey: right to the last digits;  exact: off by the rounding of the result alone;  nan: no answer to some rows" \
        at screen 0.5,down(60) center tc rgb ink
    do for [p = 1:words(pairs[picture])] {
        pair = word(pairs[picture], p)
        names = ""
        clean = ""
        hostile = ""
        stats csv using (of_stratum(pair, "clean") ? (names = names . " " . stringcolumn("method"), clean = clean \
            . sprintf(" %.6f %.6f", column("x_eigen"), height(column("worst"), column("not_finite"))), 1) : NaN) nooutput
        stats csv using (of_stratum(pair, "hostile") ? (hostile = hostile \
            . sprintf(" %.6f %.6f", column("x_eigen"), height(column("worst"), column("not_finite"))), 1) : NaN) nooutput
        n = words(names)
        do for [i = 1:n] {
            name[i] = word(names, i)
            cx[i] = pixel(word(clean, 2 * i - 1) + 0.0)
            cy[i] = tall * (word(clean, 2 * i) + 0.0)
            hx[i] = pixel(word(hostile, 2 * i - 1) + 0.0)
            hy[i] = tall * (word(hostile, 2 * i) + 0.0)
            lw[i] = 0.5 * width_of(label_of(name[i])) * (is_bold(name[i]) ? 1.1 : 1)
        }
        # Twice: the second time all others have their places.
        do for [again = 0:1] {
            do for [i = 1:n] {
                placed = again ? n + 1 : i
                best[i] = 0
                least = 1e9
                do for [k = 0:119] {
                    now = cost(i, k)
                    if (now < least) {
                        least = now
                        best[i] = k
                    }
                }
                lx[i] = place_x(i, best[i])
                ly[i] = place_y(i, best[i])
                sx[i] = start_x(i, best[i])
                mx[i] = goal_x(i, best[i])
                my[i] = goal_y(i, best[i])
            }
        }
        set print $points
        do for [i = 1:n] {
            print sprintf("%g,%g,%g,%g,%s", time_at(cx[i]), cy[i] / tall, time_at(hx[i]), hy[i] / tall, name[i])
            if (ring(best[i]) > 0) {
                set arrow 200 + i from first time_at(mx[i]),my[i] / tall to time_at(sx[i]), \
                    (ly[i] - 6 * sgn(sin(turn(best[i]))) * (sx[i] == lx[i])) / tall nohead lw 0.6 lc rgb colour(name[i]) back
            }
        }
        unset print

        left = 60 + (p - 1) % 2 * 378
        top = 104 + (p - 1) / 2 * 262
        eval place_panel(left, top)
        eval good_half
        set label 10 shown_pair(pair) at screen across(left + wide / 2),down(top - 16) center font bold(13) tc rgb ink
        set label 11 "time of a row, in times of Eigen's" at screen across(left + wide / 2),down(top + tall + 34) center font sized(11) tc rgb ink
        set label 12 error_title at screen across(left - 45),down(top + tall / 2) center rotate font sized(11) tc rgb ink
        set arrow 1 from 1,0 to 1,1 nohead lw 1 lc rgb "#b8d3e8" back
        do for [i = 1:n] {
            set label 100 + i label_of(name[i]) at time_at(lx[i]),ly[i] / tall center \
                font (is_bold(name[i]) ? bold(11) : sized(11)) tc rgb colour(name[i]) front
        }
        plot for [i = 1:n] $points every ::i - 1::i - 1 using 1:2:($3 - $1):($4 - $2) with vectors nohead lw 1 lc rgb colour(name[i]) \
            title label_of(name[i]) . ", from clean to hostile input", \
            for [i = 1:n] $points every ::i - 1::i - 1 using 1:2 with points pt 7 ps 0.7 lc rgb colour(name[i]) \
            title label_of(name[i]) . ", clean input", \
            for [i = 1:n] $points every ::i - 1::i - 1 using 3:4 with points pt 9 ps 0.8 lc rgb colour(name[i]) \
            title label_of(name[i]) . ", hostile input"
        unset label
        unset arrow
        unset object
    }
    unset multiplot
    unset output
    system described(heading, "One panel a conversion: the worst error of rotconv, of Eigen and of published methods by their " \
        . "time, on clean and on hostile input. rotconv is right to the last digits on both. The figures are in methods.csv.")
}

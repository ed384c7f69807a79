# What exactness costs and what cheapness loses, one line a conversion, from bench_methods' figures:
# gnuplot -e "csv='methods.csv'; out='DIRECTORY'" speed.gp, in this folder

load "common.gp"

pairs = "quat-dcm dcm-quat quat-euler euler-quat dcm-euler euler-dcm quat-rotvec rotvec-quat dcm-rotvec rotvec-dcm dcm-cayley" \
    . " cayley-dcm"
shown(pair) = pair[1:strstrt(pair, "-") - 1] . " → " . pair[strstrt(pair, "-") + 1:*]
names_font = sized(12)
rows = words(pairs)
# Published methods are drawn first, so that they hide nothing.
array way[5] = ["published", "Eigen", "typed", "fast", "default"]
array point[5] = [6, 13, 5, 9, 7]
array size[5] = [0.6, 1.0, 0.7, 0.9, 0.9]
way_colour(w) = way[w] eq "published" ? plain : colour(way[w])
is_of(w, method) = way[w] eq method || (way[w] eq "published" && !is_ours(method) && method ne "Eigen")
row_of(w, stratum) = stringcolumn("stratum") eq stratum && is_of(w, stringcolumn("method")) \
    ? place_in(pairs, stringcolumn("from") . "-" . stringcolumn("to")) : 0
# Ways that stand at the same place are seen one above the other.
shift(w) = w == 1 ? 0.2 : 0.13 * (3 - w)

heading = "Exactness takes 0.4 to 10 times the time of Eigen; cheap formulas lose digits, some of them all"
top = 130
tall = 27.0 * (rows + 1)
high = top + tall + 40
eval begin("speed")
set multiplot
set label 1 heading at screen 0.5,down(20) center font sized(15) tc rgb ink
array key[5] = ["published method", "Eigen", "rotconv, C++ call", "rotconv, fast", "rotconv, exact"]
array key_x[5] = [588, 508, 346, 210, 70]
do for [w = 1:5] {
    set label 10 + w key[w] at screen across(key_x[w]),down(48) \
        point pt point[w] ps size[w] lc rgb way_colour(w) offset 1,-0.12 font (w == 1 ? sized(12) : bold(12)) tc rgb way_colour(w)
}
set label 2 "grey: right to the last digits;  nan: no answer to some rows;  hostile: noise to 5·10^{-4}, quaternions of any length, many turns" \
    at screen 0.5,down(68) center font small tc rgb ink
set yrange [rows + 0.7:0.3]

array titles[3] = ["What it costs: time of a row", "What is lost: clean input", "What is lost: hostile input"]
array below[3] = ["in times of Eigen's, uniform rows", "worst error, 2^{-52} rad", "worst error, 2^{-52} rad"]
array lefts[3] = [100, 330, 556]
array strata[3] = ["clean", "clean", "hostile"]
do for [p = 1:3] {
    wide = 190.0
    left = lefts[p]
    eval place_panel(left, top)
    set label 20 titles[p] at screen across(left + wide / 2),down(top - 30) center font bold(12) tc rgb ink
    set label 21 below[p] at screen across(left + wide / 2),down(top - 14) center font sized(11) tc rgb ink
    set arrow 1 from graph 0,0 to graph 1,0 nohead lw 0.5 lc rgb ink
    do for [r = 1:rows] {
        set arrow 50 + r from graph 0,first r to graph 1,first r nohead lw 0.5 lc rgb "#dddddd" back
    }
    if (p == 1) {
        set logscale x
        set xrange [0.2:40]
        set xtics ("0.3" 0.3, "1" 1, "3" 3, "10" 10, "30" 30) scale 0.4 nomirror font small textcolor rgb ink offset 0,0.4
        set ytics ("" 0) scale 0 font names_font textcolor rgb ink
        set for [r = 1:rows] ytics add (shown(word(pairs, r)) r)
        set arrow 2 from 1,graph 0 to 1,graph 1 nohead lw 1 lc rgb colour("Eigen") back
    } else {
        unset logscale x
        unset arrow 2
        set xrange [0:1]
        set format y ""
        set ytics scale 0
        unset ytics
        eval error_xtics
        set object 1 rectangle from graph 0,0 to 0.5,graph 1 fc rgb "#eef1f4" fs noborder behind
    }
    x(p) = p == 1 ? column("x_eigen") : height(column("worst"), column("not_finite"))
    plot for [w = 1:5] csv using (row_of(w, strata[p]) > 0 ? x(p) : NaN):(row_of(w, strata[p]) + shift(w)) with points \
        pt point[w] ps size[w] lc rgb way_colour(w) title titles[p] . ": " . way[w]
    unset object
    unset label
}
unset multiplot
unset output
system described(heading, "One line a conversion. Left the time of a row over that of Eigen, then the worst error on clean and " \
    . "on hostile input, of rotconv, of Eigen and of published methods. rotconv is right to the last digits on both. The figures " \
    . "are in methods.csv.")

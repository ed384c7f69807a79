# What a user would pick for a stream of matrices: rows per second against worst attitude error, from bench_tools' figures:
# gnuplot -e "csv='tools.csv'; out='DIRECTORY'" tools.gp, in this folder

load "common.gp"

high = 440
wide = 660.0 # of the panel, pixels
tall = 330.0
left = 76
top = 50
x_low = 2e4
x_high = 5e7
least = 1e-16
beneath = 36.0 # the least error, for names
pixel_x(rate) = wide * log10(rate / x_low) / log10(x_high / x_low)
pixel_y(error) = beneath + (tall - beneath) * log10((error < least ? least : error) / least) / log10(pi / least)
max(a, b) = a > b ? a : b

# A tool's name with the version that was measured, as 1.10 of 1.10.1: after each word that `version` has too, the word that
# follows there; after a name without such words, the last one.
first_dot(text) = strstrt(text, ".")
second_dot(text) = first_dot(text) + strstrt(text[first_dot(text) + 1:*] . ".", ".")
number_of(text) = text[(text[1:1] eq "v" ? 2 : 1):second_dot(text) - 1]
version_of(w, version) = sum [k = 1:words(version) - 1] (word(version, k) eq w ? k + 1 : 0)
labelled(tool, version) = (found = 0, text = "", sum [k = 1:words(tool)] (at = version_of(word(tool, k), version), \
    text = text . (k > 1 ? " " : "") . word(tool, k) . (at > 0 ? " " . number_of(word(version, at)) : ""), found = found + at), \
    found > 0 ? text : text . " " . number_of(word(version, words(version))))

# Each tool's mark for all rows and, at the same rate, for clean ones; what it is worst at
n = 0
# Where the formula is the script's, not the tool's.
formula(tool) = tool[1:7] eq "rotconv" || strstrt(tool, "SciPy") + strstrt(tool, "Eigen") > 0 ? "" : "formula in "
array name[20]
array label[20]
array mark_x[20]
array mark_y[20]
array clean_y[20]
array trouble[20]
not_installed = ""
stats csv using (valid(7) ? (n = n + 1, name[n] = stringcolumn("tool"), \
    label[n] = formula(name[n]) . labelled(name[n], stringcolumn("version")), \
    mark_x[n] = pixel_x(column("rows_per_second")), \
    clean_y[n] = pixel_y(column("clean")), half_turn = column("half_turn"), lock = column("lock"), noise = column("noise"), \
    worst = column("failed") > 0 ? pi : max(max(column("clean"), half_turn), max(lock, noise)), mark_y[n] = pixel_y(worst), \
    trouble[n] = worst < 1e-12 ? "" : worst == lock ? "gimbal lock: a wrong attitude" \
        : worst == noise ? "noise: off by the noise" : "", 1) \
    : (not_installed = not_installed . ", " . stringcolumn("tool"), 1)) nooutput

is_ours(i) = name[i][1:7] eq "rotconv"
colour_of(i) = is_ours(i) ? colour("default") : strstrt(name[i], "Eigen") > 0 ? colour("Eigen") : ink
escaped(text) = strstrt(text, "_") > 0 ? text[1:strstrt(text, "_") - 1] . "\\_" . text[strstrt(text, "_") + 1:*] : text

# A name stands beside its mark, away from the other marks of rotconv, where it hides least: right or left of it, below or above from it on, below or above.
array name_x[20] # the middle
array name_y[20]
array half[20]
side(k) = word("left right left right left right", k)
start_x(i, k) = mark_x[i] + word("9 -9 -6 6 -6 6", k)
place_x(i, k) = start_x(i, k) + (side(k) eq "left" ? half[i] : -half[i])
place_y(i, k) = mark_y[i] + word("0 0 -21 -21 16 16", k)
near(dx, dy, x, y) = abs(dx) < x && abs(dy) < y
crosses(u, v, half, j) = abs(u - mark_x[j]) < half + 2 && v > clean_y[j] && v < mark_y[j]
hides(u, v, i) = 3 * (u - half[i] < 2 || u + half[i] > wide) \
    + (sum [j = 1:n] (3 * near(u - mark_x[j], v - mark_y[j], half[i] + 6, 12) + 3 * near(u - mark_x[j], v - clean_y[j], half[i] + 6, 12) \
        + crosses(u, v, half[i], j) + (j == i ? 0 : 0.5 * near(u - mark_x[j], v - mark_y[j], half[i], is_ours(j) ? 30 : 0)))) \
    + (sum [j = 1:n] (j < i && 3 * near(u - name_x[j], v - name_y[j], half[i] + half[j] + 4, 14)))
do for [i = 1:n] {
    half[i] = 0.5 * width_of(label[i]) * (is_ours(i) ? 1.2 : 1.1)
    fewest = 1e9
    do for [k = 1:6] {
        now = hides(place_x(i, k), place_y(i, k), i) + 0.01 * k
        if (now < fewest) {
            fewest = now
            best = k
        }
    }
    name_x[i] = place_x(i, best)
    name_y[i] = place_y(i, best)
    eval sprintf("set label 100 + i escaped(label[i]) at start_x(i, best),name_y[i] %s front " \
        . "font (is_ours(i) ? bold(12) : sized(12)) tc rgb colour_of(i)", side(best))
}
# Lines leave the names of others free.
do for [i = 1:n] {
    do for [j = 1:n] {
        if (crosses(name_x[i], name_y[i], half[i], j)) {
            set object 100 * i + j rectangle center mark_x[j],name_y[i] size 4,16 fc rgb "white" fs noborder front
        }
    }
}
slowest = 1
do for [i = 2:n] {
    slowest = mark_x[i] < mark_x[slowest] ? i : slowest
}
# What keeps tools from being right, said once, by the fastest of them
do for [i = 1:n] {
    others = sum [j = 1:n] (trouble[j] eq trouble[i] && mark_x[j] > mark_x[i])
    if (others == 0) {
        set label 200 + i trouble[i] at wide,mark_y[i] - 17 right font small tc rgb plain
    }
}

eval begin("tools")
eval place_panel(left, top)
set xrange [0:wide]
set yrange [0:tall]
set xtics ("30 000" pixel_x(3e4), "100 000" pixel_x(1e5), "300 000" pixel_x(3e5), "1 million" pixel_x(1e6), \
    "3 million" pixel_x(3e6), "10 million" pixel_x(1e7), "30 million" pixel_x(3e7)) scale 0.4 nomirror font small tc rgb ink
set ytics ("10^{-16}" pixel_y(1e-16), "10^{-12}" pixel_y(1e-12), "10^{-8}" pixel_y(1e-8), "10^{-4}" pixel_y(1e-4), "π" tall) \
    scale 0.4 nomirror font small tc rgb ink
set xlabel "rows a second (faster is further right)" font sized(12) tc rgb ink
set ylabel "worst attitude error, rad (better is lower)" font sized(12) tc rgb ink offset 1,0
set label 1 "A text file of rotation matrices to roll, pitch and yaw" at screen 0.5,down(18) center font sized(16) tc rgb ink
set label 2 "with half-turns," at mark_x[slowest] - 9,mark_y[slowest] - 18 right font small tc rgb plain
set label 3 "gimbal lock and noise" at mark_x[slowest] - 9,mark_y[slowest] - 33 right font small tc rgb plain
set label 4 "uniform attitudes" at mark_x[slowest] - 9,clean_y[slowest] right font small tc rgb plain
set label 5 (not_installed eq "" ? "" : "not measured: " . not_installed[3:*]) at wide,beneath / 4 right font small tc rgb plain
set label 6 "within 10 × 2^{-52} rad" at 8,beneath / 2 left font small tc rgb plain
set object 1 rectangle from 0,0 to wide,pixel_y(10 * 2.0**-52) fc rgb "#eef1f4" fs noborder behind
set print $marks
do for [i = 1:n] {
    print sprintf("%g,%g,%g", mark_x[i], clean_y[i], mark_y[i])
}
unset print
plot for [i = 1:n] $marks every ::i - 1::i - 1 using 1:2:(0):($3 - $2) with vectors nohead lw 1 lc rgb colour_of(i) title label[i], \
    for [i = 1:n] $marks every ::i - 1::i - 1 using 1:2 with points pt 7 ps 0.6 lc rgb "white", \
    for [i = 1:n] $marks every ::i - 1::i - 1 using 1:2 with points pt 6 ps 0.6 lw 1.5 lc rgb colour_of(i), \
    for [i = 1:n] $marks every ::i - 1::i - 1 using 1:3 with points pt 7 ps 1 lc rgb colour_of(i)
unset output
system described("A text file of rotation matrices to roll, pitch and yaw: rows a second against the worst attitude error", \
    "Each tool has a filled mark at its worst error on rows with half-turns, gimbal lock and noise, and an open mark at its worst error on uniform rows.")

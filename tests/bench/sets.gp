# Which sets of parameters serve which motion, from bench_sets' figures: gnuplot -e "csv='sets.csv'" -e "out='DIRECTORY'" sets.gp

load "common.gp"
load "motions.gp"

sets = "mrp cayley euler:ZYX rotvec quat axis-angle 5d 6d dcm"
numbers = "3 3 3 3 4 4 5 6 9"
serves = "#1d7a46"
fails = "#6f6f6f"

high = 380
row(p) = 106 + 36 * (p - 1)
place(k) = 316 + 52 * (k - 1)
heading = "The smallest set that serves: which sets serve which motion"
eval begin("sets")
unset border
unset tics
set lmargin at screen 0
set rmargin at screen 1
set tmargin at screen 1
set bmargin at screen 0
set label 1 heading at page / 2,18 center font sized(16) tc rgb ink
set label 2 "numbers in the set" at 286,72 right font small tc rgb ink
do for [k = 1:words(sets)] {
    set label 10 + k word(sets, k) at place(k),54 center font small tc rgb ink
    set label 30 + k word(numbers, k) at place(k),72 center font small tc rgb ink
}
set print $marks
do for [p = 1:words(motions)] {
    set label 50 + p word(motions, p) at 16,row(p) - 8 left font bold(12) tc rgb ink
    set label 60 + p word(definitions, p) at 16,row(p) + 8 left font small tc rgb ink
    do for [k = 1:words(sets)] {
        stats csv using (stringcolumn("motion") eq word(motions, p) && stringcolumn("set") eq word(sets, k) \
            ? (jumps = int(column("jumps")), good = int(column("serves")), best = int(column("smallest")), \
                singular = !(column("greatest_condition") <= 1000), 1) : 1) nooutput
        print sprintf("%g,%g,%d", place(k), row(p), good ? 1 + best : 0)
        if (!good) {
            reason = singular ? "singular" : sprintf("%d jumps", jumps)
            set label 100 + 10 * p + k reason at place(k),row(p) center \
                font sized(10) tc rgb fails
        }
    }
    set arrow p from 16,row(p) + 19 to page - 16,row(p) + 19 nohead lw 0.5 lc rgb "#dddddd" back
}
unset print
set xrange [0:page]
set yrange [high:0]
set label 3 "{/:Bold ●} serves the motion for 20 s   {/:Bold ◉} the smallest that does" at 16,328 left font small tc rgb ink
set label 4 "singular: comes so near a singular attitude that a small rotation changes its numbers by over 1000 times as much" \
    at 16,346 left font small tc rgb ink
set label 5 "jumps: how often its numbers leap while the body does not, as an angle from 180° to -180°; the sign of quat does not count" \
    at 16,364 left font small tc rgb ink
plot $marks using ($3 == 1 ? $1 : NaN):2 with points pt 7 ps 0.8 lc rgb serves title "serves", \
    $marks using ($3 == 2 ? $1 : NaN):2 with points pt 7 ps 0.8 lc rgb serves title "serves", \
    $marks using ($3 == 2 ? $1 : NaN):2 with points pt 6 ps 1.7 lw 2 lc rgb serves title "the smallest that serves"
unset output
system described(heading, "A table of six motions and nine sets of parameters: which serve, which of them is the smallest, and " \
    . "why the others do not. The figures are in sets.csv.")

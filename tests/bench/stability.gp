# Worst error on the way to each singularity, from bench_methods' figures:
# gnuplot -e "csv='methods.csv'; out='DIRECTORY'" stability.gp, in this folder

load "common.gp"

sweeps = "'dcm-quat/to half-turn' 'dcm-quat/noise' 'dcm-rotvec/to half-turn' 'dcm-rotvec/to identity' 'quat-rotvec/to identity' 'quat-euler/to lock'"
headings = "'dcm to quat: to a half-turn' 'dcm to quat: noise of each number' 'dcm to rotvec: to a half-turn' 'dcm to rotvec: to the identity, relative' 'quat to rotvec: to the identity, relative' 'quat to euler ZYX: to lock'"
colours = "#e6ab02 #1b9e77 #7b5ea7 #a6761d #66a61e #17a2b8 #444444 #e377c2 #999999 #0b3d91 #8c9b2f #c05a2b #5ec8a5 #b39ddb"
of_sweep(sweep) = stringcolumn("from") . "-" . stringcolumn("to") . "/" . stringcolumn("stratum") eq sweep
of_method(sweep, method) = of_sweep(sweep) && stringcolumn("method") eq method

high = 848
wide = 240.0
tall = 214.0

do for [kind in "svg png"] {
    eval begin("stability")
    small = sized(10)
    eval error_tics
    set logscale x
    set xrange [0.2:5e-17]
    set xtics ("10^{-1}" 1e-1, "10^{-4}" 1e-4, "10^{-8}" 1e-8, "10^{-12}" 1e-12, "10^{-16}" 1e-16) \
        scale 0.4 nomirror font small tc rgb ink offset 0,0.2
    set multiplot
    set label 1 "Worst error on the way to each singularity" at screen 0.5,down(16) center font sized(15) tc rgb ink
    set label 2 "across: distance in radians;  up: worst attitude error in 2^{-52} rad, compressed above 10;  nan: some results not finite" \
        at screen 0.5,down(38) center font sized(11) tc rgb ink
    do for [p = 1:6] {
        sweep = word(sweeps, p)
        error = strstrt(word(headings, p), "relative") > 0 ? "relative" : "worst"
        # A method's place in the legend is that of its line: by the sum of its heights. A typed call errs as its default.
        names = ""
        heights = ""
        stats csv using (of_sweep(sweep) && column("distance") > 0.05 && stringcolumn("method") ne "typed" \
            ? (names = names . " " . stringcolumn("method"), 1) : NaN) nooutput
        n = words(names)
        do for [i = 1:n] {
            stats csv using (of_method(sweep, word(names, i)) ? height(column(error), column("not_finite")) : NaN) nooutput
            heights = heights . sprintf(" %.9f", STATS_sum)
        }
        place(i) = sum [j = 1:n] (word(heights, j) + 0 > word(heights, i) + 0 || (word(heights, j) eq word(heights, i) && j < i))
        c_of(i) = colour(word(names, i)) eq plain ? word(colours, i) : colour(word(names, i))
        width(i) = colour(word(names, i)) eq plain ? 1.5 : 3

        left = 36 + (p - 1) % 2 * 416
        top = 80 + (p - 1) / 2 * 262
        eval place_panel(left, top)
        set label 10 word(headings, p) at screen across(left + wide / 2),down(top - 15) center font bold(12) tc rgb ink
        set object 1 rectangle from graph 0,0 to graph 1,0.5 fc rgb "#f3f4f6" fs noborder behind
        do for [i = 1:n] {
            line = top + 2 + 15 * place(i)
            set label 100 + i label_of(word(names, i)) at screen across(left + wide + 34),down(line) left \
                font (width(i) > 2 ? bold(11) : sized(11)) tc rgb (width(i) > 2 ? c_of(i) : ink)
            set arrow 100 + i from screen across(left + wide + 8),down(line) to screen across(left + wide + 29),down(line) \
                nohead lw width(i) lc rgb c_of(i)
        }
        plot for [i = 1:n] csv using (of_method(sweep, word(names, i)) ? column("distance") : NaN) \
                :(height(column(error), column("not_finite"))) with lines lw width(i) lc rgb c_of(i)
        unset label
        unset arrow
        unset object
    }
    unset multiplot
    unset output
}

# Worst error on the way to each singularity, and by the noise of a matrix, from bench_methods' figures:
# gnuplot -e "csv='methods.csv'; out='DIRECTORY'" stability.gp, in this folder

load "common.gp"

sweeps = "'dcm-quat/to half-turn' 'dcm-rotvec/to half-turn' 'dcm-rotvec/to identity' 'quat-rotvec/to identity' 'quat-euler/to lock' 'dcm-euler/to lock' 'dcm-quat/noise'"
headings = "'dcm to quat, into a half-turn' 'dcm to rotvec, into a half-turn' 'dcm to rotvec, into the identity' " \
    . "'quat to rotvec, into the identity' 'quat to euler:ZYX, into gimbal lock' 'dcm to euler:ZYX, into gimbal lock'"
singularities = "'the half-turn' 'the half-turn' 'the identity' 'the identity' 'gimbal lock' 'gimbal lock'"
pair_of(sweep) = sweep[1:strstrt(sweep, "/") - 1]
of_sweep(sweep) = stringcolumn("from") . "-" . stringcolumn("to") . "/" . stringcolumn("stratum") eq sweep
of_method(sweep, method) = of_sweep(sweep) && stringcolumn("method") eq method

# At most eight: methods.csv has all. A typed call errs as the fast way.
shown_on(sweep) = sweep eq "dcm-quat/noise" ? "default fast Eigen trace shepperd compensated polar bar-itzhack" \
    : sweep eq "dcm-quat/to half-turn" ? "default fast Eigen trace shepperd sarabandi-thomas klumpp bar-itzhack" \
    : pair_of(sweep) eq "dcm-rotvec" ? "default fast Eigen acos atan2 gtsam hertzberg compensated" \
    : "default fast Eigen acos atan2 compensated classic matrix-threshold bernardes-arccos bernardes-atan2 asin slabaugh shoemake" \
        . " shuster-markley"

# Small angles have their own size as the measure.
error_of(sweep) = strstrt(sweep, "identity") > 0 ? "relative" : "worst"
relative_title = "worst error / angle, in 2^{-52}"

weight(method) = method eq "default" ? 3.2 : is_bold(method) ? 2.4 : 1.5

high = 912
wide = 184.0
tall = 190.0
names_left = 0
name_x = wide + 22
heading = "Where formulas fail: the way into each singularity"

eval begin("stability")
eval error_tics
set logscale x
set xrange [0.100001:1e-16]
set xtics ("0.1" 0.1, "10^{-4}" 1e-4, "10^{-8}" 1e-8, "10^{-12}" 1e-12, "10^{-16}" 1e-16) \
    scale 0.4 nomirror font small tc rgb ink offset 0,0.3
set multiplot
set label 1 heading at screen 0.5,down(18) center font sized(16) tc rgb ink
last = 1e-16
do for [p = 1:6] {
    sweep = word(sweeps, p)
    left = 58 + (p - 1) % 2 * 376
    top = 66 + (p - 1) / 2 * 262
    load "stability-panel.gp"
    set label 10 word(headings, p) at screen across(left + wide / 2),down(top - 16) center font bold(13) tc rgb ink
    set label 11 "distance to " . word(singularities, p) . ", rad" at screen across(left + wide / 2),down(top + tall + 34) center font sized(11) tc rgb ink
    set label 12 (error_of(sweep) eq "relative" ? relative_title : error_title) \
        at screen across(left - 43),down(top + tall / 2) center rotate font sized(11) tc rgb ink
    plot for [i = n:1:-1] csv using (of_method(sweep, word(names, i)) ? column("distance") : NaN) \
        :(height(column(error_of(sweep)), column("not_finite"))) with lines lw weight(word(names, i)) lc rgb colour(word(names, i)) \
        title label_of(word(names, i))
    unset label
    unset arrow
    unset object
}
# Below the panels.
set label 1 "Every panel runs from a tenth of a radian on its left into the singularity on its right." \
    at screen across(58),down(862) left tc rgb ink
set label 2 "Grey: right to the last digits. Above: digits lost, up to a wrong attitude (180°) or none (nan)." \
    at screen across(58),down(880) left tc rgb ink
unset border
unset tics
plot NaN
unset label
unset multiplot
unset output
system described(heading, "Six panels, each the worst error of rotconv, of Eigen and of published methods by the distance to a " \
    . "singularity. The lines of rotconv stay low to the end; some methods lose all digits on the way. The figures are in methods.csv.")

# --- Noise ---------------------------------------------------------------------------------------------------------

sweep = "dcm-quat/noise"
last = 0.1
high = 342
heading = "A noisy matrix to a quaternion"
wide = 540.0
tall = 230.0
name_x = wide + 26
eval begin("noise")
set border 3 lc rgb ink
eval error_tics
set xrange [1e-16:0.1]
set xtics ("10^{-16}" 1e-16, "10^{-12}" 1e-12, "10^{-8}" 1e-8, "10^{-4}" 1e-4, "0.1" 0.1) scale 0.4 nomirror font small tc rgb ink offset 0,0.3
left = 72
top = 48
load "stability-panel.gp"
set label 1 heading at screen 0.5,down(18) center font sized(16) tc rgb ink
set label 11 "noise: each number of the matrix is off by up to this" at screen across(left + wide / 2),down(top + tall + 38) center font sized(11) tc rgb ink
set label 12 "worst error against the\nnearest rotation, 2^{-52} rad" at screen across(left - 53),down(top + tall / 2) center rotate font sized(11) tc rgb ink
plot for [i = n:1:-1] csv using (of_method(sweep, word(names, i)) ? column("distance") : NaN) \
    :(height(column("worst"), column("not_finite"))) with lines lw weight(word(names, i)) lc rgb colour(word(names, i)) \
        title label_of(word(names, i))
unset output
system described(heading, "The worst error of rotconv, of Eigen and of published methods by the noise in the numbers of the matrix. " \
    . "Methods that look for the nearest rotation lose no digit. The figures are in methods.csv.")

# Rows per second by threads and by the width of the rows, from bench_scaling's figures:
# gnuplot -e "csv='scaling.csv'; out='DIRECTORY'" scaling.gp, in this folder

load "common.gp"
set datafile missing NaN # the lines go on over the rows of others

colour_of(form) = form eq "text" ? colour("default") : form eq "copy" ? "#8a8a8a" : ink
threads = 1 # the processors of the machine that measured
widest = 0
stats csv using (threads = column("threads") > threads ? column("threads") : threads, \
    widest = column("others") > widest ? column("others") : widest) nooutput
runs = threads > 1 ? sprintf("%d 1", threads) : "1"
dash(run) = run eq "1" && threads > 1 ? 2 : 1
threads_of(run) = run eq "1" ? "1 thread" : run . " threads"
chosen(form, condition) = stringcolumn("form") eq form && condition ? column("rows_per_second") : NaN

y_low = 2e5
y_high = 1e8
# The end of a line: its name, and where `stats` finds it, before the axes have ranges.
end_of(form, name, others, run) = sprintf("stats csv using (chosen('%s', column('others') == %d && column('threads') == %s)) nooutput; " \
    . "m = m + 1; end_x[m] = wide; end_y[m] = tall * log10(STATS_max / y_low) / log10(y_high / y_low); end_name[m] = '%s'; " \
    . "end_colour[m] = colour_of('%s'); end_bold[m] = 0", form, others, run, name, form)

high = 342
tall = 220.0
top = 56
names_left = 0
heading = "Quaternions to matrices: rows a second"
eval begin("scaling")
set logscale y
set ytics ("1 million" 1e6, "10 million" 1e7, "100 million" 1e8) scale 0.4 nomirror font small tc rgb ink
set grid ytics lc rgb "#e3e3e3" lt 1
set multiplot
set label 1 heading at screen 0.5,down(18) center font sized(16) tc rgb ink

# --- Threads -------------------------------------------------------------------------------------------------------

left = 96
wide = 150.0
name_x = wide + 18
m = 0
set autoscale
do for [form in "doubles text"] {
    eval end_of(form, form, 0, word(runs, 1))
}
load "names.gp"
set label 12 "rows a second" at screen across(left - 78),down(top + tall / 2) center rotate font small tc rgb ink
eval place_panel(left, top)
set yrange [y_low:y_high]
set xrange [0.8:threads + 0.0001]
set xtics 1 scale 0.4 nomirror font small tc rgb ink
set label 11 sprintf("threads, up to the machine's %d processors", threads) at screen across(left + wide / 2),down(top + tall + 38) center font small tc rgb ink
plot for [form in "doubles text"] csv using (column("threads")):(chosen(form, column("others") == 0)) \
    with linespoints pt 7 ps 0.6 lw 2 lc rgb colour_of(form) title form
unset label
unset arrow

# --- Width ---------------------------------------------------------------------------------------------------------

left = 408
wide = 222.0
name_x = wide + 18
m = 0
set autoscale
do for [form in "doubles text"] {
    do for [run in runs] {
        eval end_of(form, form . ", " . threads_of(run), widest, run)
    }
}
eval end_of("copy", "a copy by cat", widest, "1")
load "names.gp"
set label 12 "rows a second" at screen across(left - 78),down(top + tall / 2) center rotate font small tc rgb ink
eval place_panel(left, top)
set logscale x
set yrange [y_low:y_high]
set xrange [0.8:widest + 1]
set xtics ("0" 1, "1" 2, "4" 5, "16" 17, "64" 65, "256" 257) scale 0.4 nomirror font small tc rgb ink
set label 11 "other fields in a row, which pass as they are" at screen across(left + wide / 2),down(top + tall + 38) center font small tc rgb ink
plot csv using (column("others") + 1):(chosen("copy", 1)) with linespoints pt 7 ps 0.4 lw 1 dt 3 lc rgb colour_of("copy") title "copy", \
    for [form in "doubles text"] for [run in runs] \
    csv using (column("others") + 1):(chosen(form, column("threads") == int(run))) \
    with linespoints pt 7 ps 0.6 lw 2 dt dash(run) lc rgb colour_of(form) title form . ", " . threads_of(run)
unset multiplot
unset output
system described(heading, "Two panels. Left: rows of text and of binary doubles a second, by the number of threads. " \
    . "Right: the same by the number of other fields in a row, with one thread and with all, and of a copy of the text by cat. The figures are in scaling.csv.")

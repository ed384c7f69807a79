# Rows per second by threads and by the width of the rows, from bench_scaling's figures:
# gnuplot -e "csv='scaling.csv'; out='DIRECTORY'" scaling.gp, in this folder

load "common.gp"
set datafile missing NaN # the lines go on over the rows of others

high = 340
wide = 280.0 # of a panel, pixels
tall = 220.0
doubles = "#1769aa"
text = "#c1121f"
threads = 1 # the processors of the machine that measured
stats csv using (column("others") > 0 && column("threads") > threads ? (threads = column("threads"), 1) : NaN) nooutput

rate(form, chosen) = stringcolumn("form") eq form && chosen ? column("rows_per_second") : NaN
eval begin("scaling")
set logscale y
set yrange [2e5:8e7]
set ytics ("100 000" 1e5, "1 million" 1e6, "10 million" 1e7) scale 0.4 nomirror font small tc rgb ink
set grid ytics lc rgb "#e3e3e3" lt 1
set multiplot
set label 1 "Rows per second, quaternions to matrices" at screen 0.5,down(18) center font sized(16) tc rgb ink
eval place_panel(84, 50)
set xrange [0.8:*]
set xtics 1 scale 0.4 nomirror font small tc rgb ink
set xlabel sprintf("threads, on %d processors", threads) font small tc rgb ink
set label 2 "doubles" at first 2.7,2.2e7 font bold(12) tc rgb doubles
set label 3 "text" at first 2.7,2.6e6 font bold(12) tc rgb text
plot csv using (column("threads")):(rate("doubles", column("others") == 0)) with linespoints pt 7 ps 0.6 lw 2 lc rgb doubles, \
     csv using (column("threads")):(rate("text", column("others") == 0)) with linespoints pt 7 ps 0.6 lw 2 lc rgb text
unset label 1
eval place_panel(450, 50)
set xrange [0.8:400]
set logscale x
set xtics ("0" 1, "1" 2, "4" 5, "16" 17, "64" 65, "256" 257) scale 0.4 nomirror font small tc rgb ink
set format y " "
set xlabel "other fields in a row, which pass" font small tc rgb ink
set label 2 "doubles" at first 24,1.5e7
set label 3 "text" at first 2,1.5e6
set label 4 sprintf("solid: %d threads;  dashed: 1 thread", threads) at graph 0.03,0.06 font small tc rgb ink
plot for [form in "doubles text"] csv using (column("others") + 1):(rate(form, column("threads") == threads)) \
         with linespoints pt 7 ps 0.6 lw 2 dt 1 lc rgb (form eq "text" ? text : doubles), \
     for [form in "doubles text"] csv using (column("others") + 1):(rate(form, column("threads") == 1)) \
         with linespoints pt 7 ps 0.6 lw 2 dt 2 lc rgb (form eq "text" ? text : doubles)
unset multiplot
unset output

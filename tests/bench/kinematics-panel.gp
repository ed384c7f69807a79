# The panel of one motion at (left, top): see kinematics.gp. `kind`, `finest` (its least step) and the columns `axis` and
# `what` say what is drawn.

set autoscale # the ranges of the panel before would limit `stats`
m = 0
drawn = ""
said = 0
do for [i = 1:n] {
    reach = 0 # and `ending`: the end of the line that its name stands at
    ending = 0
    until = -1
    stats csv using (of_way(i, kind, motion) && stringcolumn(12) eq "ok" && column(what) > 0 \
        ? (reach = names_left && reach > 0 ? reach : column(axis), \
            ending = names_left && ending > 0 ? ending : column(what), 1) : 1) nooutput
    stats csv using (of_way(i, kind, motion) && column(5) == finest && stringcolumn(12) eq "singular" \
        ? (until = column(7), 1) : 1) nooutput
    drawn = drawn . (reach > 0 ? sprintf(" %d", i) : "")
    if (reach > 0 && (kind eq "work" || until < 0)) {
        m = m + 1
        end_x[m] = wide * log10(reach / x_low) / log10(x_high / x_low)
        end_y[m] = tall * log10(ending / y_low) / log10(y_high / y_low)
        end_name[m] = named(i)
        end_colour[m] = way_colour[i]
        end_bold[m] = i == n
    }
    if (until >= 0 && what == 8) {
        set label 60 + said sprintf("%s: %s at %.1f s", named(i), why(set_of[i]), until) \
            at screen across(left + wide - 2),down(top + 15 * said + 6) right font small tc rgb way_colour[i]
        said = said + 1
    }
}
load "names.gp"
eval place_panel(left, top)
set xrange [x_low:x_high]
set yrange [y_low:y_high]
set label 10 over at screen across(left + wide / 2),down(top - 32) center font bold(13) tc rgb ink
set label 11 defined at screen across(left + wide / 2),down(top - 15) center font small tc rgb ink
set label 12 x_title at screen across(left + wide / 2),down(top + tall + 34) center font small tc rgb ink
set label 13 y_title at screen across(left - 54),down(top + tall / 2) center rotate font small tc rgb ink
plot for [k = 1:words(drawn)] csv using (of_way(word(drawn, k) + 0, kind, motion) ? column(axis) : NaN):what with lines \
    lc rgb way_colour[word(drawn, k) + 0] lw (word(drawn, k) + 0 == n ? 3 : 1.8) dt dash[word(drawn, k) + 0] \
    title named(word(drawn, k) + 0)
unset label
unset arrow

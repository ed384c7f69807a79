# The names of a sweep's methods, each at the end of its line, and the panel at (left, top): see stability.gp.

names = ""
stats csv using (of_sweep(sweep) && column("distance") == last && place_in(shown_on(sweep), stringcolumn("method")) > 0 \
    ? (names = names . " " . stringcolumn("method"), 1) : NaN) nooutput
n = words(names)
m = n
do for [i = 1:n] {
    stats csv using (of_method(sweep, word(names, i)) && column("distance") == last \
        ? height(column(error_of(sweep)), column("not_finite")) : NaN) nooutput
    end_x[i] = wide
    end_y[i] = tall * STATS_max
    end_name[i] = label_of(word(names, i))
    end_colour[i] = colour(word(names, i))
    end_bold[i] = is_bold(word(names, i))
}
load "names.gp"
eval place_panel(left, top)
eval good_half

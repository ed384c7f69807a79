# What the charts share: one page width, one colour for each method everywhere, names beside what they name. The
# background is white, so that a dark page shows them too.

set datafile separator comma
set encoding utf8

ink = "#222222"
plain = "#6c757d"

page = 760.0 # pixels; `high` of a chart, `wide` and `tall` of its panels are its own
whole = 38 # pixels: a multiple of so many is high a whole number of pixels at a width of 700 too
sized(pixels) = sprintf("sans-serif,%g", pixels)
small = sized(11)
bold(pixels) = sprintf("sans-serif:Bold,%g", pixels)
begin(name) = sprintf("chart = '%s/%s.svg'; high = whole * ceil(1.0 * high / whole); " \
    . "set terminal svg size %d,high font '%s' background 'white' enhanced; set output chart", out, name, page, sized(12))
# After `unset output`: `system described(...)` says in the file what it shows, for those who do not see it.
described(title, text) = sprintf("sed -i 's|<title>Gnuplot</title>|<title>%s</title>|; s|<desc>.*</desc>|<desc>%s</desc>|' '%s'", \
    title, text, chart)
width_of(text) = 6.6 * strlen(text) # of 11 pixels high, nearly

# Pixels from the upper left corner.
across(x) = x / page
down(y) = 1 - y / (1.0 * high)
place_panel(left, top) = sprintf( \
    "set lmargin at screen %f; set rmargin at screen %f; set tmargin at screen %f; set bmargin at screen %f", \
    across(left), across(left + wide), down(top), down(top + tall))

# --- Methods -------------------------------------------------------------------------------------------------------

method_names = "default fast typed Eigen trace shepperd klumpp sarabandi-thomas bar-itzhack polar compensated" \
    . " acos atan2 gtsam hertzberg classic matrix-threshold bernardes-arccos bernardes-atan2 asin slabaugh shoemake shuster-markley"
method_colours = "#c1121f #c2560a #8f6b00 #1769aa #6c757d #1f8a4d #8c5a3c #c21e7a #7b3fb5 #b0468a #0b7d7f" \
    . " #6c757d #6b7a12 #c21e7a #1f8a4d #6c757d #8c5a3c #7b3fb5 #1f8a4d #6c757d #8c5a3c #7b3fb5 #1f8a4d"
place_in(list, name) = sum [i = 1:words(list)] (word(list, i) eq name ? i : 0)
colour(method) = place_in(method_names, method) > 0 ? word(method_colours, place_in(method_names, method)) : plain
label_of(method) = method eq "default" ? "rotconv, exact" : method eq "fast" ? "rotconv, fast" \
    : method eq "typed" ? "rotconv, C++ call" : method
is_ours(method) = method eq "default" || method eq "fast" || method eq "typed"
is_bold(method) = is_ours(method) || method eq "Eigen"

# --- Errors --------------------------------------------------------------------------------------------------------

# Errors up to 10 eps have the lower half of a panel, the failures the upper half.
half_turn = pi / 2.0**-52
no_number = 0.97 # the height of rows without a finite result
least_error = 0.2
h(error) = error < 10 ? 0.5 * log10((error < least_error ? least_error : error) / least_error) / log10(10 / least_error) \
    : 0.5 + 0.38 * log10(error / 10) / log10(half_turn / 10)
height(error, not_finite) = not_finite > 0 ? no_number : h(error > half_turn ? half_turn : error)

error_title = "worst error of attitude, 2^{-52} rad"
error_tics = "set yrange [0:1]; set ytics ('≤ 0.2' h(0.2), '0.5' h(0.5), '1' h(1), '2' h(2), '5' h(5), '10' h(10), '10^4' h(1e4), " \
    . "'10^8' h(1e8), '10^{12}' h(1e12), '180°' h(half_turn), 'nan' no_number) scale 0.4 nomirror font small " \
    . "tc rgb ink offset 0.6,0"
error_xtics = "set xtics ('≤ 0.2' h(0.2), '1' h(1), '10' h(10), '10^8' h(1e8), '180°' h(half_turn), '\nnan' no_number) " \
    . "scale 0.4 nomirror font small tc rgb ink offset 0,0.4"
good_half = "set object 1 rectangle from graph 0,0 to graph 1,0.5 fc rgb '#eef1f4' fs noborder behind"

set border 3 lc rgb ink
unset key

# --- Lines that end at their names, see names.gp ---------------------------------------------------------------------

array end_x[20]
array end_y[20]
array end_name[20]
array end_colour[20]
array end_bold[20]

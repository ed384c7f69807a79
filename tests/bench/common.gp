# What both charts share. Errors up to 10 eps have the lower half of each panel, the failures the upper half.

set datafile separator comma
set encoding utf8

strong = "#d1495b" # rotconv's default
eigen = "#1f77b4"
plain = "#747a83"
ink = "#333333"

half_turn = pi / 2.0**-52
no_number = 0.97 # the height of rows without a finite result
h(error) = error < 10 ? 0.5 * log10((error < 0.3 ? 0.3 : error) / 0.3) / log10(10 / 0.3) \
    : 0.5 + 0.42 * log10(error / 10) / log10(half_turn / 10)
height(error, not_finite) = not_finite > 0 ? no_number : h(error > half_turn ? half_turn : error)

colour(method) = method eq "default" || method eq "typed" ? strong : method eq "Eigen" ? eigen : plain
label_of(method) = method eq "typed" ? "default, typed" : method

# A font by its size in pixels, and the commands that begin a picture 830 pixels wide; the PNG has twice as many.
sized(pixels) = sprintf("sans-serif,%g", kind eq "svg" ? pixels : 0.75 * pixels)
bold(pixels) = sprintf("sans-serif:Bold,%g", kind eq "svg" ? pixels : 0.75 * pixels)
begin(name) = sprintf("set terminal %s font '%s' background 'white' enhanced; set output '%s/%s.%s'", \
    kind eq "svg" ? sprintf("svg size 830,%d", high) \
        : sprintf("pngcairo size 1660,%d fontscale 2 pointscale 2 linewidth 2", 2 * high), sized(11), out, name, kind)

# Pixels from the upper left corner.
across(x) = x / 830.0
down(y) = 1 - y / (1.0 * high)
place_panel(left, top) = sprintf( \
    "set lmargin at screen %f; set rmargin at screen %f; set tmargin at screen %f; set bmargin at screen %f", \
    across(left), across(left + wide), down(top), down(top + tall))

set yrange [0:1]
set border 3 lc rgb ink
unset key
error_tics = "set ytics ('0.5' h(0.5), '1' h(1), '2' h(2), '5' h(5), '10' h(10), '10^4' h(1e4), '10^8' h(1e8), " \
    . "'10^{12}' h(1e12), '180°' h(half_turn), 'nan' no_number) scale 0.4 nomirror font small tc rgb ink offset 0.6,0"

# Names in a column, each as near to the end of its line as the others leave it. `load` it with the panel's left, top, wide,
# tall, the column's name_x, names_left where it stands left of the ends, and m lines: end_x, end_y, end_name, end_colour,
# end_bold. Pixels in the panel, from its left and from its bottom.

line_gap = 14.0
array name_y[m]
array order[m]
rank(i) = end_y[i] + (names_left ? 0.3 * end_x[i] : 0) # names on the left: a line that begins further right is reached from above
do for [i = 1:m] {
    order[1 + (sum [j = 1:m] (rank(j) < rank(i) || (rank(j) == rank(i) && j < i)))] = i
}
do for [i = 1:m] {
    name_y[i] = end_y[i]
}
do for [round = 1:60] { # neighbours push each other away, the panel's top and bottom push them back
    do for [k = 1:m] {
        upper = order[k]
        lower = k > 1 ? order[k - 1] : 0
        lack = k > 1 ? line_gap - (name_y[upper] - name_y[lower]) : 2 - name_y[upper]
        name_y[upper] = name_y[upper] + (lack > 0 ? (k > 1 ? lack / 2 : lack) : 0)
        if (k > 1) {
            name_y[lower] = name_y[lower] - (lack > 0 ? lack / 2 : 0)
        }
        name_y[upper] = name_y[upper] > tall ? tall : name_y[upper]
    }
}
side = names_left ? "right" : "left"
do for [i = 1:m] {
    set label 100 + i end_name[i] at screen across(left + name_x),down(top + tall - name_y[i]) @side \
        font (end_bold[i] ? bold(11) : small) tc rgb end_colour[i]
    set arrow 100 + i from screen across(left + end_x[i] + (names_left ? -2 : 2)),down(top + tall - end_y[i]) \
        to screen across(left + name_x + (names_left ? 3 : -3)),down(top + tall - name_y[i]) nohead lw 0.7 lc rgb end_colour[i]
}

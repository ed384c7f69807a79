# Prints the rows of figures.inc from the measurement:
#   awk -F, -f src/core/methods/figures.awk examples/charts/methods.csv > src/core/methods/figures.inc
# A stratum with results that are not finite is worse than any error. Rows with a distance belong to the charts of
# stability; Eigen and the typed calls of the default are no methods.

function worst(row, hostile) {
    row = row "," hostile
    return sprintf("{%s, \"%s\"}", not_finite[row] > 0 ? "nan" : sprintf("%.2g", error[row]), where[row])
}

NR > 1 && $3 != "Eigen" && $3 != "typed" && $6 == "" && $4 != "clean" && $4 != "hostile" {
    row = $1 "," $2 "," $3
    if (!(row in seen)) {
        seen[row] = 1
        order[++rows] = row
    }
    row = row "," $5
    if (!(row in where) || $8 > not_finite[row] || ($8 == not_finite[row] && $9 > error[row])) {
        not_finite[row] = $8
        error[row] = $9
        where[row] = $4
    }
}

END {
    for (i = 1; i <= rows; ++i) {
        split(order[i], names, ",")
        printf "{Name::%s, Name::%s, \"%s\", %s, %s},\n", names[1], names[2], names[3], worst(order[i], 0), worst(order[i], 1)
    }
}

# mawk -f formula.awk: the textbook's formula.
BEGIN {
    FS = OFS = ","
    OFMT = "%.17g"
    degrees = 45 / atan2(1, 1)
}
{
    print degrees * atan2($8, $9), degrees * atan2(-$7, sqrt($8 * $8 + $9 * $9)), degrees * atan2($4, $1)
}

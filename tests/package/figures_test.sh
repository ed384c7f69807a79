#!/bin/sh
# figures_test.sh FOLDER: what the pages of examples say of their charts, and the table of comparison.md, is what was measured.
set -eu
scripts=$(cd "$(dirname "$0")/../bench" && pwd)
cd "$1"
work=$(mktemp)
drawn=$(mktemp -d)
trap 'rm -rf "$work" "$drawn"' EXIT
fail() {
    echo "FAILED: $*"
    exit 1
}

# Each chart can be drawn from what was measured.
if command -v gnuplot > /dev/null; then
    charts=$PWD/charts
    for each in scaling:scaling methods:speed methods:stability kinematics:kinematics sets:sets tools:tools; do
        (cd "$scripts" && gnuplot -e "csv='$charts/${each%:*}.csv'; out='$drawn'" "${each#*:}.gp")
    done
    for each in charts/*.svg; do
        [ -s "$drawn/${each#charts/}" ] || fail "no script draws $each"
    done
fi

# claims PAGE MEASUREMENT PROGRAM: the program of awk prints phrases that stand in the page, however its lines are broken.
claims() {
    awk -F, "$3" "charts/$2" | sed 's/e[+]0*/e/; s/e-0*/e-/g' > "$work"
    [ -s "$work" ] || fail "$1: nothing was measured"
    while IFS= read -r phrase; do
        tr '\n' ' ' < "$1" | grep -qF -- "$phrase" || fail "$1 does not say: $phrase"
    done < "$work"
}
# shellcheck disable=SC2016 # the programs are for awk
claims methods.md methods.csv '
    $1 FS $2 FS $4 == "dcm,quat,clean" { time[$3] = $13; ratio[$3] = $15; clean[$3] = $9 }
    $1 FS $2 FS $4 == "dcm,quat,hostile" { noisy_time[$3] = $13; noisy_ratio[$3] = $15; hostile[$3] = $9 }
    $1 FS $2 FS $3 FS $4 == "quat,euler,default,clean" { to_angles = $15 }
    END {
        printf "method takes %.2g of the time of Eigen\n", ratio["shepperd"]
        printf "lose %.0f digits on noisy\n", log(hostile["shepperd"] / clean["shepperd"]) / log(10)
        printf "lose %.0f digits on noisy\n", log(hostile["Eigen"] / clean["Eigen"]) / log(10)
        printf "takes %.2g times that call, %.2g ns a row\n", ratio["default"], time["default"]
        printf "noise it takes %.2g times, %.2g ns\n", noisy_ratio["default"], noisy_time["default"]
        printf "from a quaternion it takes %.1g times that call\n", to_angles
    }'
# shellcheck disable=SC2016
claims methods.md methods.csv '
    $5 == "0" { time[$1 FS $2 FS $3 FS $4] = $13 }
    END {
        split("dcm,quat quat,euler dcm,euler quat,rotvec", pairs, " ")
        split("Eigen typed default", methods, " ")
        split("Eigen|rotconv, C++ call|rotconv, exact", names, "|")
        split("clean small half-turn lock", kinds, " ")
        for (p = 1; p <= 4; ++p) for (m = 1; m <= 3; ++m) {
            pair = pairs[p]
            sub(",", " to ", pair)
            printf "| %s | %s |", pair, names[m]
            for (k = 1; k <= 4; ++k) {
                ns = time[pairs[p] FS methods[m] FS kinds[k]]
                printf " %s |", ns == "" ? "" : sprintf(ns < 10 ? "%.1f" : "%.0f", ns)
            }
            print ""
        }
    }'
claims charts/speed.svg methods.csv '
    $3 FS $4 == "default,clean" && $15 != "" { if ($15 > most) most = $15; if (!least || $15 < least) least = $15 }
    END { printf "Exactness takes %.1g to %.0f times the time of Eigen\n", least, most }'
claims accuracy.md methods.csv '
    $1 FS $2 FS $3 FS $4 FS $6 == "dcm,quat,Eigen,noise,1e-08" { printf "is off by about %.0e x 2^-52 rad\n", $9 }'
claims streams.md scaling.csv '
    $1 FS $3 == "text,0" { rate[$2] = $4 / 1e6 }
    END { printf "one thread converts %.1f million rows of text a second, and two convert %.1f million\n", rate[1], rate[2] }'
claims ../README.md tools.csv '
    { worst = $8; for (i = 9; i <= 11; ++i) { if ($i > worst) worst = $i } }
    NR > 5 && $8 > uniform { uniform = $8 }
    $1 == "NumPy" || $1 == "mawk" || $1 == "Miller" || $1 == "DuckDB" { lost += worst > 3.14 - 0.01 }
    $1 == "pandas + SciPy" { scipy = worst }
    $1 == "C++: Eigen + iostreams" { eigen = worst }
    $1 == "rotconv on 1 thread" { rate = $7 / 1e6; own = worst }
    $1 == "rotconv on 2 threads" { rate_of_two = $7 / 1e6 }
    END {
        printf "every tool is accurate to %s rad. The filled marks\n", not_below(uniform)
        if (lost == 4) print "NumPy, mawk, Miller and DuckDB, loses the attitude at gimbal lock; SciPy"
        else print "not all formulas lose the attitude"
        printf "from the rotation nearest to a noisy matrix by %.0e rad, which is the size of the noise;", (scipy > eigen ? scipy : eigen)
        printf " rotconv stays within %s rad.\n", not_below(own)
        printf "rotconv converts %.1f million rows a second on one thread and %.1f million on two\n", rate, rate_of_two
    }
    # One digit, rounded up.
    function not_below(x,   text, parts) {
        text = sprintf("%.0e", x)
        if (text + 0 >= x * (1 - 1e-9)) return text
        split(text, parts, "e")
        return sprintf("%.0e", (parts[1] + 1 "e" parts[2]) + 0)
    }'
claims streams.md tools.csv '
    { least = $4; for (i = 5; i <= 6; ++i) { if ($i < least) least = $i } time[$1] = least }
    END {
        printf "DuckDB takes %.2f s for a million rows\n", time["DuckDB"]
        printf "is %.2f times as fast as rotconv on one thread\n", time["rotconv on 1 thread"] / time["C++: Eigen + fast_float"]
    }'
claims comparison.md kinematics.csv '
    $1 FS $2 FS $4 FS $6 FS $7 == "drift,tumbling,rk4,0,1e+04" { error[$3] = $8; drift[$3] = $11 }
    END {
        printf "the matrix is off by %.1e rad, and its nine numbers are %.1e away", error["dcm"], drift["dcm"]
        printf " from a rotation; for the quaternion these figures are %.1e rad and %.1e\n", error["quat"], drift["quat"]
    }'
claims comparison.md kinematics.csv '
    $1 FS $2 FS $12 == "drift,tumbling,singular" { printf $3 == "cayley" ? "half-turn at %.1f s\n" : "after %.1f s\n", $7 }'

# The table.
awk -F, '$1 == "work" && $2 == "tumbling" && $5 == 0.01 && $6 == 0 && $12 == "ok" {
        printf "%s %s %.1e %.1e %.3g\n", $3, $4, $8, $11, $9
    }' charts/kinematics.csv | sed 's/e-0/e-/g' > "$work"

found=0
while IFS='|' read -r _ set _ _ error drift time _; do
    set=$(echo "$set" | tr -d '`,')
    # shellcheck disable=SC2086 # words
    set -- $set
    case "$*" in
    *magnus*) integrator=$2 ;;
    *) integrator=rk4 ;;
    esac
    measured=$(grep "^$1 $integrator " "$work") || fail "not measured: $1 $integrator"
    error=$(echo $error)
    drift=$(echo $drift)
    seconds=$(echo "$time" | tr -d ' ' | awk '{ printf "%.3g", $1 }')
    expected="$1 $integrator $error ${drift:-0.0e+00}"
    case "$measured" in
    "$expected "*) ;;
    *)
        echo "the page says $expected, the measurement $measured"
        exit 1
        ;;
    esac
    echo "$measured $seconds" | awk '{ exit !($6 > 0.99 * $5 && $6 < 1.01 * $5) }' ||
        fail "the page says $seconds ns, the measurement $measured"
    found=$((found + 1))
done <<END
$(grep '^| `' comparison.md | grep -v half-turn)
END
sets=$(sed -n 's/^| `\([^`:]*\).*/\1/p' comparison.md | sort -u | wc -l)
head -n 1 comparison.md | grep -q " eight " && [ "$sets" -eq 8 ] ||
    fail "$sets sets are listed: $(head -n 1 comparison.md)"
[ "$found" -eq 9 ] || fail "$found rows of the table were checked, not 9"

#!/bin/sh
# symbols_test.sh METHODS CORE LIBRARY...: no object of a LIBRARY calls a function of the C library whose digits depend on the C library
# or the processor. Square roots, remainders, scaling and rounding to integers are exact. METHODS, the library of the published
# formulas, calls some, so that the test can fail.
set -eu
methods=$1
core=$2
shift

# calls LIBRARY...: the lines "OBJECT: FUNCTION" of such calls.
calls() {
    nm -A -u "$@" 2> /dev/null | sed -nE 's/^[^:]*:([^:]*):? +U ([a-z0-9_]+)(@.*)?$/\1: \2/p' |
        grep -E ': (a?(sin|cos|tan)h?|sincos|atan2|hypot|pow|exp(2|10|m1)?|log(2|10|1p)?|cbrt|erfc?|[lt]gamma)[fl]?$' |
        sort -u
}
calls "$methods" | grep -q ': atan2$' || {
    echo "FAILED: no call is seen in $methods, which has some"
    exit 1
}
found=$(calls "$@" || true)
[ -z "$found" ] || {
    printf 'FAILED: functions of the C library are called\n%s\n' "$found"
    exit 1
}

# What the core compiles of Eigen's templates is bound inside it, or users' own copies of them, made with other flags, could take
# their place, and bytes change.
weak=$(nm -C "$core" 2> /dev/null | sed -n 's/^[0-9a-f]* [WV] //p' | grep -E '^([a-z]+ )*Eigen::' | grep -v 'rotconv::' | sort -u || true)
[ -z "$weak" ] || {
    printf 'FAILED: users could replace\n%s\n' "$weak"
    exit 1
}

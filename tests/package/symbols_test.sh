#!/bin/sh
# symbols_test.sh METHODS LIBRARY...: no object of a LIBRARY calls a function of the C library whose digits depend on the C library
# or the processor. Square roots, remainders, scaling and rounding to integers are exact. METHODS, the library of the published
# formulas, calls some, so that the test can fail.
set -eu
methods=$1
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

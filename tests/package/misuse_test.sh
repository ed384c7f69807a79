#!/bin/sh
# misuse_test.sh COMPILER BUILD SOURCE EIGEN: misuse.cpp with flags that take checks away, for other processors, without exceptions,
# as C++23, and with clang against the library as it was built. Catches a check that a flag removes, a header that needs exceptions,
# and a mistake that compiles, or is told in a wall of text.
set -eu
compiler=$1
build=$2
source=$3
eigen=$4
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failed=0
newer=
! grep -qw avx2 /proc/cpuinfo 2> /dev/null || newer=-mavx2
try() { # COMPILER FLAG...
    "$@" -Wall -Wextra -Wconversion -DNDEBUG -I "$source/include" -isystem "$eigen" "$source/tests/package/misuse.cpp" "$build/librotconv_core.a" \
        -o "$work/misuse" > "$work/log" 2>&1 && "$work/misuse" > "$work/log" 2>&1 || {
        echo "FAILED: $*"
        head -n 20 "$work/log"
        failed=1
    }
}
# shellcheck disable=SC2086 # no flag on other processors
try "$compiler" -std=c++20 -O3 -ffast-math $newer
try "$compiler" -std=c++23 -O1 -fno-exceptions
if command -v clang++ > /dev/null; then
    try clang++ -std=c++20 -O2 -ffast-math
    # shellcheck disable=SC2086
    try clang++ -std=c++2b -O2 -fno-exceptions $newer
fi

# g++ has the sentence in its error, clang in the note on it. For a variable at namespace scope clang 14 leaves
# it to the linker.
refused() { # SENTENCE CODE
    printf '#include <rotconv/rotconv.hpp>\nauto result(const rotconv::Rotation& rotation) { return %s; }\n' "$2" > "$work/wrong.cpp"
    for each in "$compiler" clang++; do
        command -v "$each" > /dev/null || continue
        ! "$each" -std=c++20 -fsyntax-only -I "$source/include" -isystem "$eigen" "$work/wrong.cpp" > "$work/log" 2>&1 &&
            [ "$(grep -c error: "$work/log")" -eq 1 ] &&
            grep -E '(error|note):' "$work/log" | head -n 2 | grep -q "$1" || {
            echo "FAILED: $2 compiles with $each, or its first error does not say: $1"
            head -n 20 "$work/log"
            failed=1
        }
    done
}
refused an_euler_sequence_has_three_letters 'rotconv::euler::from_rotation(rotation, "ZZX")'
refused 'turns vectors of three numbers' 'rotation * Eigen::Vector4d(1, 2, 3, 4)'
exit "$failed"

#!/bin/sh
# install_test.sh CMAKE BUILD SOURCE: installs into an empty folder, looks for what should be there, and builds an outside project
# against it.
set -eu
cmake=$1
build=$2
source=$3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() {
    echo "FAILED: $*"
    exit 1
}

"$cmake" --install "$build" --prefix "$work/usr" > "$work/log"
for file in bin/rotconv include/rotconv/rotconv.hpp share/man/man1/rotconv.1 share/doc/rotconv/LICENSE \
    share/doc/rotconv/LGPL-2.1 share/bash-completion/completions/rotconv share/zsh/site-functions/_rotconv \
    share/fish/vendor_completions.d/rotconv.fish share/pkgconfig/rotconv.pc; do
    [ -f "$work/usr/$file" ] || fail "$file is not installed"
done
# Each library of CMakeLists.txt, and the two runtimes, has its notice.
for library in $(sed -n 's/^find_package(\([A-Za-z]*\).*/\1/p' "$source/CMakeLists.txt" | grep -v Threads) 'libstdc++' 'GNU.C.library'; do
    grep -qi "^\(the \)\?$library" "$work/usr/share/doc/rotconv/NOTICES" || fail "no notice of $library"
done
version=$("$work/usr/bin/rotconv" --version)
version=${version% (*} # without the kernels of this processor
grep -q "^version: ${version#rotconv }$" "$work/usr/share/doc/rotconv/CITATION.cff" ||
    fail "CITATION.cff is not of the version of the program, $version"
grep -q "^set(PACKAGE_VERSION \"${version#rotconv }\")" "$work"/usr/lib*/cmake/rotconv/rotconvConfigVersion.cmake \
    "$work"/usr/lib*/*/cmake/rotconv/rotconvConfigVersion.cmake 2> /dev/null ||
        fail "the package is not of the version of the program, $version"
! ldd "$work/usr/bin/rotconv" | grep -vE 'statically linked|linux-vdso|libstdc\+\+|libgcc_s|libm\.|libc\.|ld-linux' ||
    fail "the program needs more than the C and C++ runtime"

cp -r "$source/examples/cpp" "$work/project"
cp "$source/tests/package/consumer.cpp" "$work/project"
# The consumer is compiled for a newer processor than the library, if this machine has one: no layout may depend on that.
newer=
! grep -qw avx2 /proc/cpuinfo 2> /dev/null || newer=-march=haswell
cat >> "$work/project/CMakeLists.txt" <<END
add_executable(consumer consumer.cpp)
target_link_libraries(consumer PRIVATE rotconv::core)
target_compile_options(consumer PRIVATE $newer)
END
"$cmake" -S "$work/project" -B "$work/project/build" -DCMAKE_PREFIX_PATH="$work/usr" -DCMAKE_CXX_FLAGS="${CXXFLAGS:-}" > "$work/log"
"$cmake" --build "$work/project/build" > "$work/log" 2>&1 || {
    cat "$work/log"
    exit 1
}
"$work/project/build/consumer"
for type in $(sed -nE 's/^(class|struct) ([A-Za-z]+) .*\{.*/\2/p' "$work"/usr/include/rotconv/*.hpp); do
    grep -qw "$type" "$source/tests/package/consumer.cpp" || fail "consumer.cpp does not use $type"
done

# The same by pkg-config, from a tree that was moved. Catches a path of the build, and a library or folder that is not named.
compiler=$(sed -n 's/^CMAKE_CXX_COMPILER:[A-Z]*=//p' "$build/CMakeCache.txt")
if command -v pkg-config > /dev/null && pkg-config --exists eigen3; then
    cp -r "$work/usr" "$work/moved"
    PKG_CONFIG_PATH=$work/moved/share/pkgconfig
    export PKG_CONFIG_PATH
    [ "rotconv $(pkg-config --modversion rotconv)" = "$version" ] ||
        fail "rotconv.pc is not of the version of the program, $version"
    # shellcheck disable=SC2046,SC2086 # lists of options
    "$compiler" -std=c++20 ${CXXFLAGS:-} -c "$work/project/attitude.cpp" -o "$work/attitude.o" $(pkg-config --cflags rotconv)
    # The warnings of clang 14 in Eigen are no errors of a user's.
    # shellcheck disable=SC2046 # likewise
    ! command -v clang++ > /dev/null ||
        clang++ -std=c++20 -Wall -Wextra -Wconversion -Wshadow -Werror -fsyntax-only $(pkg-config --cflags rotconv) \
            "$work/project/attitude.cpp"
    # shellcheck disable=SC2046,SC2086 # likewise
    "$compiler" ${CXXFLAGS:-} "$work/attitude.o" -o "$work/attitude" $(pkg-config --libs rotconv)
    # shellcheck disable=SC2046,SC2086 # likewise
    "$compiler" ${CXXFLAGS:-} -static "$work/attitude.o" -o "$work/attitude_static" $(pkg-config --static --libs rotconv)
    for program in attitude attitude_static; do
        [ "$("$work/$program")" = "$("$work/project/build/attitude")" ] ||
            fail "$program, built by pkg-config, says something else"
    done
    ! ldd "$work/attitude_static" > /dev/null 2>&1 || ldd "$work/attitude_static" | grep -q 'statically' ||
        fail "by pkg-config --static the program is not static"
    unset PKG_CONFIG_PATH
else
    echo "pkg-config is not installed, and is left out"
fi

# Each header asks for C++20 before anything else fails. Empty headers stand for Eigen's.
mkdir -p "$work/empty/Eigen"
: > "$work/empty/Eigen/Core"
: > "$work/empty/Eigen/Geometry"
for header in "$work"/usr/include/rotconv/*.hpp; do
    "$compiler" -std=c++17 -fsyntax-only -x c++ -I "$work/usr/include" -I "$work/empty" "$header" 2>&1 | grep error |
        head -n 1 | grep -q 'rotconv needs C++20' || fail "$header does not ask for C++20"
done

cat > "$work/expected" <<'END'
 0.000000 -0.173648  0.984808
 0.000000  0.984808  0.173648
-1.000000  0.000000  0.000000
roll -10 pitch 90 yaw 0
at gimbal lock: only the difference of roll and yaw is defined
END
"$work/project/build/attitude" | sed 's/-0\.000000/ 0.000000/g' | diff "$work/expected" -

# A third of a turn about (1, 1, 1), ninety degrees about z, a reflection, and a matrix that is scaled by 1.01.
cat > "$work/expected" <<'END'
0.5 0.5 0.5 0.5
90 90 0
 0.000000  0.000000 -1.000000
no rotation
no rotation, 0.01 off
END
"$work/project/build/conversions" | sed 's/-0\.000000/ 0.000000/g' | diff "$work/expected" -
# Half a radian and a radian about z, and a matrix with an entry of 7, whose largest singular value is 1 + defect.
cat > "$work/expected" <<'END'
  0   0   0
  0   0 0.5
nan nan nan
row 2: the defect is above the tolerance
END
"$work/project/build/batch" | sed 's/, [0-9.]*$//' | diff "$work/expected" -
[ "$("$work/project/build/chosen" quat:xyzw rpy:deg 0 0 0.6 0.8)" = "rpy:deg: 0 0 73.7398" ]
! "$work/project/build/chosen" quat:deg rpy 1 0 0 0 2> "$work/errors"
[ "$(cat "$work/errors")" = "'deg' has no meaning for quat" ]
"$work/project/build/gyroscope" | grep -q 'yaw 36 degrees' # a tenth of a turn
"$work/project/build/check" | grep -q 'below 1e-14 rad: yes'

# What the README shows stands in a program that was built.
sed -n '/^```cpp/,/^```/p' "$source/README.md" | grep -v '^```' | while read -r line; do
    cat "$source"/examples/cpp/*.cpp | grep -qF "$line" ||
        fail "README.md has a line of C++ that no example has: $line"
done

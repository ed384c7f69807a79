#!/bin/sh
# packages_test.sh CPACK BUILD [EMULATOR]: the Debian packages and the tarball hold what they should, and their program runs.
# Catches a file that no package or the wrong one has, a missing dependency, and a program that needs what is not there.
set -eu
cpack=$1
build=$2
emulator=${3-}
version=$($emulator "$build/rotconv" --version | cut -d ' ' -f 2)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() {
    echo "FAILED: $*"
    exit 1
}

# By the generator's name cpack thinks that there is nothing to build first; it would build all tests.
"$cpack" --config "$build/CPackConfig.cmake" -D CPACK_CMAKE_GENERATOR=Ninja -B "$work" > "$work/log" 2>&1 || {
    cat "$work/log"
    fail "cpack"
}

# holds FOLDER FILE...
holds() {
    folder=$1
    shift
    for file; do
        [ -s "$folder/$file" ] || fail "$folder has no $file"
    done
}
runs() { # PROGRAM
    [ "$($emulator "$1" -f euler:ZYX:deg -t quat 90 0 180)" = "0 0.7071067811865476 0.7071067811865476 0" ] || fail "$1 does not convert"
}
program="bin/rotconv share/man/man1/rotconv.1 share/bash-completion/completions/rotconv share/doc/rotconv/LICENSE
    share/doc/rotconv/NOTICES share/doc/rotconv/LGPL-2.1 share/doc/rotconv/CITATION.cff"
library="include/rotconv/rotconv.hpp lib/librotconv_core.a lib/cmake/rotconv/rotconvConfig.cmake
    share/doc/librotconv-dev/LICENSE"

tar -xzf "$work"/rotconv-"$version"-*.tar.gz -C "$work"
mv "$work"/rotconv-"$version"-*/ "$work/tarball"
# shellcheck disable=SC2086 # a list
holds "$work/tarball" $program $library share/zsh/site-functions/_rotconv
runs "$work/tarball/bin/rotconv"

command -v dpkg-deb > /dev/null || exit 0
for package in rotconv librotconv-dev; do
    file=$(echo "$work/${package}_$version"_*.deb)
    [ -f "$file" ] || fail "there is no ${file##*/}"
    dpkg-deb -x "$file" "$work/$package"
    [ "$(dpkg-deb -f "$file" Package Version)" = "Package: $package
Version: $version" ] || fail "$file is not of that name and version"
done
# shellcheck disable=SC2086 # a list
holds "$work/rotconv/usr" $program share/zsh/vendor-completions/_rotconv
# shellcheck disable=SC2086 # a list
holds "$work/librotconv-dev/usr" $library
runs "$work/rotconv/usr/bin/rotconv"
dpkg-deb -f "$work"/librotconv-dev_*.deb Depends | grep -q libeigen3-dev || fail "librotconv-dev needs no Eigen"
# dpkg would not install two packages with one file.
(cd "$work/rotconv" && find . -type f) | sort > "$work/ours"
(cd "$work/librotconv-dev" && find . -type f) | sort | comm -12 "$work/ours" - > "$work/both"
[ ! -s "$work/both" ] || fail "both packages have $(cat "$work/both")"
[ ! -e "$work/rotconv/usr/include" ] || fail "the program's package has headers"

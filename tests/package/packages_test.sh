#!/bin/sh
# packages_test.sh BUILD [EMULATOR]: the Debian packages and the tarball, or the zip for Windows, hold what they should, their
# program runs, and dpkg installs and removes them. Catches a file that no package or the wrong one has, a missing dependency, a
# program of the tarball that needs any file of the system, and one of the package that brings a C library of its own.
set -eu
build=$1
emulator=${2-}
case $emulator in
qemu-*) export QEMU_LD_PREFIX="/usr/${emulator#qemu-}-linux-gnu" ;; # the libraries of the cross compiler
esac
program=$build/rotconv
[ ! -f "$program.exe" ] || program=$program.exe
version=$($emulator "$program" --version | cut -d ' ' -f 2)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() {
    echo "FAILED: $*"
    exit 1
}

SOURCE_DATE_EPOCH=1000000000 "$(dirname "$0")/../../src/package/archives" "$build" "$work" > "$work/log" 2>&1 || {
    cat "$work/log"
    fail "src/package/archives"
}

# Catches a package without the licence of what is linked statically.
if grep -q '^ROTCONV_STATIC:BOOL=ON' "$build/CMakeCache.txt" && [ -z "$emulator" ]; then
    cmake -S "$(dirname "$0")/../.." -B "$work/unlicensed" -DROTCONV_LGPL="$work/none" > /dev/null
    ! cpack --config "$work/unlicensed/CPackConfig.cmake" -B "$work/unlicensed" > "$work/log" 2>&1 || fail "packages without the LGPL"
    grep -q "no $work/none" "$work/log" || fail "a licence that is missing is not named: $(cat "$work/log")"
fi

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
both="bin/rotconv share/bash-completion/completions/rotconv share/fish/vendor_completions.d/rotconv.fish
    share/doc/rotconv/CITATION.cff"
library="include/rotconv/rotconv.hpp lib/librotconv_core.a lib/cmake/rotconv/rotconvConfig.cmake share/pkgconfig/rotconv.pc"
pages=$(cd "$(dirname "$0")/../../man" && for page in *.[1-9]; do echo "share/man/man${page##*.}/$page"; done)

if [ "$program" != "$build/rotconv" ]; then
    cmake -E chdir "$work" cmake -E tar xf rotconv-"$version"-Windows-x86_64.zip
    # shellcheck disable=SC2086 # a list
    holds "$work/rotconv-$version-Windows-x86_64" share/doc/rotconv/LICENSE share/doc/rotconv/NOTICES $library
    runs "$work/rotconv-$version-Windows-x86_64/bin/rotconv.exe"
    exit 0
fi
tar -xzf "$work"/rotconv-"$version"-*.tar.gz -C "$work"
mv "$work"/rotconv-"$version"-*/ "$work/tarball"
# shellcheck disable=SC2086 # a list
holds "$work/tarball" $both $library $pages share/zsh/site-functions/_rotconv share/doc/rotconv/LICENSE share/doc/rotconv/NOTICES \
    share/doc/rotconv/LGPL-2.1 share/doc/librotconv-dev/LICENSE
runs "$work/tarball/bin/rotconv"
# An empty root has neither libraries nor /proc, /dev, /etc.
if [ -z "$emulator" ] && grep -q '^ROTCONV_STATIC:BOOL=ON' "$build/CMakeCache.txt"; then
    enter=chroot
    [ "$(id -u)" -eq 0 ] || enter="unshare --map-root-user chroot"
    if $enter / true 2> /dev/null; then
        answer=$(printf '90 0 180\n' | $enter "$work/tarball" /bin/rotconv -f euler:ZYX:deg -t quat) || fail "the program needs files"
        [ "$answer" = "0 0.7071067811865476 0.7071067811865476 0" ] || fail "on an empty root the answer is $answer"
    else
        echo "neither root nor user namespaces: the empty root is left out"
    fi
fi

grep -q '^set(CPACK_GENERATOR ".*DEB' "$build/CPackConfig.cmake" && command -v dpkg-deb > /dev/null || exit 0
for package in rotconv librotconv-dev; do
    file=$(echo "$work/${package}_$version"_*.deb)
    [ -f "$file" ] || fail "there is no ${file##*/}"
    dpkg-deb -x "$file" "$work/$package"
    [ "$(dpkg-deb -f "$file" Package Version)" = "Package: $package
Version: $version" ] || fail "$file is not of that name and version"
    for field in Homepage Maintainer Section; do
        [ -n "$(dpkg-deb -f "$file" $field)" ] || fail "$file has no $field"
    done
    holds "$work/$package/usr/share/doc/$package" copyright changelog.gz CHANGELOG.md.gz
done
# shellcheck disable=SC2086 # a list
holds "$work/rotconv/usr" $both $(printf '%s.gz\n' $pages) share/zsh/vendor-completions/_rotconv
# shellcheck disable=SC2086 # a list
holds "$work/librotconv-dev/usr" $library
for part in Eigen fmt Dragonbox FastFloat CLI11; do
    grep -qw "$part" "$work/rotconv/usr/share/doc/rotconv/copyright" || fail "the copyright has no $part"
done
dpkg-deb -f "$work"/librotconv-dev_*.deb Depends | grep -q libeigen3-dev || fail "librotconv-dev needs no Eigen"
depends=$(dpkg-deb -f "$work"/rotconv_*.deb Depends)
for needed in libc6 libstdc++6; do
    echo "$depends" | grep -qF "$needed" || fail "the package needs no $needed, but $depends"
done
# dpkg would not install two packages with one file.
(cd "$work/rotconv" && find . -type f) | sort > "$work/ours"
(cd "$work/librotconv-dev" && find . -type f) | sort | comm -12 "$work/ours" - > "$work/shared"
[ ! -s "$work/shared" ] || fail "both packages have $(cat "$work/shared")"
[ ! -e "$work/rotconv/usr/include" ] || fail "the program's package has headers"
runs "$work/rotconv/usr/bin/rotconv"

# Into a root of their own, where dpkg knows of no other package.
root=$work/root
mkdir -p "$root/var/lib/dpkg/info" "$root/var/lib/dpkg/updates"
: > "$root/var/lib/dpkg/status"
in_root() {
    PATH=$PATH:/usr/sbin:/sbin dpkg --root="$root" --log=/dev/null --force-not-root "$@" > "$work/log" 2>&1
}
architecture=$(dpkg-deb -f "$work"/rotconv_*.deb Architecture)
[ "$architecture" = "$(dpkg --print-architecture)" ] || in_root --add-architecture "$architecture" || fail "$(cat "$work/log")"
! in_root -i "$work"/rotconv_*.deb || fail "dpkg does not miss the C library"
grep -q 'depends on libc6' "$work/log" || fail "dpkg does not say that libc6 is missing: $(cat "$work/log")"
in_root --force-depends -i "$work"/*.deb || fail "dpkg -i: $(cat "$work/log")"
runs "$root/usr/bin/rotconv"
in_root --purge librotconv-dev rotconv || fail "dpkg --purge: $(cat "$work/log")"
left=$(find "$root" -path "$root/var" -prune -o -type f -print)
[ -z "$left" ] || fail "dpkg leaves $left"

#!/bin/sh
# release_test.sh SOURCE BUILD: what src/package/archives makes of BUILD has the same bytes when it is made again, in another time
# zone and with another mask; its tarball has those of build/release, which quickstart built of the same sources in another folder
# and by other targets; lintian passes the packages. Catches times, owners, orders and paths that get into the files, what
# Debian's archive would refuse, and a release that is begun and cannot be made.
set -eu
source=$1
build=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() {
    echo "FAILED: $*"
    exit 1
}
SOURCE_DATE_EPOCH=1000000000
export SOURCE_DATE_EPOCH
made() { # BUILD NAME
    mkdir "$work/$2"
    "$source/src/package/archives" "$1" "$work/$2" > "$work/log" 2>&1 || fail "$(cat "$work/log")"
}
made "$build" once
(umask 077 && TZ=Asia/Tokyo && export TZ && made "$build" again)
for file in "$work"/once/*; do
    cmp "$file" "$work/again/${file##*/}" || fail "made twice, ${file##*/} has other bytes"
done
tarball=$(echo "$work"/once/*.tar.gz)
tar -tzf "$tarball" > "$work/names"
LC_ALL=C sort -c "$work/names" || fail "the order of the tarball is that of the file system"
# The compiler and its options.
compiler() {
    sed -nE 's/^CMAKE_CXX_(COMPILER|FLAGS|FLAGS_RELEASE):[A-Z]*=/\1 /p' "$1/CMakeCache.txt"
}
if [ -x "$source/build/release/rotconv" ] && [ "$(compiler "$build")" = "$(compiler "$source/build/release")" ]; then
    made "$source/build/release" elsewhere
    cmp "$tarball" "$work/elsewhere/${tarball##*/}" ||
        fail "built twice, ${tarball##*/} has other bytes, unless build/release is of other sources"
else
    echo "there is no build/release by the same compiler, and it is left out"
fi
# A preset that cannot be configured is found before another is built, and no folder looks like a release.
! timeout 300 "$source/src/package/release" "$work/none" release missing > "$work/log" 2>&1 || fail "a release without a preset"
grep -q 'No such preset.*missing' "$work/log" || fail "the preset that is missing is not named: $(cat "$work/log")"
! grep -q 'Building CXX' "$work/log" && [ ! -e "$work/none" ] || fail "a release is begun that cannot be made"
command -v lintian > /dev/null || {
    echo "lintian is not installed, and is left out"
    exit 0
}
lintian --allow-root --fail-on error,warning "$work"/once/*.deb || fail "lintian"

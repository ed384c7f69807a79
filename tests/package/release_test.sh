#!/bin/sh
# release_test.sh SOURCE CMAKE CPACK FOLDER: src/package/release makes its files in FOLDER; lintian passes the Debian
# packages; and build/release, which is built from the same sources in another folder, makes the same bytes. Catches what Debian's
# archive would refuse, a file that a clean clone lacks, and times, paths and orders that get into the packages.
set -eu
source=$1
cmake=$2
cpack=$3
folder=$4
cd "$source"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() {
    echo "FAILED: $*"
    exit 1
}
git diff --quiet HEAD 2> /dev/null || {
    echo "SKIPPED: a release is made of a commit, and not all is committed"
    exit 77
}
set -- release
if command -v aarch64-linux-gnu-g++ > /dev/null && command -v qemu-aarch64 > /dev/null; then
    set -- release aarch64
fi

rm -rf "$folder"
src/package/release "$folder" "$@" > "$work/log" 2>&1 || {
    tail -n 50 "$work/log"
    fail "src/package/release"
}
(cd "$folder" && sha256sum --quiet -c SHA256SUMS) || fail "SHA256SUMS"
listed=$(wc -l < "$folder/SHA256SUMS")
[ "$listed" -eq $(($# + 3)) ] || fail "there are $listed files: $(ls "$folder")"

# The same once more.
SOURCE_DATE_EPOCH=$(git log -1 --format=%ct)
export SOURCE_DATE_EPOCH
"$cmake" --preset release > "$work/log" && "$cmake" --build --preset release --parallel 2 >> "$work/log" 2>&1 || {
    tail -n 50 "$work/log"
    fail "build/release"
}
(cd build/release && "$cpack" -B "$work/again") > "$work/log" 2>&1 || fail "$(cat "$work/log")"
for file in "$work"/again/*.deb "$work"/again/*.tar.gz; do
    cmp "$file" "$folder/${file##*/}" || fail "made twice, ${file##*/} has other bytes"
done

if command -v lintian > /dev/null; then
    lintian --allow-root --fail-on error,warning "$folder"/*.deb || fail "lintian"
else
    echo "lintian is not installed, and is left out"
fi

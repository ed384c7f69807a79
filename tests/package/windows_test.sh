#!/bin/bash
# windows_test.sh PROGRAM COMMAND...: the program for Windows, which COMMAND runs, such as "wine64 build/windows/rotconv.exe", answers
# the commands of the pages, but those with <(...), and prints the bytes of PROGRAM, the same on this machine. Catches text mode,
# in which CR LF and the byte 26 are not themselves, names that are not in UTF-8, and answers that wait for the end of the input.
set -eu
cd "$(dirname "$0")/../.."
program=$(realpath "$1")
shift
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/bin"
printf '#!/bin/sh\nexec %s "$@"\n' "$*" > "$work/bin/rotconv"
chmod +x "$work/bin/rotconv"
failed=0
fail() {
    echo "FAILED: $*"
    failed=1
}

for page in README.md examples/*.md man/*.[1-9]; do
    PATH=$work/bin:$PATH tests/package/run_commands.sh "$page" examples/data '<(' || fail "the commands of $page"
done

cd "$work"
# same WHAT WORD...: both programs, with these arguments, make the same of the file `input`.
same() {
    what=$1
    shift
    "$program" "$@" < input > expected 2> expected_errors || echo "exit $?" >> expected
    bin/rotconv "$@" < input > printed 2> errors || echo "exit $?" >> printed
    cmp expected printed && cmp expected_errors errors || fail "$what"
}
printf 't,qw,qx,qy,qz,what\r\n1,0,0,0.6,0.8,a\032b\r\n2,0,0,0,1,\032\r\n' > input
same "CR LF and the byte 26" -f quat -t rpy:deg --columns 2-5
same "the same to JSON" -f quat -t rpy:deg --columns 2-5 --format json
printf 'w°,x,y,größe\n1,0,0,0\n' > input
same "names in UTF-8" -f quat -t rpy --columns 'w°,x,y,größe' --append
same "an argument that is not a name" -f quat -t rpy --columns '*'
same "VALUEs with a sign in UTF-8" -f rpy:deg -t quat 1° 0 −2
"$program" sample -t quat --rows 100000 --format f64 > input
same "doubles" -f quat -t rotvec --input-format f64 --format f64
cp input 'größe 日本.bin'
same "a file with a name in UTF-8" -f quat -t rpy --input-format f64 'größe 日本.bin'
bin/rotconv -f quat -t dcm --input-format f64 --diagnostics off -o 'größe 本.csv' 'größe 日本.bin'
"$program" -f quat -t dcm --input-format f64 --diagnostics off input | cmp - 'größe 本.csv' || fail "-o"
! bin/rotconv -f quat -t dcm --input-format f64 -o input input 2> errors || fail "a file that is input and output"
grep -q 'the same file is input and output' errors && cmp input 'größe 日本.bin' || fail "what becomes of that file"
same "a folder" -f quat -t rpy .
same "a file that is not there" -f quat -t rpy none.csv

# A row is answered while the input goes on.
exec 3> >(bin/rotconv -f quat -t rpy:deg > first 2> errors)
printf '0.8 0 0 0.6\n' >&3
for _ in $(seq 100); do
    [ -s first ] || sleep 0.2
done
printf '0 0 73.73979529168804\n' | cmp - first || fail "a row waits for more: $(cat first errors)"
exec 3>&-
wait $! || true
{ bin/rotconv sample -t quat --rows 1000000 2> errors || echo "$?" > status; } | head -n 1 > /dev/null
[ ! -s status ] && [ ! -s errors ] || fail "the reader of a pipe leaves: $(cat status errors)"
exit "$failed"

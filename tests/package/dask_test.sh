#!/bin/sh
# dask_test.sh FOLDER: the example for Dask has the bytes and the messages of a single run, also if a worker is killed while it
# converts a piece, which another one then does again; and how much memory its workers take. 77, which is skipped, where Dask's
# distributed engine is not installed.
set -eu
cd "$1"
python=/usr/bin/python3 # of Debian, as are dask-scheduler and dask-worker
{ command -v dask-worker > /dev/null && "$python" -c 'import distributed' 2> /dev/null; } || {
    echo "Dask's distributed engine is not installed"
    exit 77
}
work=$(mktemp -d)
processes=
# shellcheck disable=SC2086 # the numbers are words
trap '[ -z "$processes" ] || kill $processes 2> /dev/null || true; wait; rm -rf "$work"' EXIT
export DASK_CONFIG="$work" TMPDIR="$work" # no settings of the user's

failed=0
check() { # what, expected, found
    [ "$2" = "$3" ] || {
        echo "FAILED: $1 is $3, not $2"
        failed=1
    }
}

# The workers' rotconv keeps a note of each piece, with the number of its worker. While there is a folder "kill", the first call
# after the fifth removes it and kills its worker.
mkdir "$work/bin" "$work/notes"
cat > "$work/bin/rotconv" << END
#!/bin/sh
cat > "$work/piece.\$\$"
echo "\$PPID \$(cksum < "$work/piece.\$\$")" > "$work/notes/\$\$"
if [ "\$(ls "$work/notes" | wc -l)" -gt 5 ] && rmdir "$work/kill" 2> /dev/null; then
    mv "$work/notes/\$\$" "$work/killed"
    kill -KILL "\$PPID"
    exit
fi
exec "$(command -v rotconv)" "\$@" < "$work/piece.\$\$"
END
chmod +x "$work/bin/rotconv"

await() { # seconds, command
    for _ in $(seq "$1"); do
        ! eval "$2" || return 0
        sleep 1
    done
    echo "FAILED: waited $1 s for: $2"
    cat "$work"/*.log
    exit 1
}
dask-scheduler --host 127.0.0.1 --port 0 --no-dashboard --scheduler-file "$work/scheduler" 2> "$work/scheduler.log" &
processes=$!
await 60 "[ -s $work/scheduler ]"
address=$(sed -n 's/^ *"address": "\(tcp:[^"]*\)".*/\1/p' "$work/scheduler" | tail -n 1)
for name in one two; do
    PATH="$work/bin:$PATH" dask-worker "$address" --nthreads 1 --no-dashboard --death-timeout 30 2> "$work/$name.log" &
    processes="$processes $!"
done
for name in one two; do
    await 60 "grep -qs 'Registered to' $work/$name.log"
done

# run TABLE OPTION...: a single run selects by name, so that a header which is lost, repeated or unconverted shows.
run() {
    in=$1
    shift
    single=0
    rotconv -f quat -t rpy:deg --columns q_RS_w,q_RS_x,q_RS_y,q_RS_z --on-error nan --diagnostics off \
        "$in" > "$work/single" 2> /dev/null || single=$?
    rm -f "$work"/notes/*
    status=0
    "$python" ./euroc-with-dask.py "$@" "$in" > "$work/pieces" 2> "$work/messages" || status=$?
    check "the exit status" "$single" "$status"
    cmp "$work/single" "$work/pieces" || failed=1
    cat "$work"/notes/* > "$work/calls" 2> /dev/null || true
}

# rows TIMES: the table many times, with another time in each row, so that no piece is like another.
rows() {
    awk -v times="$1" 'NR == 1 { print; next } { row[NR] = $0 }
        END { for (i = 1; i <= times; ++i) for (j = 2; j <= NR; ++j) print i row[j] }' data/euroc.csv
}
rows 13 > "$work/table"
pieces=$((($(wc -c < "$work/table") + 1999) / 2000))

run "$work/table" --piece 2000 --scheduler "$address"
check "what is on stderr" "" "$(cat "$work/messages")"
check "the number of pieces" "$pieces" "$(wc -l < "$work/calls")"
check "the number of workers at work" 2 "$(cut -d ' ' -f 1 "$work/calls" | sort -u | wc -l)"

# The lines of bad rows are those of the whole file. Words in the place of all four numbers: a piece that guessed would take its
# first row as a header.
awk -F, -v OFS=, 'NR > 1 && NR % 3 { $5 = $6 = $7 = $8 = "lost" } { print }' "$work/table" > "$work/bad"
run "$work/bad" --piece 2000 --scheduler "$address"
grep -n nan "$work/single" | sed "s|:.*||; s|.*|rotconv: $work/bad:&: not a number: 'lost'|" > "$work/expected"
check "the number of bad rows" 104 "$(wc -l < "$work/expected")"
diff "$work/expected" "$work/messages" || failed=1

# A worker dies with a piece in hand.
mkdir "$work/kill"
run "$work/table" --piece 2000 --scheduler "$address"
[ -e "$work/killed" ] || check "a worker" "killed" "alive"
! kill -0 "$(cut -d ' ' -f 1 "$work/killed")" 2> /dev/null || check "the worker" "dead" "alive"
check "how often the dead worker's piece was done by another" 1 \
    "$(awk 'NR == FNR { worker = $1; piece = $2; next } $2 == piece && $1 != worker' "$work/killed" "$work/calls" | wc -l)"

# Memory on a larger table, in five pieces of the usual size.
rows 20000 > "$work/large"
run "$work/large" --scheduler "$address"
cut -d ' ' -f 1 "$work/calls" | sort | uniq -c > "$work/workers"
while read -r count worker; do
    peak=$(awk '/^VmHWM/ { print int($2 / 1024) }' "/proc/$worker/status")
    echo "worker $worker: $count pieces, at most $peak MB"
    [ "$peak" -le 150 ] || check "the memory of a worker in MB" "at most 150" "$peak"
done < "$work/workers"

# With a worker of its own.
run "$work/table" --piece 2000 --workers 1
check "what is on stderr" "" "$(cat "$work/messages")"
exit "$failed"

#!/bin/bash
# race_test.sh PROGRAM: runs the commands of all transcripts by a program with the thread sanitizer, each with four threads where it
# has that option. Fails where a race is found; what the commands print is not looked at.
set -eu
program=$(realpath "$1")
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/bin"
cat > "$work/bin/rotconv" << END
#!/bin/sh
case " \$* " in
*" --threads"*) ;;
" rates "* | " propagate "* | " compare "* | " compose "* | " rotate "* | " sample "*) command=\$1; shift; set -- "\$command" --threads 4 "\$@" ;;
" list "* | " survey "* | " identify "*) ;;
*) set -- --threads 4 "\$@" ;;
esac
echo >> "$work/runs"
exec "$program" "\$@"
END
chmod +x "$work/bin/rotconv"
export PATH=$work/bin:$PATH TSAN_OPTIONS=log_path=$work/race
printf '%s\0' "$here"/transcripts/*.txt | xargs -0 -n 1 -P 2 "$here/../package/run_commands.sh" > "$work/printed" || true
runs=$(wc -l < "$work/runs")
echo "$runs runs"
cat "$work"/race.* 2> /dev/null && exit 1
[ "$runs" -ge "$(cat "$here"/transcripts/*.txt | grep -c '^\$ .*rotconv')" ]

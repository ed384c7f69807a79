#!/bin/bash
# run_commands.sh FILE [FOLDER [EXCEPT]]: runs each "$ command" of FILE in FOLDER and compares what it prints with the lines below it. A
# command goes on after a \. FILE is a Markdown page with console blocks or a manual page with literal displays, where stdout and
# stderr stand as they come; or a transcript, NAME.txt, whose text is in paragraphs beside those that begin with a command. There
# a line of stderr follows those of stdout, marked "! ", "exit N" tells a status other than 0, an empty line is written as a dot,
# ... stands for any text of a line, and a line of ... alone for any lines. Without FOLDER it runs in an empty one. Each command
# that is printed after "try: " is run too, and must not stop.
# A command with the text EXCEPT is left out.
set -eu
file=$(realpath "$1")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/empty"
cd "${2:-$work/empty}"
except=${3:-}

# Markdown: ```console ... ```; mdoc: .Bd -literal ... .Ed that begins with a command, where \e is a backslash.
case $file in
*.md) sed -n '/^```console$/,/^```$/{/^```/!p;}' "$file" ;;
*.txt) awk '/^\$ / { shown = 1 } /^$/ { shown = 0 } shown' "$file" ;;
*) awk '/^\.Ed/ { shown = 0 } begins && /^\$ / { shown = 1 } shown; { begins = /^\.Bd -literal/ }' "$file" | sed 's/\\e/\\/g' ;;
esac > "$work/blocks"

# answer COMMAND: what it prints, as FILE writes it.
answer() {
    case $file in
    *.txt)
        status=0
        bash -c "$1" > "$work/out" 2> "$work/errors" < /dev/null || status=$?
        sed 's/^$/./' "$work/out"
        sed 's/^/! /' "$work/errors"
        [ "$status" -eq 0 ] || echo "exit $status"
        ;;
    *) bash -c "$1" 2>&1 < /dev/null || true ;;
    esac
}

# serve COMMAND: do the commands that it was answered with, after "try: ", run? One for a pipe stands in the place of its end.
serve() {
    case $1 in
    *';'* | *'$('*) return 0 ;;
    *' | rotconv'*) before="${1%| rotconv*}| " ;;
    *) before= ;;
    esac
    sed -n 's/^! try: //p' "$work/printed" > "$work/tries"
    while IFS= read -r tried <&3; do
        command -v "${tried%% *}" > /dev/null || continue
        served=0
        timeout 3 bash -c "$before$tried" > "$work/out" 2> "$work/errors" < /dev/null || served=$?
        { [ "$served" -lt 2 ] && [ -s "$work/out" ]; } || [ "$served" -eq 124 ] || sed 's/^/# /' "$work/errors" >> "$work/printed"
    done 3< "$work/tries"
}

# same EXPECTED PRINTED: are the lines those that are expected?
same() {
    cmp -s "$1" "$2" || awk '
        function is_like(text, pattern,   parts, n, i, at) {
            n = split(pattern, parts, /\.\.\./)
            if (index(text, parts[1]) != 1 || n == 1 && text != pattern) return 0
            for (i = 1; i <= n; ++i) {
                at = i == n && parts[n] != "" ? length(text) - length(parts[n]) + 1 : index(text, parts[i])
                if (at < 1 || substr(text, at, length(parts[i])) != parts[i]) return 0
                text = substr(text, at + length(parts[i]))
            }
            return 1
        }
        NR == FNR { expected[++lines] = $0; next }
        { while (expected[at + 1] == "...") { ++at; any = 1 } }
        at < lines && is_like($0, expected[at + 1]) { ++at; any = 0; next }
        !any { other = 1; exit }
        END { while (expected[at + 1] == "...") ++at; exit other || at < lines }' "$1" "$2"
}

run=0
failed=0
check() {
    [ -n "$command" ] || return 0
    run=$((run + 1))
    [ -z "$except" ] || [ -n "${command##*"$except"*}" ] || return 0
    answer "$command" > "$work/printed"
    serve "$command"
    if ! same "$work/expected" "$work/printed"; then
        failed=$((failed + 1))
        printf 'FAILED: %s\n' "$command"
        diff -u "$work/expected" "$work/printed" || true
    fi
}
command=
while IFS= read -r line; do
    case $line in
    '$ '*)
        check
        command=${line#??}
        : > "$work/expected"
        ;;
    *)
        case $command in
        *\\) command=$(printf '%s\n%s' "$command" "$line") ;;
        *) printf '%s\n' "$line" >> "$work/expected" ;;
        esac
        ;;
    esac
done < "$work/blocks"
check
echo "$run commands, $failed failed"
# None stands anywhere else.
[ "$run" -eq "$(grep -c '^\$ ' "$file")" ] && [ "$failed" -eq 0 ]

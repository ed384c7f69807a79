#!/bin/sh
# run_commands.sh FILE FOLDER: runs each "$ command" of the console blocks of a Markdown file, or of the literal displays of a
# manual page, in FOLDER, and compares what it prints (stdout and stderr) with the lines below it. A command goes on after a \.
set -eu
file=$1
cd "$2"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Markdown: ```console ... ```; mdoc: .Bd -literal ... .Ed that begins with a command, where \e is a backslash.
case $file in
*.md) sed -n '/^```console$/,/^```$/{/^```/!p;}' "$file" ;;
*) awk '/^\.Ed/ { shown = 0 } begins && /^\$ / { shown = 1 } shown; { begins = /^\.Bd -literal/ }' "$file" | sed 's/\\e/\\/g' ;;
esac > "$work/blocks"

run=0
failed=0
check() {
    [ -n "$command" ] || return 0
    run=$((run + 1))
    sh -c "$command" > "$work/printed" 2>&1 || true
    if ! diff -u "$work/expected" "$work/printed" > "$work/difference"; then
        failed=$((failed + 1))
        printf 'FAILED: %s\n' "$command"
        cat "$work/difference"
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

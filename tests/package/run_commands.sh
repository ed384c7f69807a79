#!/bin/sh
# run_commands.sh FILE FOLDER: runs each "$ command" of the console blocks of a Markdown file, or of the literal displays of a
# manual page, in FOLDER, and compares what it prints (stdout and stderr) with the lines below it.
set -eu
file=$1
cd "$2"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Markdown: ```console ... ```; mdoc: .Bd -literal ... .Ed, where \e is a backslash.
case $file in
*.md) sed -n '/^```console$/,/^```$/{/^```/!p;}' "$file" ;;
*) sed -n '/^\.Bd -literal/,/^\.Ed/{/^\./!{s/\\e/\\/g;p;};}' "$file" ;;
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
    *) printf '%s\n' "$line" >> "$work/expected" ;;
    esac
done < "$work/blocks"
check
echo "$run commands, $failed failed"
# None stands anywhere else.
[ "$run" -eq "$(grep -c '^\$ ' "$file")" ] && [ "$failed" -eq 0 ]

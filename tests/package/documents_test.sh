#!/bin/sh
# documents_test.sh SOURCE: what the Markdown pages name is there: the files that they link to, and paths, presets, options of
# CMake, targets, tasks of examples/setup. README.md has at most 140 lines.
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$1"

# Prints what the page $1 names and is not there.
missing() {
    grep -oE '\]\([^)#]+' "$1" | sed 's/^..//' | grep -v '^https:' | while read -r link; do
        [ -e "$(dirname "$1")/$link" ] || echo "$1: link to $link"
    done
    # Paths and commands stand in backticks or in blocks for the shell.
    { sed '/^```/,/^```/d' "$1" | grep -oE '`[^`]+`'; sed -n '/^```sh$/,/^```$/p' "$1"; } | tr -d '`' | sed 's/ *#.*//' > "$work/named"
    grep -oE '(^|[ (])(src|include|tests|examples|man|\.ci)/[A-Za-z0-9_./-]+' "$work/named" | tr -d ' (' | while read -r path; do
        [ -e "$path" ] || echo "$1: path $path"
    done
    grep -oE 'build/[a-z]+/tests/[a-z_/]+' "$work/named" | while read -r program; do
        [ -e "${program#build/*/}.cpp" ] || echo "$1: program $program"
    done
    grep -oE -- '--preset [a-z-]+' "$work/named" | sed 's/.* //' | while read -r preset; do
        grep -q "\"name\": \"$preset\"" CMakePresets.json || echo "$1: preset $preset"
    done
    grep -oE 'ROTCONV_[A-Z]+' "$work/named" | while read -r option; do
        grep -qE "^(option|set)\($option " CMakeLists.txt src/package/CMakeLists.txt || echo "$1: option $option"
    done
    grep -oE -- '--target( [a-z][a-z_-]*)+' "$work/named" | tr ' ' '\n' | grep -v -e '--target' | while read -r target; do
        grep -qrwF --include=CMakeLists.txt -- "$target" CMakeLists.txt tests || echo "$1: target $target"
    done
    grep -oE 'examples/setup [a-z]+' "$work/named" | while read -r setup task; do
        grep -q "^$task) wanted=" "$setup" || echo "$1: task $task"
    done
}

fail() {
    echo "FAILED: $*"
    exit 1
}

# On a made-up page all of these are seen.
cat > "$work/page.md" <<'END'
[a page](elsewhere.md), [here](page.md), `src/nowhere.cpp`, `tests/run`, `-DROTCONV_NOTHING=ON`
```sh
examples/setup nothing   # a remark on examples/nothing
cmake --preset nothing && cmake --build --preset dev --target rotconv no-such-target && build/dev/tests/core/nothing 1
```
END
missing "$work/page.md" > "$work/seen"
sed "s|^|$work/page.md: |" > "$work/expected" <<'END'
link to elsewhere.md
path src/nowhere.cpp
program build/dev/tests/core/nothing
preset nothing
option ROTCONV_NOTHING
target no-such-target
task nothing
END
diff "$work/expected" "$work/seen" || fail "what is missing is not seen as it should be"

for page in README.md CHANGELOG.md src/*.md examples/*.md examples/*/*.md; do
    missing "$page"
done > "$work/seen"
[ ! -s "$work/seen" ] || fail "$(cat "$work/seen")"

# The table of presets has them all.
sed -n 's/^| `\([a-z-]*\)` | .*/\1/p' src/README.md | sort > "$work/listed"
sed -n '/"configurePresets"/,/"buildPresets"/s/.*"name": "\([a-z-]*\)".*/\1/p' CMakePresets.json | sort | diff "$work/listed" - ||
    fail "the presets of src/README.md are not those of CMakePresets.json"

lines=$(wc -l < README.md)
[ "$lines" -le 140 ] || fail "README.md has $lines lines"

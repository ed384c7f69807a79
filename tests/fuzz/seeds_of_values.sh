#!/bin/sh
# seeds_of_values.sh TRANSCRIPTS FOLDER: writes a seed for each text that a command of these transcripts gives to rotconv.
set -eu
transcripts=$1 folder=$2
rm -rf "$folder"
mkdir -p "$folder/bin" "$folder/seeds"
cat > "$folder/bin/rotconv" <<'END'
#!/bin/bash
# Keeps what stands in the place of VALUEs, behind the SPEC.
while [ $# -gt 0 ]; do
    case $1 in
    -f) spec=$2; shift ;;
    -t | -p | --left | --decimals | --columns | --diagnostics) shift ;;
    -*) [[ $1 != -[0-9.]* ]] || values+="$1 " ;;
    *) values+="$1 " ;;
    esac
    shift
done
[ -z "${spec-}" ] || [ "${#values}" -gt 2000 ] || printf '%s\n%s' "$spec" "${values% }" > "$SEEDS/$(printf '%s\n%s' "$spec" "$values" | cksum | cut -d ' ' -f 1)"
END
chmod +x "$folder/bin/rotconv"
for name in printed texts values first_values; do
    SEEDS=$folder/seeds PATH=$folder/bin:$PATH "$(dirname "$0")/../package/run_commands.sh" "$transcripts/$name.txt" > /dev/null || true
done
# And some of words: byte 0 the SPEC, from 128 on numbers.
printf 'words\n0\200\202\204\206' > "$folder/seeds/words_of_four"

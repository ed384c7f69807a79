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
# And some of words: the first byte is the SPEC, bytes from 128 on are numbers.
printf 'words\n2\201\202\203\204' > "$folder/seeds/words_quat"
printf 'words\n4\201\202\203' > "$folder/seeds/words_rpy"
printf 'words\n2\000\201\001\202\002\203\003\204' > "$folder/seeds/words_labels"
printf 'words\n2\033\201\202\203\204' > "$folder/seeds/words_order"
for spec in 0 1 3 5 6 7 8 9; do
    printf 'words\n%s\201\202\203\204\205\206' $spec > "$folder/seeds/words_of_$spec"
done
# And orders of numbers that all differ.
count=0
for text in 'q_xyzw = [0.1, 0.2, 0.3, 0.9]' 'Rotation.from_quat([0.1, 0.2, 0.3, 0.9])' '(x, y, z, w) 0.1 0.2 0.3 0.9' 'xyzw: 0.1 0.2 0.3 0.9'; do
    count=$((count + 1))
    printf 'quat\n%s' "$text" > "$folder/seeds/order_$count"
done

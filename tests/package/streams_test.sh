#!/bin/sh
# streams_test.sh FOLDER: converts the TUM, EuRoC and KITTI files of the folder as the examples do. Every attitude must be the
# input's, every other field the same bytes, every line there.
set -eu
cd "$1"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# check FILE DELIMITER OTHERS OTHERS_OUT FROM COLUMNS TO COLUMNS_OUT [OPTION]: both fields beside the attitude, as cut lists them.
check() {
    file=$1 delimiter=$2 others=$3 others_out=$4 from=$5 columns=$6 to=$7 columns_out=$8
    shift 8
    rotconv -f "$from" -t "$to" --columns "$columns" --diagnostics off "$@" "$file" > "$work/out"
    rotconv compare -f "$to" --columns "$columns_out" -t "$from" --reference-columns "$columns" --within 4e-15rad \
        --diagnostics off "$work/out" "$file"
    grep -v '^#' "$file" | cut -d "$delimiter" -f "$others" > "$work/expected"
    grep -v '^#' "$work/out" | cut -d "$delimiter" -f "$others_out" | cmp - "$work/expected"
    [ "$(wc -l < "$work/out")" = "$(wc -l < "$file")" ]
}

check tum_fr1_xyz.txt ' ' 1-4 1-4 quat:tum 5-8 rpy:deg 5-7
check euroc.csv , 1-4,9- 1-4,14- quat 5-8 dcm 5-13
check kitti.txt ' ' 1-12 1-12 dcm 1-3,5-7,9-11 quat 13-16 --append

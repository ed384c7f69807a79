#!/bin/sh
# quickstart_test.sh SOURCE: the quick start ends well and shows a row of each of its three files.
set -eu
shown=$("$1/examples/quickstart" 2>&1) || {
    printf '%s\n' "$shown"
    echo "FAILED: the quick start did not end well"
    exit 1
}
for row in "1305031098.6659 1.3563 0.6305 1.6380 -117.65" "r11,r12,r13" "8.600000e-01 0.9999988"; do
    printf '%s\n' "$shown" | grep -q -- "$row" || {
        printf '%s\n' "$shown"
        echo "FAILED: the quick start does not show $row"
        exit 1
    }
done

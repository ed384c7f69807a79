#!/bin/sh
# euroc-with-parallel.sh [OPTION OF PARALLEL...] < IN > OUT: GNU parallel cuts an EuRoC table into chunks of whole rows, rotconv
# makes roll, pitch and yaw of each, and the bytes that come out are those of a single run. On one machine rotconv's own threads
# are faster; this is for more, such as these two, which have rotconv and GNU parallel themselves:
#     euroc-with-parallel.sh --block 10M --sshlogin one,two < IN > OUT
#
# The first chunk has the header, and takes the columns by name; the others are told that they have none, and take them by index. Rows that
# fail stand as nan in their places. The exit status is the number of chunks that failed, 101 for more than 100. The messages
# count lines from the start of a chunk, and do not say of which; the output's lines with nan have the numbers of the input's.
set -eu
# shellcheck disable=SC2016 # the expression is for parallel
exec parallel --will-cite --pipe --keep-order "$@" rotconv -f quat -t rpy:deg --delimiter comma --threads 1 --on-error nan \
    --columns '{= $_ = seq() == 1 ? "q_RS_w,q_RS_x,q_RS_y,q_RS_z" : "5-8" =}' --header '{= $_ = seq() == 1 ? "auto" : "no" =}'

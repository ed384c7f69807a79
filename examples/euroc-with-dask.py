"""euroc-with-dask.py [--piece BYTES] [--workers N | --scheduler ADDRESS] IN > OUT: the quaternions of an EuRoC table
become roll, pitch and yaw under Dask. The bytes that come out are those of a single run, and the messages count lines
from the start of IN.

Without --scheduler N workers, or two, are started here. For several machines, each of which has rotconv and the file IN:
    dask-scheduler                    # on one of them; it prints its ADDRESS
    dask-worker ADDRESS --nthreads 1  # on each, as often as it has processors

A worker reads a piece of whole lines and gives it to a rotconv of its own. If a worker dies, Dask has its pieces done again
by others. Rows that fail stand as nan in their places; then the exit status is 1.
"""
import argparse
import collections
import itertools
import os
import re
import subprocess
import sys

from distributed import Client

COMMAND = "rotconv -f quat -t rpy:deg --delimiter comma --threads 1 --on-error nan --diagnostics off --columns".split()
FIRST = ["q_RS_w,q_RS_x,q_RS_y,q_RS_z"]
OTHERS = ["5-8", "--header", "no"]


def line_after(file, position):
    """Where the first line begins that does not begin before position."""
    file.seek(max(position - 1, 0))
    if position > 0:
        file.readline()
    return file.tell()


def convert(path, begin, end):
    """Rows, messages, exit status and number of the lines that begin in the bytes from begin to before end."""
    with open(path, "rb") as file:
        end = line_after(file, end)
        begin = line_after(file, begin)
        piece = file.read(end - begin)
    run = subprocess.run(COMMAND + (OTHERS if begin else FIRST), input=piece, capture_output=True)
    return run.stdout, run.stderr, run.returncode, piece.count(b"\n")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("path", metavar="IN")
    parser.add_argument("--piece", type=int, default=8 << 20)
    parser.add_argument("--workers", type=int, default=2)
    parser.add_argument("--scheduler")
    options = parser.parse_args()
    path = os.path.abspath(options.path)

    here = {"n_workers": options.workers, "threads_per_worker": 1, "dashboard_address": ":0"}
    with Client(options.scheduler) if options.scheduler else Client(**here) as client:
        client.wait_for_workers(1)
        begins = iter(range(0, os.path.getsize(path), options.piece))

        def submit(count):
            """The next pieces. Two for each worker at a time, so that results do not pile up there."""
            for begin in itertools.islice(begins, count):
                yield client.submit(convert, path, begin, begin + options.piece, pure=False)

        waiting = collections.deque(submit(2 * sum(client.nthreads().values())))
        lines = worst = 0
        while waiting and worst < 2:
            rows, messages, status, count = waiting.popleft().result()
            waiting.extend(submit(1))
            sys.stdout.buffer.write(rows)
            in_file = lambda line: f"rotconv: {options.path}:{lines + int(line[1])}"
            sys.stderr.write(re.sub(r"(?m)^rotconv: -:(\d+)", in_file, messages.decode(errors="replace")))
            lines += count
            worst = max(worst, status)
    sys.exit(worst)


if __name__ == "__main__":
    main()

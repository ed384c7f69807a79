"""spark-submit euroc-with-spark.py IN OUT: the quaternions of EuRoC tables become roll, pitch and yaw under Spark (PySpark 3).

Each partition is piped through one rotconv, which takes the columns by index, since a partition has no header. The header, which
begins with #, is left out. Where a row fails, rotconv ends with 2, so the task fails, and after Spark's retries the job; the
message in the executor's log counts lines within the partition.
"""
import sys

from pyspark import SparkContext

COMMAND = "rotconv -f quat -t rpy:deg --columns 5-8 --delimiter comma --header no --threads 1"

rows = SparkContext(appName="rotconv").textFile(sys.argv[1]).filter(lambda line: not line.startswith("#"))
# Without env the command has an empty environment. PATH is that of the workers.
rows.pipe(COMMAND, env={"PATH": "/usr/local/bin:/usr/bin:/bin"}, checkCode=True).saveAsTextFile(sys.argv[2])

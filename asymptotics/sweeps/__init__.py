"""Sweeps: one computation at many points, on one core or a cluster, stopped and resumed at will.

===========  =======================================================================================
``grid``     the points: ranges, lists and their combinations, exact text throughout
``shard``    a file of finished points whose lines prove themselves, and its lock
``store``    the folder of shards; where a point lies, by the SHA-256 of its task
``plan``     what the store does not hold yet, shard by shard
``workers``  what runs in a worker; this process, a pool of processes, or Dask
``run``      the driver: ``sweep(task, command, points, folder)``
``export``   CSV, JSON or Parquet in the order of the sweep; a reader that returns exact values
===========  =======================================================================================
"""

from asymptotics.sweeps.grid import Grid, values
from asymptotics.sweeps.run import SweepResult, sweep

__all__ = ["Grid", "SweepResult", "sweep", "values"]

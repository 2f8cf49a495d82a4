"""What is left to do: the points of a sweep that its store does not hold, shard by shard, each under its lock.

A shard that another driver holds is passed over and met again later, when its points may have become points to reuse.
Memory: one byte for each point of the sweep (its bucket), and the keys of the shards at work.
"""

from collections import deque
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field

import numpy as np

from asymptotics.sweeps.grid import Point
from asymptotics.sweeps.shard import LockedShard, failure
from asymptotics.sweeps.store import Store, place

# All are in the store with their reasons; on the screen twenty tell what is wrong.
SHOWN = 20  # failures that are reported with their reason


@dataclass(eq=False)
class Job:
    """A point to compute, and the shard that waits for it; ``tries`` counts the workers that died with it."""

    index: int
    key: str
    point: Point
    shard: LockedShard
    tries: int = 0


@dataclass
class Failures:
    """How many points failed, and the reasons of the first ones in the order of the sweep."""

    count: int = 0
    first: list[tuple[int, Point, str]] = field(default_factory=list)

    def add(self, index: int, point: Point, reason: str) -> None:
        """Count one more failed point; the reasons of the first few are kept."""
        self.count += 1
        self.first = sorted([*self.first, (index, point, reason)], key=lambda f: f[0])[:SHOWN]


@dataclass
class SweepPlan:
    """Iterate over ``jobs()``: a Job, or None while all that is left is held by other drivers."""

    command: str
    points: Sequence[Point]
    store: Store
    reused: int = 0
    failures: Failures = field(default_factory=Failures)
    open_shards: list[LockedShard] = field(default_factory=list)

    def buckets(self) -> np.ndarray:
        """The bucket of each point."""
        size = len(self.points)
        # The key is computed again when the shard's turn comes: 64 characters for each of 10^7 points would be a
        # gigabyte.
        return np.fromiter((place(self.command, p)[0] for p in self.points), dtype=np.uint8, count=size)

    def jobs(self) -> Iterator[Job | None]:
        """The points that the store does not hold; ``reused`` counts the others, each distinct point once computed."""
        buckets = self.buckets()
        queue = deque(int(bucket) for bucket in np.unique(buckets))
        passed = 0
        while queue:
            shard = self.store.take(queue[0])
            if shard is None:
                # Held by another driver: to the end of the queue.  Once all that are left were met so, the caller
                # decides what to do while it waits, and the round begins again.
                queue.rotate(-1)
                passed += 1
                if passed >= len(queue):
                    passed = 0
                    yield None
                continue
            passed = 0
            yield from self._of_shard(shard, np.flatnonzero(buckets == queue.popleft()))

    def _of_shard(self, shard: LockedShard, indices: np.ndarray) -> Iterator[Job]:
        self.open_shards.append(shard)
        shard.waiting += 1  # the shard stays open until all its jobs are handed out
        # Keys handed out and not yet in the shard: a point that occurs twice is computed once.
        coming: set[str] = set()
        for index in map(int, indices):
            point = self.points[index]
            key = place(self.command, point)[1]
            if key in shard.keys or key in coming:
                self.reused += 1
                if key in shard.failed:
                    self.failures.add(index, point, shard.failed[key])
                continue
            coming.add(key)
            shard.waiting += 1
            yield Job(index, key, point, shard)
        self.release(shard)

    def release(self, shard: LockedShard) -> None:
        """One point less to wait for; the last one closes the shard."""
        shard.waiting -= 1
        if not shard.waiting:
            self.open_shards.remove(shard)
            shard.close()

    def close(self) -> None:
        """Close every shard that is still open."""
        while self.open_shards:
            self.open_shards.pop().close()


def finished(command: str, points: Sequence[Point], store: Store) -> SweepPlan | None:
    """The plan of a sweep of which the store, that is only read here, holds every point; None where one is missing."""
    plan = SweepPlan(command, points, store)
    buckets = plan.buckets()
    for bucket in map(int, np.unique(buckets)):
        found = {key: failure(record) for _, key, record in store.read(bucket)}
        for index in map(int, np.flatnonzero(buckets == bucket)):
            key = place(command, points[index])[1]
            if key not in found:
                return None
            plan.reused += 1
            reason = found[key]
            if reason is not None:
                plan.failures.add(index, points[index], reason)
    return plan

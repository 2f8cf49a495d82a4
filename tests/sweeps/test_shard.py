"""Shards that were damaged or torn: nothing wrong is read back."""

import random

import tasks
from hypothesis import given
from hypothesis import strategies as st

from asymptotics.sweeps import sweep
from asymptotics.sweeps.shard import LockedShard, verified, written
from tests.sweeps.test_run import stored

LAST = 60


def all_right(folder, points):
    found = stored(folder, points)
    assert found == {n: n * n for n in range(1, len(points) + 1)}


def test_damaged_shards_are_never_read_back(log, folder):
    points = tasks.grid(log, LAST)
    sweep(tasks.square, "square", points, folder, workers=1)
    chance = random.Random(1)
    for path in sorted((folder / "shards").iterdir()):
        data = bytearray(path.read_bytes())
        kind = chance.choice(["flip", "cut", "keep", "swap"])
        if kind == "flip":
            data[chance.randrange(len(data))] ^= 1 << chance.randrange(8)
        if kind == "cut":
            data = data[: chance.randrange(len(data))]
        if kind == "swap":  # a number is replaced by another, as a careless editor would
            data = data.replace(b'"square":"', b'"square":"1')
        path.write_bytes(data)
    intact = stored(folder, points)
    assert 0 < len(intact) < LAST
    assert all(value == n * n for n, value in intact.items())
    again = sweep(tasks.square, "square", points, folder, workers=1)
    assert again.reused == len(intact)
    assert again.computed == LAST - len(intact)
    all_right(folder, points)


@given(st.text(alphabet='ab{":,}\\ é', max_size=40), st.data())
def test_a_line_proves_itself(record, data):
    line = written("0" * 64, record)
    assert verified(line) == ("0" * 64, record)
    place = data.draw(st.integers(0, len(line) - 1))
    bit = data.draw(st.integers(0, 7))
    wrong = line[:place] + bytes([line[place] ^ (1 << bit)]) + line[place + 1 :]
    if place not in (64, 129):  # the two spaces carry nothing
        assert verified(wrong) is None
    assert verified(line[:place]) is None


def test_a_torn_line_does_not_spoil_the_next_one(tmp_path):
    path = tmp_path / "00.points"
    path.write_bytes(written("1" * 64, "{}") + written("2" * 64, "{}")[:50])
    shard = LockedShard.take(path)
    assert LockedShard.take(path) is None  # the lock holds
    assert shard.keys == {"1" * 64}
    shard.append("3" * 64, "{}")
    shard.close()
    shard = LockedShard.take(path)
    assert shard.keys == {"1" * 64, "3" * 64}
    shard.close()

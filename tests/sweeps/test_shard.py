"""Shards that were damaged or torn: nothing wrong is read back."""

import os
import random

import pytest
import tasks
from hypothesis import given
from hypothesis import strategies as st
from tasks import sweep

from asymptotics.errors import InputError
from asymptotics.sweeps.shard import LockedShard, believed, content_key, lines, record_of, verified, written
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
    one, two, three = ({"command": "c", "n": n} for n in "123")
    line = lambda task: written(content_key(task), record_of(task, '{"result":1}'))  # noqa: E731
    path.write_bytes(line(one) + line(two)[:50])
    shard = LockedShard.take(path)
    assert LockedShard.take(path) is None  # the lock holds
    assert shard.keys == {content_key(one)}
    shard.append(content_key(three), record_of(three, '{"result":3}'))
    shard.close()
    shard = LockedShard.take(path)
    assert shard.keys == {content_key(one), content_key(three)}
    shard.close()


def test_a_record_under_the_key_of_another_task_is_not_believed(tmp_path):
    """Failed before: a line with a new checksum proved itself, whatever it said of which point it was."""
    one, two = ({"command": "c", "point": {"n": n, "task": "x"}} for n in "12")
    right = written(content_key(one), record_of(one, '{"result":1}'))
    wrong = written(content_key(two), record_of(one, '{"result":1}'))
    assert verified(wrong) is not None
    assert believed(wrong) is None and believed(right) == verified(right)
    path = tmp_path / "00.points"
    path.write_bytes(wrong + right)
    assert [key for _, key, _ in lines(path)] == [content_key(one)]


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="no pipes with names on this system")
def test_a_shard_that_is_a_link_or_a_pipe_is_refused(tmp_path):
    """Failed before: what the link led to was written to, and the pipe was waited for."""
    target, link, pipe = (tmp_path / name for name in ("target", "00.points", "01.points"))
    target.write_text("mine")
    link.symlink_to(target)
    os.mkfifo(pipe)
    for path in (link, pipe):
        with pytest.raises(InputError, match="store of plain files"):
            LockedShard.take(path)
        with pytest.raises(InputError, match="store of plain files"):
            list(lines(path))
    assert target.read_text() == "mine"


def filed(count):
    """Points of a task with their keys."""
    tasks_of = [{"command": "c", "point": {"n": str(n), "task": "x"}} for n in range(count)]
    return [(content_key(task), record_of(task, '{"result":1}')) for task in tasks_of]


@pytest.mark.parametrize("most", [1, 7, 100])
def test_a_write_that_is_short_goes_on_where_it_stopped(tmp_path, monkeypatch, most):
    path, write, left = tmp_path / "00.points", os.write, iter(range(2000))

    def short(handle, data):
        next(left)  # a loop that does not go on ends as well
        return write(handle, data[:most])

    monkeypatch.setattr(os, "write", short)
    shard, points = LockedShard.take(path), filed(2)
    for point in points:
        shard.append(*point)
    monkeypatch.undo()
    shard.close()
    assert path.read_bytes() == b"".join(written(*point) for point in points)
    assert [(key, record) for _, key, record in lines(path)] == points


def test_a_write_that_fails_leaves_the_file_as_it_was(tmp_path, monkeypatch):
    path, write, (one, two) = tmp_path / "00.points", os.write, filed(2)
    shard = LockedShard.take(path)
    shard.append(*one)
    before = path.read_bytes()

    def full(handle, data):
        if path.stat().st_size > len(before):
            raise OSError(28, "no space left")
        return write(handle, data[:10])

    monkeypatch.setattr(os, "write", full)
    with pytest.raises(OSError, match="no space"):
        shard.append(*two)
    monkeypatch.undo()
    assert path.read_bytes() == before and shard.keys == {one[0]}
    shard.append(*two)
    assert [key for _, key, _ in lines(path)] == [one[0], two[0]]
    shard.close()

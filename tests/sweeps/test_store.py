"""What is no store is refused and left alone."""

import pytest
import tasks
from tasks import sweep

from asymptotics.errors import InputError

FOREIGN = [None, "", "{}", '{"format": "other"}', '{"format": "asymptotics-sweep/1", "version": "0.0.0"}', "[]"]


@pytest.mark.parametrize("content", FOREIGN)
def test_a_foreign_store_is_refused_and_left_alone(folder, log, content):
    folder.mkdir()
    (folder / "thesis.txt").write_text("dear")
    if content is not None:
        (folder / "store.json").write_text(content)
    before = sorted(p.name for p in folder.iterdir())
    with pytest.raises(InputError, match="argument folder"):
        sweep(tasks.square, "square", tasks.grid(log, 2), folder, workers=1)
    assert sorted(p.name for p in folder.iterdir()) == before


def test_a_file_is_no_store(tmp_path, log):
    (tmp_path / "file").write_text("x")
    with pytest.raises(InputError, match="argument folder"):
        sweep(tasks.square, "square", tasks.grid(log, 2), tmp_path / "file", workers=1)


def test_a_lost_store_json_locks_no_sound_point_away(folder, log):
    grid = tasks.grid(log, 3)
    assert sweep(tasks.square, "square", grid, folder, workers=1).computed == 3
    (folder / "store.json").unlink()
    again = sweep(tasks.square, "square", grid, folder, workers=1)
    assert (again.computed, again.reused) == (0, 3) and "written again" in again.notes[0]
    assert sweep(tasks.square, "square", grid, folder, workers=1).notes == ()
    # Near misses: shards of other code alone, and a folder with something else beside the shards.
    (folder / "store.json").unlink()
    for shard in (folder / "shards").iterdir():
        shard.write_text(shard.read_text().replace("sha256", "sha257"))
    with pytest.raises(InputError, match="argument folder"):
        sweep(tasks.square, "square", grid, folder, workers=1)

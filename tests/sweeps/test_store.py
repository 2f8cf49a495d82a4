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
    with pytest.raises(InputError, match="argument store"):
        sweep(tasks.square, "square", tasks.grid(log, 2), folder, workers=1)
    assert sorted(p.name for p in folder.iterdir()) == before


def test_a_file_is_no_store(tmp_path, log):
    (tmp_path / "file").write_text("x")
    with pytest.raises(InputError, match="argument store"):
        sweep(tasks.square, "square", tasks.grid(log, 2), tmp_path / "file", workers=1)

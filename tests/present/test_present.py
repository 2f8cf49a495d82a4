import pytest

from asymptotics.errors import InputError
from asymptotics.present.figures import render
from asymptotics.present.files import require_writable, write_atomically


def test_a_failed_write_leaves_the_old_file(tmp_path):
    target = tmp_path / "a.txt"
    write_atomically(target, "old")
    with pytest.raises(TypeError):
        write_atomically(target, None)
    assert target.read_text() == "old"
    assert [p.name for p in tmp_path.iterdir()] == ["a.txt"]


def test_a_folder_that_cannot_be_written_is_refused(tmp_path):
    (tmp_path / "file").write_text("")
    with pytest.raises(InputError, match="--report: cannot write"):
        require_writable(tmp_path / "file" / "below", "--report")
    require_writable(tmp_path / "a" / "b", "--report")
    assert (tmp_path / "a" / "b").is_dir()


@pytest.mark.parametrize("kind", ["svg", "png"])
def test_pictures_are_the_same_bytes_each_time(kind):
    def draw(axes):
        axes.plot([0, 1], [1, 0], label=r"$\omega t$")
        axes.legend()

    assert render(draw, kind=kind) == render(draw, kind=kind)
    assert render(draw, kind=kind) != render(lambda axes: axes.plot([0, 1]), kind=kind)

"""Files: written through links, nothing but regular files, modes and umask kept, all of them or none."""

import os
import resource
import stat
import subprocess
import sys
from pathlib import Path

import pytest

from asymptotics.errors import InputError
from asymptotics.present.files import require_different, require_writable, target_file, write_all, write_atomically


def names(folder: Path) -> list[str]:
    return sorted(p.name for p in folder.iterdir())


def mode(path: Path) -> int:
    return stat.S_IMODE(path.stat().st_mode)


def test_a_link_is_written_through_and_stays_a_link(tmp_path):
    (tmp_path / "far").mkdir()
    real, link = tmp_path / "far" / "a.csv", tmp_path / "link.csv"
    real.write_text("old")
    link.symlink_to(real)
    write_all({target_file(link, "--csv"): "new"})
    assert link.is_symlink()
    assert real.read_text() == "new"
    assert names(tmp_path / "far") == ["a.csv"]
    hanging = tmp_path / "hanging"
    hanging.symlink_to(tmp_path / "far" / "b.csv")
    write_all({target_file(hanging, "--csv"): "made"})
    assert (tmp_path / "far" / "b.csv").read_text() == "made"
    loop = tmp_path / "loop"
    loop.symlink_to(loop)
    with pytest.raises(InputError, match="--csv"):
        target_file(loop, "--csv")


def test_what_is_not_a_regular_file_is_refused_and_left_alone(tmp_path):
    fifo = tmp_path / "fifo"
    os.mkfifo(fifo)
    (tmp_path / "link").symlink_to(fifo)
    for name in (fifo, tmp_path / "link"):
        with pytest.raises(InputError, match="is a FIFO"):
            target_file(name, "--csv")
        with pytest.raises(InputError, match="is a FIFO"):
            write_all({name: "x"})
    assert stat.S_ISFIFO(fifo.stat().st_mode)
    with pytest.raises(InputError, match="is a folder"):
        target_file(tmp_path, "--csv")
    assert names(tmp_path) == ["fifo", "link"]


@pytest.mark.skipif(os.geteuid() != 0, reason="making a device node needs root")
def test_a_device_node_is_refused(tmp_path):
    node = tmp_path / "node"
    try:
        os.mknod(node, stat.S_IFCHR | 0o666, os.makedev(1, 3))
    except PermissionError:
        pytest.skip("no device nodes here")
    with pytest.raises(InputError, match="is a device"):
        target_file(node, "--csv")
    assert stat.S_ISCHR(node.stat().st_mode)


@pytest.mark.parametrize("umask", [0o022, 0o077, 0o002])
def test_a_new_file_gets_what_the_umask_leaves_and_an_old_one_keeps_its_mode(tmp_path, umask):
    old = tmp_path / "old"
    old.write_text("x")
    old.chmod(0o600)
    before = os.umask(umask)
    try:
        write_all({tmp_path / "new": "x", old: "y"})
    finally:
        os.umask(before)
    assert mode(tmp_path / "new") == 0o666 & ~umask
    assert mode(old) == 0o600


def test_long_names_missing_folders_and_odd_ones(tmp_path):
    long = tmp_path / ("n" * 250 + ".csv")
    write_all({target_file(long, "--csv"): "x"})
    assert long.read_text() == "x"
    bad = {tmp_path / ("n" * 256): "name", tmp_path / "no" / "a": "no folder", tmp_path / "a\0b": "null", "": "empty"}
    for name, word in bad.items():
        with pytest.raises(InputError, match=word):
            target_file(name, "--csv")
    odd = tmp_path / "a b ü 漢.csv"
    write_all({target_file(odd, "--csv"): "x"})
    assert odd.read_text() == "x"


def test_one_file_for_two_options_is_refused(tmp_path):
    (tmp_path / "a.svg").write_text("x")
    (tmp_path / "link.svg").symlink_to(tmp_path / "a.svg")
    (tmp_path / "hard.svg").hardlink_to(tmp_path / "a.svg")
    for other in ("a.svg", "link.svg", "hard.svg", "./a.svg"):
        with pytest.raises(InputError, match="--csv"):
            require_different({"--plot": tmp_path / "a.svg", "--csv": tmp_path / other})
    require_different({"--plot": tmp_path / "a.svg", "--csv": tmp_path / "b", "--latex": None})


def test_all_or_none(tmp_path):
    for name in ("a", "b"):
        (tmp_path / name).write_text("old " + name)
    os.mkfifo(tmp_path / "c")
    with pytest.raises(InputError):
        write_all({tmp_path / "a": "new", tmp_path / "d": "new", tmp_path / "c": "new"})
    assert names(tmp_path) == ["a", "b", "c"]
    assert (tmp_path / "a").read_text() == "old a"


def test_a_rename_that_fails_takes_the_others_back(tmp_path, monkeypatch):
    (tmp_path / "a").write_text("old")
    real = Path.replace

    def replace(self: Path, target: Path) -> Path:
        if Path(target).name == "c":
            raise OSError(28, "No space left on device")
        return real(self, target)

    monkeypatch.setattr(Path, "replace", replace)
    with pytest.raises(InputError, match="No space"):
        write_all({tmp_path / "a": "new", tmp_path / "b": "new", tmp_path / "c": "new"})
    assert names(tmp_path) == ["a"]
    assert (tmp_path / "a").read_text() == "old"


@pytest.mark.parametrize("links", [True, False])
def test_a_full_disk_leaves_everything_as_it_was(tmp_path, links, monkeypatch):
    """RLIMIT_FSIZE stands for the disk: what fits is written, what is larger fails in the middle of the write."""
    (tmp_path / "a").write_text("old")
    if not links:
        monkeypatch.setattr(Path, "hardlink_to", lambda *_: (_ for _ in ()).throw(OSError(1, "no links")))
        write_all({tmp_path / "a": "old"})
        assert names(tmp_path) == ["a"]
        return
    code = (
        "import resource, sys; from pathlib import Path; from asymptotics.present.files import write_all\n"
        "resource.setrlimit(resource.RLIMIT_FSIZE, (5000, 5000))\n"
        "folder = Path(sys.argv[1]); write_all({folder / 'a': 'new', folder / 'b': 'x' * 50000}, '--csv')\n"
    )
    assert resource.RLIMIT_FSIZE
    done = subprocess.run([sys.executable, "-c", code, tmp_path], capture_output=True, text=True, check=False)
    assert "InputError: argument --csv: cannot write" in done.stderr
    assert "File too large" in done.stderr
    assert names(tmp_path) == ["a"]
    assert (tmp_path / "a").read_text() == "old"


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

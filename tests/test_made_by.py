"""Everything that is written down says which code made it, and what other code has made is not believed."""

import csv
import json
import os
import re
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

import asymptotics as asy
import asymptotics.made_by as module
from asymptotics.ask.registry import QUESTIONS
from asymptotics.made_by import LIBRARIES, code, commit, made_by, mark, versions
from asymptotics.shell.main import main
from asymptotics.sweeps import Grid, sweep
from asymptotics.sweeps.workers import OtherCodeError, run_batch
from paper_checks.command import run as paper_checks
from paper_checks.report import build as report
from tests.every_question import example, options_of
from tests.wheel import tried

ROOT = Path(__file__).parents[1]
KINDS = {"json": "", "csv": ".csv", "html": ".html", "output": ".tex", "export": ".json", "store": ""}
MORE = [("table", "output", end) for end in (".csv", ".json", ".tex")] + [("sweep", "export", ".csv")]


WRITTEN = [
    (c, kind, end)
    for c in QUESTIONS
    for kind, end in KINDS.items()
    if f"--{kind}" in options_of(c) and (kind != "html" or c == "moment")  # pages of all: tests/ask/test_pages.py
] + MORE


def told(content):
    """The content of a file or answer, if it says which code made it."""
    return code()[:16] in content or mark() in content


@pytest.mark.parametrize(("command", "kind", "end"), WRITTEN)
def test_every_output_says_which_code_made_it(command, kind, end, tmp_path, capsys):
    line = example(command, tmp_path)
    target = tmp_path / f"written{end}"
    extra = {"json": ["--json"], "store": []}.get(kind, [f"--{kind}", str(target)])
    form = {".csv": "csv", ".json": "json", ".tex": "latex"}.get(end)
    assert main([*line, *extra, *(["--format", form] if kind == "output" else [])]) == 0
    out = capsys.readouterr().out
    if kind == "store":
        shards = [p for p in tmp_path.rglob("*.points") if p.stat().st_size]
        assert shards and all(f'"code":"{mark()}"' in line for p in shards for line in p.read_text().splitlines())
        target = tmp_path / "store" / "store.json"
    assert told(out if kind == "json" else target.read_text())
    if kind == "json":
        assert json.loads(out)["made_by"] == made_by()
    if end == ".csv" and command != "table":
        head, *rows = csv.reader(target.read_text().splitlines())
        assert head[-1].split(" [")[0] == "code" and rows and {row[-1] for row in rows} == {mark()}


def test_no_option_that_writes_is_forgotten():
    """Pictures depend on nothing but their data; ``list`` and ``dask`` are read."""
    named = {name.removeprefix("--") for c in QUESTIONS for name in options_of(c)}
    files = {name for name in named if re.search("csv|html|output|export|store|report|save|file|json|write", name)}
    assert files - set(KINDS) == set()


def test_the_report_on_the_papers_says_it(monkeypatch, capsys):
    monkeypatch.setattr(report, "engine_data", dict)
    assert report.report_data([])["made_by"] == made_by()
    assert paper_checks(["lelas2024", "--id", "lelas2024:4", "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["made_by"] == made_by()


def test_the_samples_of_a_motion_say_it():
    text = asy.motion({2: "1/10"}).sample([0.0, 1.0]).to_csv()
    assert [row.rpartition(",")[2] for row in text.splitlines()] == [
        "code [--order=3 --gauge=turning-point]",
        mark(),
        mark(),
    ]


def other_code(monkeypatch, **changes):
    """As if the package had been edited, or a library replaced."""
    for name, value in changes.items():
        monkeypatch.setattr(module, name, lambda value=value: value)
    mark.cache_clear()


@pytest.fixture
def store(tmp_path, monkeypatch):
    """A store that this code has filled."""
    points = Grid({"n": ("1", "2")})
    assert sweep(square, "square", points, tmp_path / "s", workers=1).computed == 2
    yield points, tmp_path / "s"
    monkeypatch.undo()
    mark.cache_clear()


def square(point):
    return {"square": str(int(point["n"]) ** 2)}


def test_a_store_of_this_code_is_believed(store):
    points, folder = store
    assert sweep(square, "square", points, folder, workers=1).reused == 2


def test_a_store_made_by_other_code_is_not_believed(store, monkeypatch, capsys):
    points, folder = store
    other_code(monkeypatch, code="0" * 64)
    with pytest.raises(ValueError, match="holds results of other code .*not believed .accepted: a new or empty folder"):
        sweep(square, "square", points, folder, workers=1)
    assert main(["sweep", "moment", "--p", "1", "--workers", "1", "--store", str(folder)]) == 2
    assert "argument --store: " in capsys.readouterr().err


def test_a_store_made_with_another_library_is_not_believed(store, monkeypatch):
    points, folder = store
    other_code(monkeypatch, versions={**versions(), "sympy": "1.13.3"})
    with pytest.raises(ValueError, match=r"sympy \S+ .this is 1.13.3.: they are not believed"):
        sweep(square, "square", points, folder, workers=1)


def test_a_store_that_does_not_say_who_made_it_is_not_believed(store):
    points, folder = store
    about = json.loads((folder / "store.json").read_text())
    del about["made_by"]
    (folder / "store.json").write_text(json.dumps(about))
    with pytest.raises(ValueError, match="unknown code"):
        sweep(square, "square", points, folder, workers=1)


def test_a_point_of_other_code_in_a_store_of_this_code_is_not_found(store, monkeypatch):
    """Its key is another one, whatever store.json says."""
    points, folder = store
    other_code(monkeypatch, code="0" * 64)
    about = json.loads((folder / "store.json").read_text())
    about["made_by"] = module.made_by()
    (folder / "store.json").write_text(json.dumps(about))
    assert sweep(square, "square", points, folder, workers=1).reused == 0


def test_a_worker_of_other_code_is_refused():
    assert run_batch(square, [{"n": "3"}], mark())[0][0].record == '{"result":{"square":"9"}}'
    with pytest.raises(OtherCodeError, match="a worker runs other code"):
        run_batch(square, [{"n": "3"}], "sha256:another")


def test_one_letter_more_is_other_code(tmp_path):
    for name in ("__init__.py", "made_by.py", "law.py"):
        target = tmp_path / "asymptotics" / name
        target.parent.mkdir(exist_ok=True)
        target.write_bytes((ROOT / "asymptotics" / name).read_bytes())
    run = [sys.executable, "-c", "import asymptotics.made_by as m; print(m.__file__, m.code())"]
    before = subprocess.run(run, cwd=tmp_path, capture_output=True, text=True, check=True).stdout
    (tmp_path / "asymptotics" / "__pycache__").mkdir(exist_ok=True)
    (tmp_path / "asymptotics" / "__pycache__" / "more.py").write_text("no source")
    again = subprocess.run(run, cwd=tmp_path, capture_output=True, text=True, check=True).stdout
    assert str(tmp_path) in before and before == again
    seen = {before}
    for name in ("asymptotics/law.py", "derivations/creep.py", "paper_checks/lelas2024/s.py", "asymptotics/data.json"):
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        with (tmp_path / name).open("a") as stream:
            stream.write("#")
        seen.add(subprocess.run(run, cwd=tmp_path, capture_output=True, text=True, check=True).stdout)
    assert len(seen) == 5


def test_versions_of_every_library_that_computes():
    assert set(versions()) == {"power-law-oscillator", *LIBRARIES}
    assert all(re.match(r"\d+\.\d+", number) for number in versions().values())


@pytest.mark.slow
def test_a_wheel_has_the_same_code_and_knows_its_commit(tmp_path):
    """Built from a checkout, and from the sdist, which has no history; imported from the zip file itself."""
    build = [sys.executable, "-m", "hatchling", "build", "-d", str(tmp_path)]
    subprocess.run(build, cwd=ROOT, capture_output=True, check=True)
    (wheel,) = tmp_path.glob("*.whl")
    ask = "import asymptotics.made_by as m; print(m.code(), m.commit())"
    unpacked = tmp_path / "unpacked"
    zipfile.ZipFile(wheel).extractall(unpacked)
    for place in (wheel, unpacked):
        done = subprocess.run([sys.executable, "-c", ask], cwd=tmp_path, env={"PYTHONPATH": str(place)},
                              capture_output=True, text=True, check=True)  # fmt: skip
        assert done.stdout.split() == [code(), commit()]
    (empty := tmp_path / "empty").mkdir()
    assert tried(sys.executable, empty, {**os.environ, "PYTHONPATH": str(unpacked)}) == []
    (sdist,) = tmp_path.glob("*.tar.gz")
    subprocess.run(["tar", "xzf", str(sdist)], cwd=tmp_path, check=True)
    (source,) = tmp_path.glob("power_law_oscillator-*/")
    again = [*build[:-1], str(tmp_path / "again"), "-t", "wheel"]
    subprocess.run(again, cwd=source, capture_output=True, check=True)
    (second,) = (tmp_path / "again").glob("*.whl")
    assert zipfile.ZipFile(second).read("asymptotics/built_from.txt").decode().strip() == commit()

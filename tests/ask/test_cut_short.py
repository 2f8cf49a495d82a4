"""Rows that are done are kept when the time is over, or at Ctrl-C, wherever that is: those of a whole run, in order.

Every question that hands over its rows is cut at a look at its clock, which is sought between the first row and the
last; so no place of the work is named here.
"""

import json
from itertools import count

import pytest

from asymptotics.ask.registry import QUESTIONS, loaded
from asymptotics.running import budget, public
from asymptotics.shell.main import main
from tests.every_question import example, in_world

KEPT = [name for name in QUESTIONS if loaded(name).offers.missing is not None and name != "table"]
"""Those that hand over their rows; each table has its own way, below."""
SEVERAL = {"damping": "--amplitudes 1,1/2,1/4,1/8", "papers": "Lambert --check"}
"""What makes several rows, where that is no number of them."""
ROUTES = ("dry friction", "linear", "another rational power", "a pendulum in air", "SI", "a start in motion")
TABLES = (
    "smith2012.table1 --rows 5", "turning-points --law 2:1/10 --rows 5", "turning-points --alpha 3,2 --epsilon 1/10",
    "half-periods --alpha 2 --epsilon 1/10,1/2", "normal-form --alpha 1,2,3 --rows 2", "stokes.constants --alpha 0,2",
    "stops --epsilon 1/10,1/20", "smith2012.c --rows 3", "smith2012.f --rows 3",
)  # fmt: skip
FILES = {  # each reader of rows, and what they are held against
    "n,x,t\n0,0.2,0\n1,-0.1,0.7\n2,0.05,1.4\n": "--alpha 3/2 --mass 3/2 --stiffness 30 --damping 1/10 --x0 1/5",
    "n,x\n5000,0.1\n0,1\n": "--alpha 2 --epsilon 1",
    "tau,x,v\n20,0.5,0\n0,1,0\n5,0.2,0.9\n": "--alpha 3/2 --epsilon 1/10",
    "tau,amplitude,phase\n0,1,0\n1,0.9,0\n2,0.8,0\n": "--alpha 2 --epsilon 1/10",
    "half_cycle,u\n1,0.7\n4,-0.2\n2,-0.41\n": "--table smith2012.table1",
}
CASES = [
    *(pytest.param(name, "", "", error, id=f"{name}-{error}") for name in KEPT for error in ("time", "Ctrl-C")),
    *(pytest.param("turning-points", world, "", "time", id=world) for world in ROUTES),
    *(pytest.param("table", "", given, "time", id=given) for given in TABLES),
    *(pytest.param("compare", text, given, "Ctrl-C", id=text.partition("\n")[0]) for text, given in FILES.items()),
]


def several(name, folder, about, given):
    """Its example with several rows: in a world, of a file, or with what is given in its place."""
    if name == "compare" and about:
        (folder / "mine.csv").write_text(about)
        return [name, str(folder / "mine.csv"), *given.split(), "--json"]
    if given:
        return [name, *given.split(), "--digits", "6", "--json"]
    words = [name] if name == "papers" else in_world(name, folder, about) if about else example(name, folder)
    sizes = ["--count=5"] if "count" in loaded(name).schema()["properties"] else []
    return [*words, *SEVERAL.get(name, "").split(), *sizes, "--json"]


def cut(words, look, error, monkeypatch, capsys):
    """(exit code, what is printed) where the time is over, or Ctrl-C comes, at a look at the clock, and stays over."""
    looks = count()

    def now():
        if next(looks) < look:
            return 0.0
        if error == "Ctrl-C":
            raise KeyboardInterrupt
        return 1e9

    with monkeypatch.context() as patch:
        patch.setattr(budget, "monotonic", now)
        patch.setattr(public, "PERIOD", 3600.0)
        code = main(words)
    out, err = capsys.readouterr()
    assert "fault" not in err
    return code, json.loads(out) if out else None


def rows_of(found, whole):
    """The rows that both have, each cell a text: of a table without the names of what it is of."""
    name = next(key for key in ("points", "rows", "outcomes") if key in whole)
    every, done = (v if isinstance(v, list) else [*v.items()] for v in (whole[name], (found or {}).get(name, [])))
    return [r[-len(every[0]) :] if isinstance(r, list) else r for r in done], every


@pytest.mark.parametrize(("name", "about", "given", "error"), CASES)
def test_the_rows_that_are_done_are_those_of_a_whole_run(name, about, given, error, tmp_path, monkeypatch, capsys):
    words = several(name, tmp_path, about, given)
    assert main(words) in (0, 1)
    whole = json.loads(capsys.readouterr().out)
    low, high = 1, 2  # what is kept of one run saves the next one looks: the lower end begins anew
    while cut(words, high, error, monkeypatch, capsys)[0] not in (0, 1):
        high *= 2
    while high - low > 1:
        middle = (low + high) // 2
        code, found = cut(words, middle, error, monkeypatch, capsys)
        done, all_rows = rows_of(found, whole)
        assert code in (0, 1, 130 if error == "Ctrl-C" else 2) and (found is None or done)
        places = [all_rows.index(row) for row in done]
        assert places == sorted(places)
        if code in (0, 1):
            high = middle
        elif len(done) in (0, len(all_rows)):
            low, high = (middle, high) if not done else (low, middle)
        else:
            assert found["missing"] and found.get("certified", True) is not False
            return
    pytest.fail("at no look at the clock some rows are kept and others are missing")

"""One table of parity: every command and option beside its Python call, which exists; a pair of each says the same."""

import argparse
import inspect
import json
import re
import sys
from functools import cache
from importlib import import_module
from pathlib import Path

import pytest

import asymptotics as asy
from asymptotics.ask.registry import QUESTIONS, loaded
from asymptotics.shell.main import main
from tests import every_question
from tests.every_question import IN_PYTHON, call_of, example, parser_of, shown
from tests.worlds import OSCILLATOR as DRAG

sys.path.insert(0, str(Path(__file__).parent))  # the module beside this one

from every_type import types

PAGE = (Path(__file__).parents[2] / "docs/parity.md").read_text()
CODE = re.compile(r"`([^`]+)`")


@cache
def sections():
    """Heading -> [(the options of a row, the Python of the row)]."""
    found: dict = {}
    for part in PAGE.split("\n## ")[1:]:
        title, _, body = part.partition("\n")
        rows = [line.strip("| ").split(" | ") for line in body.splitlines() if line.startswith("| `")]
        found[title.strip()] = [([c.split()[0] for c in CODE.findall(row[0])], row[1]) for row in rows]
    return found


def keywords_of(command):
    """The options that are keywords of the call of the same name: what the page says of all of them at its head."""
    own = () if call_of(command) is None else loaded(command).asked
    return {o.name if o.place else f"--{o.name}" for a in own if not a.kind.options for o in a.options}


@pytest.mark.parametrize("command", QUESTIONS)
def test_every_option_has_its_call(command):
    common = {o for row, _ in sections()["Options that mean the same everywhere"] for o in row}
    own = [o for row, _ in sections().get(command, ()) for o in row]
    there = {a.option_strings[-1] if a.option_strings else a.metavar for a in shown(command)}
    assert there - set(own) - common - keywords_of(command) == set()
    assert set(own) <= there and len(own) == len(set(own))


def test_an_option_without_a_call_is_noticed(monkeypatch):
    stray = argparse.ArgumentParser(add_help=False)
    stray.add_argument("--stray", metavar="S")
    monkeypatch.setattr(every_question, "parser_of", lambda name: stray)
    with pytest.raises(AssertionError):
        test_every_option_has_its_call("moment")


def calls(text):
    """(what is called, its keywords) of the Python of a row."""
    for code in CODE.findall(text):
        found = re.match(r"(\.?[A-Za-z_][\w.]*)(?:\((.*)\))?", code)
        if found and ("(" in code or "." in code) and not code.startswith(("svg", "{", '"')):
            yield found[1], re.findall(r"\b([a-z_0-9A-Z]+)=(?!=)", found[2] or "")


def resolved(name):
    """The things that a name of the page may be: a public one, a dotted path, or the method of any result."""
    if name.startswith("."):
        first = name[1:].split(".")[0]
        return [getattr(kind, first) for kind in types() if hasattr(kind, first)]
    module, _, last = name.rpartition(".")
    if name.startswith("asy."):
        return [getattr(asy, name[4:])]
    return [getattr(import_module(module), last)]


def accepts(function, keyword):
    parameters = inspect.signature(function).parameters
    return keyword in parameters or any(p.kind is p.VAR_KEYWORD for p in parameters.values())


def test_every_call_exists_with_its_keywords():
    seen = 0
    for title, rows in sections().items():
        for _, text in rows:
            for name, keywords in calls(text):
                if name in ("client.get_executor", ".points", ".to_csv"):
                    continue
                found = resolved(name)
                assert found, (title, name)
                assert any(all(accepts(f, k) for k in keywords) for f in found if callable(f)), (title, name, keywords)
                seen += 1
    assert seen > 60


def test_a_call_that_is_not_there_is_noticed():
    assert resolved(".no_such_method") == [] and not accepts(asy.moment, "p_value")
    with pytest.raises(AttributeError):
        resolved("asy.momentum")


SI = "--alpha 3/2 --damping 1/10 --mass 3/2 --stiffness 30 --x0 1/5"
PAIRS = {  # a line of the shell, where its answer is, and the same from Python
    f"expand {SI.removesuffix(' --x0 1/5')} --order 2 --digits 9": (
        "amplitude.1.value", lambda: asy.expand(DRAG, order=2, digits=9).p[1].value
    ),
    "expand --alpha 3 --order 2 --gauge averaging --exact": (
        "frequency.2.exact", lambda: asy.expand(3, order=2, gauge="averaging", exact=True).Omega[2].exact
    ),
    "expand --alpha 2 --order 3 --bound": ("bound.amplitude", lambda: asy.remainder(2, order=3).to_dict()["amplitude"]),
    "multiple-scales --alpha 3 --order 2 --map": ("map.A", lambda: str(asy.map_of_gauges(3, order=2)["A"])),
    "multiple-scales --alpha 2 --order 2 --start": (
        "start.psi(0)", lambda: str(asy.any_start(asy.multiple_scales(2, order=2))["psi(0)"])
    ),
    "papers smith2012:45 --check": ("agrees", lambda: asy.paper("smith2012:45").check()["agrees"]),
    "half-swing --alpha 2 --delta 1/5 --digits 9": (
        "amplitude.value", lambda: asy.half_swing(2, delta="1/5", digits=9).amplitude
    ),
    f"turning-points {SI} --count 2 --times --digits 9": (
        "points.1.t", lambda: asy.turning_points(DRAG, 2, times=True, digits=9).points[1].t
    ),
    f"motion {SI} --time 7 --order 2 --digits 9": ("x", lambda: asy.motion(DRAG, order=2).at(7, digits=9).x),
    f"motion {SI} --time 1 --reference --digits 9": ("x", lambda: asy.reference(DRAG).at(1, digits=9).x),
    f"envelope {SI} --time 7 --digits 9": ("amplitude", lambda: asy.envelope(DRAG).amplitude(7, digits=9)),
    "envelope --alpha 2 --epsilon 1/10 --squaring --time 3 --digits 9": (
        "amplitude", lambda: asy.envelope({2: "1/10"}, averaging="squaring").amplitude(3, digits=9)
    ),
    "solution --alpha 2 --epsilon 1/10 --order 2 --time 7 --digits 9": (
        "x_value", lambda: asy.solution({2: "1/10"}, order=2).at(7, digits=9).x
    ),
    "multiple-scales --law 1 --spring 3 --order 2": (
        "amplitude_rate", lambda: str(asy.multiple_scales(1, spring={3: 1}, order=2).amplitude_rate)
    ),
    "multiple-scales --alpha 5/2 --order 2 --phase 1 --digits 8": (
        "waves.1", lambda: asy.waveforms("5/2", order=2).at(1, digits=8)[1]
    ),
    "damping --alpha 2 --epsilon 1/10 --amplitudes 1/2 --digits 6": (
        "rows", lambda: asy.damping({2: "1/10"}, ["1/2"], digits=6).to_dict()["rows"]
    ),
    "smith f --n 7": ("coefficients.0", lambda: str(asy.f(7)[0])),
    "smith g --i 2": ("expression", lambda: asy.G(2).to_dict()["expression"]),
    "smith s --u 1/4 --w 1/4": ("value", lambda: asy.S("1/4", "1/4").value),
    "table smith2012.table1 --digits 6 --rounding up": (
        "rows.2.1", lambda: asy.table("smith2012.table1", digits=6, rounding="up").rows[2][1]
    ),
    "papers Lambert --verdict holds": ("entries.0.id", lambda: asy.statements(words="Lambert", verdict="holds")[0].id),
}  # fmt: skip


def at(data, path):
    for step in path.split("."):
        data = data[int(step)] if isinstance(data, list) else data[step]
    return data


@pytest.mark.parametrize("line", PAIRS)
def test_a_pair_says_the_same(line, capsys):
    path, python = PAIRS[line]
    assert main([*line.split(), "--json"]) == 0
    assert at(json.loads(capsys.readouterr().out), path) == python()


def test_the_commands_that_read_files_say_the_same(tmp_path, capsys):
    mine, decay = tmp_path / "mine.csv", tmp_path / "decay.csv"
    mine.write_text("n,x\n1,-0.4107197\n2,0.2635711\n")
    assert main(["compare", str(mine), "--alpha", "2", "--epsilon", "1", "--json"]) == 0
    rows = json.loads(capsys.readouterr().out)["rows"]
    same = asy.compare({"n": [1, 2], "x": [-0.4107197, 0.2635711]}, {2: 1}).to_dict()["rows"]
    assert [r.pop("line") for r in rows] == [2, 3] and [r.pop("line") for r in same] == [1, 2] and rows == same
    decay.write_text("n,x\n" + "".join(f"{n},{(-0.95) ** n!r}\n" for n in range(12)))
    assert main(["identify", str(decay), "--laws", "1", "2", "--no-bootstrap", "--json", "--quiet"]) in (0, 1)
    found = json.loads(capsys.readouterr().out)
    answer = asy.identify(decay, laws=["1", "2"], bootstrap=False)
    assert found["verdict"] == json.loads(json.dumps(answer.to_dict()))["verdict"]
    line = f"sweep moment --p 1,2 --digits 6 --store {tmp_path / 'a'} --quiet --workers 1"
    assert main(line.split()) == 0
    swept = asy.sweep_command("moment", {"p": "1,2", "digits": 6}, tmp_path / "a", workers=1)
    assert (swept.reused, swept.computed) == (2, 0)  # the shell's points are the same points


def in_python(options):
    """The law of the options, as Python says it: a mapping, an exponent alone, or an oscillator."""
    law = {
        tuple(t.split(":")[0].split(",")) if "," in t else t.split(":")[0]: t.split(":")[1] for t in options.law or ()
    }
    strength = getattr(options, "epsilon", None) or getattr(options, "damping", None)
    if options.alpha is not None:
        law = {options.alpha: strength} if strength else options.alpha
    units = {k: v for k in ("mass", "stiffness", "x0", "v0") if (v := getattr(options, k, None)) is not None}
    return asy.Oscillator(law, **units) if units or getattr(options, "damping", None) else law


@pytest.mark.parametrize("command", [n for n in IN_PYTHON if "{" not in loaded(n).example])
def test_the_example_says_the_same_from_python(command, capsys, tmp_path):
    """Each value as it was typed, under the name of its parameter."""
    words, question = example(command, tmp_path), loaded(command)
    options = parser_of(command).parse_args(words[1:])
    values = {a.name: getattr(options, a.name, None) for a in question.asked if not a.kind.options}
    given = {}
    for asked in question.asked:
        law = asked.kind.options and asked.name == "law" and (options.law or "alpha" not in values)
        typed = in_python(options) if law else values.get(asked.name)
        if typed not in (None, False, {}):
            given[asked.name] = typed
    assert main([*words, "--json"]) == 0
    told = json.loads(capsys.readouterr().out)
    same = json.loads(json.dumps(call_of(command)(**given).to_dict()))
    both = {name for name in same.keys() & told.keys() if name not in ("notes", "provenance")}
    assert both and {name: told[name] for name in both} == {name: same[name] for name in both}


def test_every_command_has_a_pair():
    paired = {line.split()[0] for line in PAIRS} | {"compare", "identify", "sweep"} | set(IN_PYTHON)
    assert paired == set(QUESTIONS)

"""Text that the library made, for people, is never read again inside it: a number goes on as the number that it is.

Read again, a text is refused where the reader knows less than the writer (SymPy writes sqrt(3/2) as sqrt(6)/2).  Two
looks: at the sources, for a reader that is handed a text made on the spot; and at calls whose arguments hold no text.
"""

import ast
from collections.abc import Iterable
from fractions import Fraction
from pathlib import Path

import pytest
import sympy

import asymptotics as asy
from asymptotics.numbers import exact
from tests.sources import below, nodes

ROOT = Path(__file__).parents[1]
FILES = sorted((ROOT / "asymptotics").rglob("*.py"))
READERS = {
    "parse_real", "parse_rational", "parse_printed", "parse_integer", "exact_number", "exact_integer", "exact_double",
    "exact_seconds", "time_of", "read_candidate", "Fraction", "Decimal", "Law", "PhysicalLaw", "Oscillator", "Term",
    "C", "G", "S", "T", "any_start", "damping", "envelope", "expand", "half_swing", "limit_cycle", "map_of_gauges",
    "moment", "motion", "multiple_scales", "radii", "reference", "remainder", "solution", "stokes", "turning_points",
    "waveforms",
}  # fmt: skip
MADE = {"str", "repr", "format", "latex", "sstr", "text", "exact", "nstr"}
TOLD = {
    "asymptotics/numbers/policy.py: parse_rational": "the text of a float is its value: the shortest decimal",
    "asymptotics/decays/comparison/units.py: Fraction": "the same",
    "asymptotics/decays/identification/certified_sets/table_rows.py: Fraction": "the same",
    "asymptotics/numbers/double_error.py: Fraction": "an error of two digits, which is what it prints",
    "asymptotics/present/percent.py: Decimal": "two digits of a share, which are what is printed, without an exponent",
    "asymptotics/curves/motion_table.py: Fraction": "a row is at the time that it prints",
    "asymptotics/testing/oracles.py: Fraction": "twenty decimals of the middle of a ball, for an oracle in doubles",
}


def _name(node: ast.AST) -> str:
    return getattr(node, "id", getattr(node, "attr", ""))


def _made(node: ast.AST, local: set[str]) -> bool:
    """Whether this is a text made on the spot: by a call, an f-string, ``.exact``, or a name that was given one."""
    if isinstance(node, ast.Call):
        return _name(node.func) in MADE and bool(node.args or _name(node.func) == "text")
    if isinstance(node, ast.IfExp):
        return _made(node.body, local) or _made(node.orelse, local)
    if isinstance(node, ast.Dict):
        return any(_made(part, local) for part in [*node.keys, *node.values] if part is not None)
    if isinstance(node, ast.List | ast.Tuple):
        return any(_made(part, local) for part in node.elts)
    return isinstance(node, ast.JoinedStr) or isinstance(node, ast.Attribute) and node.attr == "exact" or (
        isinstance(node, ast.Name) and node.id in local
    )  # fmt: skip


def read_again(parts: Iterable[ast.AST]) -> list[str]:
    """The readers that are handed a text of our own."""
    parts = list(parts)
    found = []
    for scope in [n for n in parts if isinstance(n, ast.FunctionDef)] or [ast.Module(parts, [])]:
        inner = below(scope)
        given = [n for n in inner if isinstance(n, ast.Assign) and _made(n.value, set())]
        local = {name.id for n in given for name in n.targets if isinstance(name, ast.Name)}
        calls = [n for n in inner if isinstance(n, ast.Call) and _name(n.func) in READERS]
        # The first argument is what is read; the others are names and texts for messages.
        found += [_name(n.func) for n in calls if n.args and _made(n.args[0], local)]
    return found


def test_no_reader_is_handed_a_text_of_our_own():
    found = {f"{p.relative_to(ROOT).as_posix()}: {name}" for p in FILES for name in read_again(nodes(p))}
    assert found == set(TOLD)


@pytest.mark.parametrize("text", [
    "waveforms(str(self.alpha), order=2)", "parse_real(str(alpha), 'alpha')", "Law({str(a): 1})", "expand(f'{p}/{q}')",
    "moment(c.exact)", "exact_number(c.text(), 'x')", "def f(x):\n    t = str(x)\n    return Fraction(t)",
])  # fmt: skip
def test_the_walk_finds_a_text_that_is_read_again(text: str):
    assert read_again(ast.walk(ast.parse(text)))


def test_what_a_user_typed_is_no_text_of_ours():
    typed = "parse_real(options.alpha, '--alpha'); parse_real(options.time, f'--{name}'); Fraction(int(q.p), int(q.q))"
    assert read_again(ast.walk(ast.parse(typed))) == []


# Numbers with one root, as Python gives them; SymPy writes the second as sqrt(6)/2, ExactReal as 1/2*sqrt(6).
HARD = [asy.ExactReal(1, 2, -1), sympy.sqrt(sympy.Rational(3, 2)), sympy.sqrt(8), 1 + sympy.sqrt(6) / 4]
TENTH = Fraction(1, 10)
CALLS = {
    "expand": lambda a: asy.expand(a, order=2).to_dict(),
    "solution": lambda a: asy.solution({a: TENTH}, order=2).at(1, digits=8),
    "waveforms of a solution": lambda a: asy.solution(a, order=3).waveforms.at(1, digits=8),
    "implicit solution": lambda a: asy.solution({a: TENTH, 3: TENTH}, order=2),
    "waveforms": lambda a: asy.waveforms(a, order=2).at(1, digits=8),
    "multiple scales": lambda a: str(asy.multiple_scales(a, order=2)),
    "table of moments": lambda a: asy.table("moments", alpha=a, digits=6),
    "table of turning points": lambda a: asy.table("turning-points", alpha=a, epsilon=TENTH, digits=6, rows=2),
    "turning points": lambda a: asy.turning_points({a: TENTH}, 2, digits=9).to_dict(),
    "envelope": lambda a: asy.envelope({a: TENTH}).to_dict(),
    "series": lambda a: asy.envelope({a: TENTH}).series(3).to_dict(),
    "half-swing": lambda a: asy.half_swing(a, order=2, digits=8).to_dict(),
    "damping": lambda a: asy.damping({a: TENTH}, 1, digits=5).to_dict(),
    "motion": lambda a: (asy.motion({a: TENTH}).at(1), asy.motion({a: TENTH}, order=1).bound(1)),
    "reference": lambda a: asy.reference({a: TENTH}).at(1, digits=5),
}


@pytest.mark.parametrize("name", CALLS)
def test_a_call_without_text_reads_none(name, monkeypatch):
    read = exact._fraction

    def watched(text, argument, accepted, form):
        assert form is exact._PRINTED, f"{text!r} is read as {argument}"  # decimals of ours have a reader of their own
        return read(text, argument, accepted, form)

    monkeypatch.setattr(exact, "_fraction", watched)
    for number in HARD:
        CALLS[name](number)


def test_the_watch_sees_what_is_read(monkeypatch):
    monkeypatch.setattr(exact, "_fraction", lambda text, *_: pytest.fail(text))
    with pytest.raises(pytest.fail.Exception, match="3/2"):
        asy.expand("3/2", order=2)

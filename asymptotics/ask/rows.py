r"""Rows of coefficients as the command line shows them: lines of text, lines of LaTeX, columns of CSV.

>>> from sympy import Rational
>>> row = {"1": Coefficient("0.50000", Rational(1, 2)), "3": Coefficient("-0.33333", Rational(-1, 3))}
>>> row_text("L", row)
['L_1  0.50000  = 1/2', 'L_3  -0.33333  = -1/3']
>>> rows_latex({"L": row}, (r"\delta",))
'L = \\frac{1}{2} \\delta - \\frac{1}{3} \\delta^{3}'
>>> rows_csv({"L": row})
'series,k,value,exact,code\nL,1,0.50000,1/2,sha256:...\nL,3,-0.33333,-1/3,sha256:...\n'
"""

from collections.abc import Mapping, Sequence
from typing import Any

from asymptotics.ask.forces import GivenTerms
from asymptotics.expansions.normal_form.results import Coefficient, Row
from asymptotics.expansions.normal_form.show import SHOWN_DIGITS, sum_latex
from asymptotics.present.inputs import csv_text

__all__ = [
    "Coefficient", "deltas_latex", "local_strengths", "order_of", "row_text", "rows_csv", "rows_latex",
    ]  # fmt: skip


def row_text(name: str, row: Row) -> list[str]:
    """One line for each coefficient: its digits, and its exact form if there is one."""
    entries: list[tuple[str, Any]] = [(f"{name}_{key}", c) for key, c in row.items()]
    width = max((len(label) for label, _ in entries), default=0)
    # "0 = 0" tells nothing.
    shown = {label: f"  = {c.exact}" for label, c in entries if c.exact and c.value != "0"}
    return [f"{label:{width}}  {c.value}" + shown.get(label, "") for label, c in entries]


def rows_latex(rows: Mapping[str, Row], variables: Sequence[str], digits: int = SHOWN_DIGITS) -> str:
    """One line of LaTeX for each row: its name, and the series in ``variables``."""
    lines = []
    for name, row in rows.items():
        keyed = {tuple(int(n) for n in key.split(",")): c for key, c in row.items()}
        lines.append(f"{name} = {sum_latex(keyed, variables, digits=digits)}")
    return " \\\\\n".join(lines)


def rows_csv(rows: Mapping[str, Row]) -> str:
    """All coefficients as CSV: series, powers of the variables, digits, exact form."""
    lines = [(name, key, c.value, c.exact) for name, row in rows.items() for key, c in row.items()]
    return csv_text(["series", "k", "value", "exact"], lines)


def deltas_latex(given: GivenTerms) -> tuple[str, ...]:
    """The local strengths as LaTeX, in the order of the indices."""
    count = len(given.terms)
    return (r"\delta",) if count == 1 else tuple(rf"\delta_{{{i}}}" for i in range(1, count + 1))


def order_of(given: GivenTerms) -> list[str]:
    """What the indices of the coefficients count, unless all forces are powers of the velocity."""
    plain = all(t.is_power_of_velocity for t in given.terms)
    names = (f"{t.shape()}, in A^2" if t.family else t.shape() for t in given.terms)
    return [] if plain else [f"indices count {'; '.join(names)}"]


def local_strengths(given: GivenTerms) -> list[tuple[str, str, str]]:
    """(name, force, value) of each delta = epsilon A^(alpha-1); the letter epsilon where no strength was given."""
    known, deltas = given.known, []
    for i, term in enumerate(given.terms, start=1):
        mark = "" if len(given.terms) == 1 else f"_{i}"
        # A pendulum has no strength of its own: its variable is A^2 in rad^2.
        strength = str(term.strength) if known and not term.family else f"epsilon{mark}"
        deltas.append((f"delta{mark}", term.shape(), "A^2" if term.family else strength + _power(str(term.weight))))
    return deltas


def delta_meaning(deltas: Sequence[tuple[str, str, str]]) -> dict[str, str]:
    """What the page says of the letter delta, of each force its own.

    >>> delta_meaning([("delta_1", "x'|x'|", "epsilon_1 A"), ("delta_2", "(sin x - x)", "A^2")])
    {'\\\\delta': "local strength: delta_1 = epsilon_1 A of x'|x'|, delta_2 = A^2 of (sin x - x)"}
    """
    each = ", ".join(f"{name} = {value} of {force}" for name, force, value in deltas)
    return {r"\delta": f"local strength: {each}"}


def _power(weight: str) -> str:
    """A to a power, as it is written."""
    return {"0": "", "1": " A"}.get(weight, f" A^{weight}" if weight.isdigit() else f" A^({weight})")

"""What a table is asked for: exponents, laws, strengths, how many rows.

>>> Inputs.of(alphas=["3/2"], epsilons=["1/10"]).laws_or(())[0]
Law(1/10 x'|x'|^(1/2))
"""

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import product
from typing import Any

from asymptotics.errors import InputError, LimitError
from asymptotics.law import Law, Oscillator
from asymptotics.numbers.exact import ExactReal, parse_real
from asymptotics.numbers.policy import Number, exact_number
from asymptotics.terms import Term

# Refusals: a table is made in memory and read by people.  MAX_CELLS is for tables whose rows grow with their number.
MAX_ROWS, MAX_ALPHA, MAX_CELLS = 100_000, 1000, 1_000_000
GRID = ("0", "1/2", "1", "3/2", "2", "5/2", "3", "4")
# Sums in measured decays: friction and viscous drag, viscous and quadratic or cubic drag, all three.
SUMS = ((0, 1), (1, 2), (1, 3), (0, 1, 2))


@dataclass(frozen=True)
class Inputs:
    """``alphas``, ``law`` (one sum) and ``epsilons`` as given, empty or None where the table's own defaults rule."""

    alphas: tuple[ExactReal, ...] = ()
    law: Law | None = None
    epsilons: tuple[ExactReal, ...] = ()
    rows: int | None = None

    @classmethod
    def of(
        cls,
        alphas: Sequence[Number] = (),
        law: Law | None = None,
        epsilons: Sequence[Number] = (),
        rows: int | None = None,
    ) -> "Inputs":
        """From numbers; InputError for exponents outside [0, 1000], strengths <= 0 and rows outside [1, 10^5]."""
        exponents = tuple(exact_number(a, "alpha") for a in alphas)
        for a in exponents:
            if a < 0 or a > MAX_ALPHA:
                raise InputError("alpha", f"{a} is out of range", f"exponents from 0 to {MAX_ALPHA}")
        strengths = tuple(exact_number(e, "epsilon") for e in epsilons)
        for e in strengths:
            if not e > 0:
                raise InputError("epsilon", f"{e} is not positive", "strengths > 0")
        if law is not None and (exponents or strengths):
            raise InputError("law", "it stands next to alpha or epsilon", "one or the other")
        if rows is not None and not 1 <= rows <= MAX_ROWS:
            raise InputError("rows", f"{rows} is out of range", f"an integer from 1 to {MAX_ROWS}")
        return cls(exponents, law, strengths, rows)

    @classmethod
    def read(cls, alpha: Any = None, epsilon: Any = None, law: Any = None, rows: int | None = None) -> "Inputs":
        """From numbers or lists of them, and one law, mapping or oscillator; InputError by name."""
        made = law.dimensionless if isinstance(law, Oscillator) else None if law is None else Law.read(law)
        return cls.of(_several(alpha), made, _several(epsilon), rows)

    def alphas_or(self, default: Sequence[str]) -> tuple[ExactReal, ...]:
        """The exponents asked for, or the default ones."""
        if self.law is not None:
            return self.law.alphas
        return self.alphas or tuple(parse_real(a, "alpha") for a in default)

    def epsilons_or(self, *default: str) -> tuple[ExactReal, ...]:
        """The strengths asked for, or the default ones."""
        return self.epsilons or tuple(parse_real(e, "epsilon") for e in default)

    def laws_or(self, sums: Sequence[Sequence[int]], epsilons: Sequence[str] = ("1/10",)) -> list[Law]:
        """The law asked for; or each exponent with each strength, and the default sums where nothing was asked for."""
        if self.law is not None:
            return [self.law]
        strengths = self.epsilons_or(*epsilons)
        laws = [Law({a: e}) for a, e in product(self.alphas_or(GRID), strengths)]
        # Whoever asks for exponents wants those alone; the default table has the sums as well.
        if self.alphas:
            return laws
        return laws + [Law({Fraction(a): e for a in exponents}) for exponents in sums for e in strengths]

    def count(self, default: int, per_row: int = 1) -> int:
        """The number of rows asked for; LimitError when all of them would be too many."""
        rows = default if self.rows is None else self.rows
        if rows * per_row > MAX_CELLS:
            raise LimitError("rows", f"{rows} times {per_row} rows are too many", f"at most {MAX_CELLS} in one table")
        return rows

    def to_dict(self) -> dict[str, Any]:
        """JSON-ready, for the provenance."""
        return {
            "alpha": [str(a) for a in self.alphas],
            "law": None if self.law is None else label(self.law),
            "epsilon": [str(e) for e in self.epsilons],
            "rows": self.rows,
        }


def label(law: Law) -> str:
    """A law as the command line writes it: 0:1/10,1:1/10, and 1,2:1/10 for x^2 x'; a spring beside it in words.

    >>> label(Law({0: "1/50", (1, 2): "1/10"}))
    '0:1/50,1,2:1/10'
    """
    return ",".join(map(_term, law.terms))


def _term(term: Term) -> str:
    if term.is_power_of_velocity:
        return f"{term.velocity}:{term.strength}"
    if term.odd_in == "velocity":
        return f"{term.velocity},{term.position}:{term.strength}"
    return f"spring {term.shape()}:{term.strength}"


def terms_of_label(text: str) -> tuple[str, ...]:
    """The terms of a label; a piece without a colon belongs to the next one.

    >>> terms_of_label("0:1/50,1,2:1/10")
    ('0:1/50', '1,2:1/10')
    """
    found, begun = list[str](), list[str]()
    for piece in text.split(","):
        begun.append(piece)
        if ":" in piece:
            found.append(",".join(begun))
            begun = []
    return (*found, *([",".join(begun)] if begun else []))


def _several(given: Any) -> Sequence[Any]:
    """One number or several."""
    return given if isinstance(given, list | tuple) else () if given is None else (given,)

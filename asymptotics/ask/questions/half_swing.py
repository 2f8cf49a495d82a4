"""The map from one turning point to the next, its duration and its flow, as series."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from importlib import import_module
from typing import TYPE_CHECKING, Annotated, Any, cast

from asymptotics.ask.answers import Offers, Request
from asymptotics.ask.forces import GivenTerms
from asymptotics.ask.kinds import FLAG, REALS, SECONDS, digits, whole
from asymptotics.ask.laws import SYMBOLIC, TERMS
from asymptotics.ask.pairs import excludes
from asymptotics.ask.question import question
from asymptotics.ask.rows import delta_meaning, deltas_latex, local_strengths, order_of, row_text, rows_csv, rows_latex
from asymptotics.errors import InputError
from asymptotics.expansions.half_swings.half_swing_value import HalfSwingAt
from asymptotics.expansions.normal_form.coefficients import half_swing_coefficients
from asymptotics.expansions.normal_form.results import Coefficient, HalfSwingCoefficients, Row, row_to_dict
from asymptotics.law import LawLike, SpringLike
from asymptotics.numbers.policy import Number
from asymptotics.present.inputs import csv_text
from asymptotics.turning.half_swing import half_swing_of_terms

if TYPE_CHECKING:
    from sympy import Expr

# As ``expand`` has them: the work is estimated from order and exponents before it begins, and refused by that.
MAX_ORDER, MAX_DIGITS = 200, 1000


@dataclass(frozen=True)
class SymbolicHalfSwing:
    """L, F and T of one law with a symbolic exponent, in closed form through ``order``; keys are powers of delta."""

    order: int
    log_ratio: "dict[int, Expr]"
    map: "dict[int, Expr]"
    duration: "dict[int, Expr]"

    @classmethod
    def through(cls, order: int) -> "SymbolicHalfSwing":
        """The closed forms; InputError beyond the order to which they are known."""
        # SymPy, which takes longer to load than the series for a number takes.
        symbolic = import_module("asymptotics.expansions.half_swings.symbolic")
        if order > symbolic.ORDER:  # the coefficients in alpha hold nested integrals without a closed form
            raise InputError("order", f"{order} is out of range", f"an integer from 1 to {symbolic.ORDER}")
        half = symbolic.symbolic_half_swing()
        return cls(order, *({k: s[k] for k in range(order + 1) if s[k] != 0} for s in (half.L, half.F[0], half.T)))

    def _entries(self) -> "list[tuple[str, int, Expr]]":
        rows = {"L": self.log_ratio, "F": self.map, "T": self.duration}
        return [(name, k, c) for name, row in rows.items() for k, c in row.items()]

    def __str__(self) -> str:
        return "\n".join(["symbolic", *(f"{name}_{k} = {c}" for name, k, c in self._entries())])

    def latex(self) -> str:
        """One line a coefficient."""
        return " \\\\\n".join(f"{name}_{{{k}}} = {Coefficient(None, c)._formula()}" for name, k, c in self._entries())

    def to_dict(self) -> dict[str, Any]:
        """JSON-ready."""
        named = {"log_ratio": self.log_ratio, "map": self.map, "duration": self.duration}
        rows = {n: row_to_dict({str(k): Coefficient(None, c) for k, c in row.items()}) for n, row in named.items()}
        return {"alpha": SYMBOLIC, "order": self.order, "arithmetic": "symbolic"} | rows


Found = HalfSwingCoefficients | HalfSwingAt | SymbolicHalfSwing
_NUMBERS = {"A'/A": "amplitude", "L": "log_ratio", "T": "duration"}


def _named(found: HalfSwingCoefficients, given: GivenTerms) -> dict[str, Row]:
    """The rows by name: F and V have a component for each force, L, T, U and W are common to all."""
    rows = {"L": found.log_ratio, "T": found.duration, "U": found.U, "W": found.W}
    suffixes = [""] if len(given.terms) == 1 else [f"[{name}]" for name in given.names]
    components = {"F": found.map, "V": found.V}
    return rows | {f"{n}{s}": row for n, several in components.items() for s, row in zip(suffixes, several)}


def _values(found: HalfSwingAt) -> list[tuple[str, ...]]:
    return [(shown, getattr(found, name), *found.enclosures[name]) for shown, name in _NUMBERS.items()]


def _data(found: Found, request: Request) -> dict[str, Any]:
    data = found.to_dict()
    if isinstance(found, SymbolicHalfSwing):
        return data
    given = request["law"]
    if isinstance(found, HalfSwingCoefficients):
        data = {"alpha": given.shown, "terms": given.to_list(), **data, "notes": list(given.notes)}
        data["delta"] = [{"name": name, "force": f, "value": value} for name, f, value in local_strengths(given)]
    return data | {"notes": list(given.notes)}


def _text(found: Found, request: Request) -> str:
    if isinstance(found, SymbolicHalfSwing):
        return str(found)
    given = request["law"]
    if isinstance(found, HalfSwingAt):
        lines = [f"{row[0]:5} {row[1]}" for row in _values(found)]
        route = f"{found.route}, {found.terms} terms, tail {found.tail}"
        return "\n".join([*lines, f"certified: {str(found.certified).lower()} ({route})", *given.notes])
    lines = [f"turning-point gauge, {found.arithmetic}", *order_of(given)]
    lines += [f"{name} = {value} for {force}" for name, force, value in local_strengths(given) if given.known]
    lines += [line for name, row in _named(found, given).items() for line in row_text(name, row)]
    return "\n".join([*lines, *given.notes])


def _latex(found: Found, request: Request) -> str:
    if isinstance(found, SymbolicHalfSwing):
        return found.latex()
    if isinstance(found, HalfSwingAt):
        return ",\\quad ".join(f"{row[0]} = {row[1]}" for row in _values(found))
    given = request["law"]
    rows = {_index(name, given): row for name, row in _named(found, given).items()}
    return rows_latex(rows, deltas_latex(given), request["digits"])


def _index(name: str, given: GivenTerms) -> str:
    """F[x'|x'|] as LaTeX: F_{1}, by the place of the force."""
    letter, bracket, force = name.partition("[")
    return letter + (f"_{{{given.names.index(force[:-1]) + 1}}}" if bracket else "")


def _letters(_: Found, request: Request) -> dict[str, str]:
    given = request["law"]
    return {} if given == SYMBOLIC else delta_meaning(local_strengths(given))


def _csv(found: Found, request: Request) -> str:
    if isinstance(found, HalfSwingAt):
        return csv_text(["quantity", "value", "low", "high"], _values(found))
    return rows_csv(_named(cast("HalfSwingCoefficients", found), request["law"]))


@question(
    Offers(
        latex="print the series, or the numbers, as LaTeX",
        picture="A'/A against the local strength",
        table="the coefficients, or the numbers: name, powers, digits, exact form",
        from_rest=True,
        data=_data,
        text=_text,
        as_latex=_latex,
        as_csv=_csv,
        letters=_letters,
        lacks={
            "gauge": "U, V, W are in the turning-point gauge, L, F, T the same in all; `expand --gauge` has the others",
            "points": "there is no curve",
        },
    ),
    pairs=(
        excludes(
            "csv epsilon exact delta",
            "alpha=symbolic",
            "cannot be combined with a symbolic exponent",
            "one law, in closed form",
        ),
        excludes("epsilon", "delta", accepted="--delta alone: the local strength"),
        excludes("plot", "delta", "one half-swing is no curve", "--plot without --delta: A'/A against delta"),
        excludes("exact", "delta", accepted="--delta alone: certified digits"),
        excludes("order", "delta", "a number at a strength is no series", "--delta alone: certified digits"),
    ),
    swept=True,
    example="--alpha 2 --order 1 --digits 5",
    rests="the same formal series: whole exponents exact, others in balls",
)
def half_swing(
    law: Annotated[LawLike, TERMS],
    *,
    order: Annotated[int, whole(1, MAX_ORDER)] = 4,
    digits: Annotated[int, digits(MAX_DIGITS)] = 30,
    delta: Annotated[Number | Sequence[Number] | None, REALS] = None,
    spring: SpringLike | None = None,
    exact: Annotated[bool, FLAG] = False,
    max_seconds: Annotated[Number, SECONDS] = 60,
) -> HalfSwingCoefficients | HalfSwingAt:
    """The half-swing from one turning point to the next as power series in delta = epsilon A^(alpha-1):

    log_ratio L = ln(A'/A),  map F: delta -> delta',  duration T,  and the smooth flow that interpolates them,
    U = d ln A/dpsi,  V = d delta/dpsi,  W = dtau/dpsi  (turning-point gauge).

      asymptotics half-swing --alpha 3/2 --order 6 --digits 40
      asymptotics half-swing --alpha 3/2 --spring 3 --order 4
      asymptotics half-swing --alpha symbolic --order 2

    With --delta, the numbers at that local strength instead: A'/A, L and T, certified, with the enclosure, the route,
    the number of terms and the tail; a sum takes one strength for each law, then one for each spring (A^2 for a
    pendulum).

      asymptotics half-swing --alpha 3/2 --delta 1/5 --digits 30
      asymptotics half-swing --law 1 --law 2 --delta 1/50,1/40
      asymptotics half-swing --alpha 3/2 --spring pendulum --delta 1/10,4

    Parameters
    ----------
    law
        an exponent (the coefficients need no strength), several, or a law, as in ``expand``
    order
        the highest power of delta
    digits
        significant digits, correctly rounded
    delta
        the number at this local strength instead of the series; a sum: D_1,D_2,... laws, then springs
    spring
        springs beside the linear one (those of the law in the shell)
    exact
        demand exact coefficients (integer exponents)
    max_seconds
        the time the request may take, in seconds

    Raises
    ------
    InputError
        for what cannot be read, or combined
    LimitError
        with the estimate
    UndecidedError
        where balls cannot decide

    Examples
    --------
    >>> series = half_swing(2, order=3)
    >>> series.log_ratio["1"].exact, series.duration["2"].exact
    ('-4/3', 'pi/6')
    >>> at = half_swing("3/2", delta="1/10", digits=12)
    >>> at.amplitude, at.certified
    ('0.870193291989', True)
    """
    given: Any = law
    if given == SYMBOLIC:
        return cast("HalfSwingCoefficients", SymbolicHalfSwing.through(order))
    if delta is not None:
        found = half_swing_of_terms(given.terms, cast("Sequence[Any]", delta), digits)
        return replace(found, notes=given.notes)
    # The coefficients depend on the exponents alone: strengths that were given with the law are not used.
    series = half_swing_coefficients(given.terms, order, digits, exact_only=exact)
    return replace(series, notes=given.notes)

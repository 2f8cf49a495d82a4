"""Coefficients as text: certified decimals, and the exact form where there is one, for any exponents and any gauge.

Integer exponents are computed exactly (``half_swings.exact``), all others in balls (``half_swings.certified``).  For
these the lowest coefficients have closed forms in moments (``expansions.normal_form.symbolic``), reported beside them.

>>> from asymptotics.numbers import parse_real
>>> found = expansion_coefficients([parse_real("2", "alpha")], 2, 12)
>>> found.amplitude, found.frequency
({'1': Coefficient(value='0.424413181578', expression=4/(3*pi))},
 {'2': Coefficient(value='-0.166666666667', expression=-1/6)})
>>> found = expansion_coefficients([parse_real("3/2", "alpha")], 2, 12)
>>> found.frequency["2"]
Coefficient(value='-0.152788745368', expression=-12/(25*pi))
"""

from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import partial
from math import inf
from typing import Any

from asymptotics.errors import InputError
from asymptotics.expansions.half_swings.certified import quarter_swing
from asymptotics.expansions.half_swings.exact import exact_half_swing
from asymptotics.expansions.half_swings.forces import Forces, Given
from asymptotics.expansions.half_swings.pi_decimals import exact_coefficient, exact_decimal, pi_number
from asymptotics.expansions.half_swings.pi_ring import PiNumber
from asymptotics.expansions.normal_form.digits import certified_digits, round_all
from asymptotics.expansions.normal_form.expansion import (
    MAX_SECONDS,
    estimated_seconds,
    exact_expansion,
    expansion_of,
    require_size,
)
from asymptotics.expansions.normal_form.flow import flow_of
from asymptotics.expansions.normal_form.half_swing_forms import half_swing_forms
from asymptotics.expansions.normal_form.in_moments import closed_forms
from asymptotics.expansions.normal_form.results import ZERO, Coefficient, Coefficients, HalfSwingCoefficients, Row
from asymptotics.gauges import TURNING_POINT, require_gauge
from asymptotics.numbers.decimals import MAX_DIGITS, rational_decimal
from asymptotics.numbers.exact import MAX_ORDER
from asymptotics.numbers.integers import require_integer
from asymptotics.numbers.rationals import to_fraction
from asymptotics.numbers.value import as_rational
from asymptotics.running.budget import budget, seconds_left
from asymptotics.series import Key, Series, monomials
from asymptotics.terms import Term

_Pairs = list[tuple[Key, Any]]
_Known = dict[str, dict[Key, Any]]
_Exact = dict[str, dict[Key, PiNumber]]
_RowsOf = Callable[[Forces, list[int]], dict[str, _Pairs]]


def expansion_coefficients(
    given: Given,
    order: int,
    digits: int,
    gauge: str = TURNING_POINT,
    *,
    exact_only: bool = False,
    max_seconds: float = MAX_SECONDS,
) -> Coefficients:
    """p_k and Omega_k of one law or a sum, in any gauge.

    Raises InputError for bad exponents, or with ``exact_only`` where no exact form exists; LimitError where all passes
    together would take or take more than ``max_seconds``; UndecidedError for a coefficient that balls cannot round.
    """
    require_gauge(gauge)
    _require_counts(order, digits)
    with budget(max_seconds):
        return _coefficients(Forces.read(given, order), order, digits, gauge, exact_only)


def _coefficients(forces: Forces, order: int, digits: int, gauge: str, exact_only: bool) -> Coefficients:
    if _is_exact(forces, order, gauge, exact_only):
        expansion = exact_expansion(forces, order, gauge, max_seconds=inf)
        p, Omega = (_exact_row(s, digits) for s in (expansion.p, expansion.Omega))
        return _expansion(gauge, order, "exact", forces, p, Omega)
    exact = _integer_part(forces, order, gauge, partial(_flow_rows, gauge, order))
    known = _with_exact(closed_forms(forces, order, gauge), exact)
    decided = _decided(known, exact, digits)
    # The theorems on zeros hold at turning points. Elsewhere parity alone is known, and a coefficient that vanishes for
    # another reason is refused as undecided.
    if gauge == TURNING_POINT:
        rounded = certified_digits(forces, order, digits, names=("p", "Omega"), known=decided)
    else:
        rounded = round_all(partial(_in_gauge, forces, order, gauge), digits, 4 * order + 32, decided, forces)
    p, Omega = (_rounded_row(rounded[name], known[name]) for name in ("p", "Omega"))
    return _expansion(gauge, order, "certified", forces, p, Omega)


def _require_counts(order: int, digits: int) -> None:
    require_integer(order, "order", 1, MAX_ORDER)
    require_integer(digits, "digits", 1, MAX_DIGITS)


def _expansion(gauge: str, order: int, arithmetic: str, forces: Forces, p: Row, Omega: Row) -> Coefficients:
    """All p_k of odd and Omega_k of even loss degree in their order, absent ones as the zeros they are."""
    names = ([_name(key) for key in _keys(forces, order, parity)] for parity in (1, 0))
    amplitude, frequency = ({key: row.get(key, ZERO) for key in keys} for row, keys in zip((p, Omega), names))
    return Coefficients(gauge, order, arithmetic, amplitude, frequency)


def _keys(forces: Forces, order: int, parity: int) -> list[Key]:
    """The monomials of degree 1 ... ``order`` whose loss degree has the parity."""
    keys = (key for degree in range(1, order + 1) for key in monomials(forces.variables, degree))
    return [key for key in keys if forces.loss_degree(key) % 2 == parity]


def half_swing_coefficients(
    given: Given,
    order: int,
    digits: int,
    *,
    exact_only: bool = False,
    max_seconds: float = MAX_SECONDS,
) -> HalfSwingCoefficients:
    """L, F, T, U, V, W through delta^order of one law or a sum; errors as ``expansion_coefficients``."""
    _require_counts(order, digits)
    with budget(max_seconds):
        found = _half_swing_coefficients(Forces.read(given, order), order, digits, exact_only)
    # Forces have no words for their terms.
    if isinstance(given, Forces):
        return found
    return replace(found, forces=tuple(t.shape() if isinstance(t, Term) else f"alpha = {t}" for t in given))


def _half_swing_coefficients(forces: Forces, order: int, digits: int, exact_only: bool) -> HalfSwingCoefficients:
    if _is_exact(forces, order, TURNING_POINT, exact_only):
        half = exact_half_swing(forces, order)
        flow = flow_of(half)
        rows = [_exact_row(s, digits) for s in (half.L, half.T, flow.U, flow.W, *half.F, *flow.V)]
        return _half_swing(order, "exact", forces.variables, rows)
    exact = _integer_part(forces, order, TURNING_POINT, partial(_half_swing_rows, order))
    known = _with_exact(half_swing_forms(forces), exact)
    names = ["L", "T", "U", "W", *(f"{name}_{i}" for name in "FV" for i in range(forces.variables))]
    rounded = certified_digits(forces, order, digits, names=names, known=_decided(known, exact, digits))
    rows = [_rounded_row(rounded[n], known.get(n, {})) for n in names]
    return _half_swing(order, "certified", forces.variables, rows)


def _half_swing(order: int, arithmetic: str, laws: int, rows: list[Row]) -> HalfSwingCoefficients:
    L, T, U, W, *rest = rows
    return HalfSwingCoefficients(order, arithmetic, L, tuple(rest[:laws]), T, U, tuple(rest[laws:]), W)


def _is_exact(forces: Forces, order: int, gauge: str, exact_only: bool) -> bool:
    """Whether the exact engine is to be used: integers, and not too much work (or no other choice)."""
    if not forces.is_integer:
        if exact_only:
            raise InputError("exact", "there are no exact coefficients at this order", "integer exponents")
        return False
    # No other engine can serve, so the whole of the time is its own; else half of it is kept for the balls.
    if exact_only:
        require_size(forces, order, gauge, seconds_left())
        return True
    return _is_quick(forces, order, gauge)


def _is_quick(forces: Forces, order: int, gauge: str) -> bool:
    """Whether the exact engine leaves at least half of the time for the other one."""
    # Where exact numbers take longer than that, the balls still have time to answer.
    return estimated_seconds(forces, order, gauge) <= seconds_left() / 2


def _integer_part(forces: Forces, order: int, gauge: str, rows_of: _RowsOf) -> dict[str, dict[Key, PiNumber]]:
    """The coefficients that involve only the forces with integer exponents: those of their own sum, exactly.

    What no ball can tell from a tie is known by them.  ``rows_of`` makes the rows of that sum.
    """
    # In a monomial of these variables no other force occurs: its coefficient is the one of their own sum.
    places = [i for i, v in enumerate(forces.velocities) if v.is_integer]
    part = forces.only(places, order)
    if not places or not _is_quick(part, order, gauge):
        return {}
    return {
        name: {forces.embedded(key, places): pi_number(c) for key, c in row}
        for name, row in rows_of(part, places).items()
    }


def _with_exact(known: _Known, exact: _Exact) -> _Known:
    """The closed forms with those that involve integer exponents alone."""
    return {name: row | {key: c.closed() for key, c in exact.get(name, {}).items()} for name, row in known.items()}


def _decided(known: _Known, exact: _Exact, digits: int) -> dict[str, dict[Key, str]]:
    """The decimals that need no balls: a tie or a zero among them would stop these at every precision."""
    found: dict[str, dict[Key, str]] = {}
    for name, row in known.items():
        rationals = {key: q for key, c in row.items() if (q := as_rational(c)) is not None}
        found[name] = {key: rational_decimal(to_fraction(q), digits) for key, q in rationals.items()}
        found[name] |= {key: exact_decimal(c, digits) for key, c in exact.get(name, {}).items()}
    return found


def _flow_rows(gauge: str, order: int, part: Forces, _places: list[int]) -> dict[str, _Pairs]:
    """p and Omega, with their zeros."""
    expansion = exact_expansion(part, order, gauge)
    rows = (("p", expansion.p, 1), ("Omega", expansion.Omega, 0))
    return {name: [(key, series[key]) for key in _keys(part, order, parity)] for name, series, parity in rows}


def _half_swing_rows(order: int, part: Forces, places: list[int]) -> dict[str, _Pairs]:
    """L, T, U, W, F_i and V_i."""
    half = exact_half_swing(part, order)
    flow = flow_of(half)
    series = {"L": half.L, "T": half.T, "U": flow.U, "W": flow.W}
    series |= {f"F_{i}": f for i, f in zip(places, half.F)} | {f"V_{i}": v for i, v in zip(places, flow.V)}
    return {name: [pair for of_degree in one.parts for pair in of_degree] for name, one in series.items()}


def _in_gauge(forces: Forces, order: int, gauge: str) -> Mapping[str, Series]:
    quarter = quarter_swing(forces, order, moments=True)
    expansion = expansion_of(quarter, gauge, arithmetic="certified")
    return {"p": expansion.p, "Omega": expansion.Omega}


def _exact_row(series: Series, digits: int) -> Row:
    row = {}
    for part in series.parts:
        for key, c in part:
            row[_name(key)] = exact_coefficient(c, digits)
    return row


def _rounded_row(row: Mapping[Key, str], known: Mapping[Key, Any]) -> Row:
    # "0" is told by a theorem, whatever form stands beside it.
    return {_name(key): ZERO if text == "0" else Coefficient(text, known.get(key)) for key, text in row.items()}


def _name(key: Key) -> str:
    return ",".join(map(str, key))

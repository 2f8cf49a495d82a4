"""The classical derivation, order by order, in text or LaTeX."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from importlib import import_module
from typing import Annotated, Any

import sympy

from asymptotics.ask.answers import Offers, Request
from asymptotics.ask.forces import GivenTerms, law_pairs
from asymptotics.ask.kinds import FLAG, REAL, SECONDS, choice, digits, whole
from asymptotics.ask.laws import TERMS_IN_UNITS, TermsInUnits, law_options
from asymptotics.ask.pairs import excludes
from asymptotics.ask.question import question
from asymptotics.errors import InputError
from asymptotics.expansions.multiple_scales.by_sympy import Ansatz, ansatz
from asymptotics.expansions.multiple_scales.hierarchy import (
    MAX_OPEN_ORDER,
    MAX_ORDER,
    any_start,
    map_of_gauges,
    multiple_scales,
    ordered,
    symbolic_multiple_scales,
)
from asymptotics.expansions.multiple_scales.orders import Order
from asymptotics.expansions.multiple_scales.symbolic import MultipleScales
from asymptotics.gauges import GAUGES, TURNING_POINT
from asymptotics.law import Law, LawLike
from asymptotics.numbers.policy import Number

MAX_DIGITS = 300
_LAW = replace(
    TERMS_IN_UNITS,
    pairs=law_pairs("epsilon"),
    options=law_options("its strength, told with the result: the derivation holds for every strength"),
)


@dataclass(frozen=True)
class Derived:
    """The hierarchy, the strengths that were given by their letters, and what was asked besides."""

    scales: MultipleScales
    strengths: Mapping[str, str]
    start: Mapping[str, sympy.Expr] | None = None
    map: Mapping[str, sympy.Expr] | None = None
    waves: Mapping[str, str] | None = None
    by_sympy: Ansatz | None = None

    @property
    def differences(self) -> tuple[str, ...]:
        """Where SymPy's own expansion differs from that of the rings: nowhere, or the terms."""
        if self.by_sympy is None:
            return ()
        solutions = tuple(one.solution.rhs for one in self.scales.orders if one.solution is not None)
        return self.by_sympy.differences(solutions, self.scales.rates)

    @property
    def rates(self) -> dict[str, sympy.Expr]:
        """da/dtau and dpsi/dtau."""
        return {"amplitude_rate": self.scales.amplitude_rate, "phase_rate": self.scales.phase_rate}

    def latex(self) -> str:
        """Each order, then the rates, one display each."""
        amplitude, phase = (sympy.latex(rate) for rate in self.rates.values())
        rows = [rf"\frac{{da}}{{d\tau}} = {amplitude}", rf"\frac{{d\psi}}{{d\tau}} = {phase}"]
        return "\n".join(rf"\[ {line} \]" for line in (*(one._formula() for one in self.scales.orders), *rows))


def _order(one: Order) -> dict[str, Any]:
    """One order as JSON data: SymPy-readable text."""
    return {
        "n": one.n,
        "hierarchy": f"{one.hierarchy.lhs} = {one.hierarchy.rhs}",
        "equation": f"{one.equation.lhs} = {one.equation.rhs}",
        "conditions": [f"{c} = 0" for _, c in one.conditions],
        "solvability": [f"{e.lhs} = {e.rhs}" for e in one.solvability],
        "solution": None if one.solution is None else str(one.solution.rhs),
        "where": [f"{e.lhs} = {e.rhs}" for e in one.where],
    }


def _data(found: Derived, request: Request) -> dict[str, Any]:
    scales = found.scales
    start = {"initial_amplitude": scales.initial_amplitude, "initial_phase": scales.initial_phase}
    data = {
        "order": request["order"],
        "gauge": scales.gauge,
        **{name: str(rate) for name, rate in (found.rates | start).items()},
        "strengths": dict(found.strengths),
        "orders": [_order(one) for one in scales.orders],
    }
    # Written only where it is shown: a high order has terms by the thousand.
    if request.typed("json") or request.typed("latex"):
        data["latex"] = found.latex()
    data |= {} if found.start is None else {"start": {name: str(e) for name, e in found.start.items()}}
    data |= {} if found.map is None else {"map": {name: str(e) for name, e in found.map.items()}}
    if found.by_sympy is not None:
        data |= {"engine": "sympy", "equal": not found.differences, "differences": list(found.differences)}
    return data | ({} if found.waves is None else {"phase": str(request["phase"]), "waves": dict(found.waves)})


def _text(found: Derived, request: Request) -> str:
    scales = found.scales
    lines = [*map(str, scales.orders), f"da/dtau = {scales.amplitude_rate}", f"dpsi/dtau = {scales.phase_rate}"]
    lines.append(f"start at rest from X = 1: a(0) = {scales.initial_amplitude}, psi(0) = {scales.initial_phase}")
    if found.start is not None:
        lines.append("any start X(0) = r cos theta, X'(0) = -r sin theta, 0 < theta < pi:")
        lines += [f"  {name} = {e}" for name, e in found.start.items()]
    lines += [f"turning-point gauge from no-first-harmonic: {name} = {e}" for name, e in (found.map or {}).items()]
    if found.waves is not None:
        one = len(scales.symbols) == 1
        delta = "delta^k, delta = epsilon a^(d-1)" if one else "prod_i (strength_i a^(d_i-1))^k_i"
        where = f"d: degree of the force; at psi = {request['phase']}, certified:"
        lines.append(f"X = a (cos psi + sum_k x_k {delta}), {where}")
        lines += [f"  x_{n} = {value}" for n, value in found.waves.items()]
    lines += [f"{letter} = {value}" for letter, value in found.strengths.items()]
    lines += ["X_n: on 0 < psi < pi, and X(a, psi + pi) = -X(a, psi)"] if scales.gauge == TURNING_POINT else []
    lines.append("expanded by rings of exact rationals" + ("" if found.by_sympy is None else _said(found)))
    return "\n".join([*lines, f"gauge: {scales.gauge}"])


def _said(found: Derived) -> str:
    differ = "; ".join(found.differences)
    return f"; by SymPy alone: they differ in {differ}" if differ else ", and by SymPy alone: equal term by term"


_ORDER = whole(1, MAX_ORDER).called(suffix=f" (1 to {MAX_ORDER}, to 12 unless exponents are integers")
_FORMULAS = "the answer is formulas, exact: nothing to round, to tabulate or to draw"


@question(
    Offers(
        latex="print LaTeX instead of text",
        own_latex=True,
        data=_data,
        text=_text,
        as_latex=lambda found, _: found.latex(),
        letters=lambda found, _: found.scales._letters(),
        failed=lambda found, _: bool(found.differences),
        lacks=dict.fromkeys(("csv", "plot", "points"), _FORMULAS),
    ),
    pairs=(
        excludes(
            "map", "alpha=symbolic", "no-first-harmonic does not exist for a symbolic exponent", "polynomial forces"
        ),
        excludes("phase", "alpha=symbolic", "a symbolic exponent has no numbers", "exponents that are numbers"),
    ),
    name="multiple-scales",
    example="--alpha 3 --order 1",
    rests="exact: each order's equation is put back by SymPy",
)
def derived(
    law: Annotated[LawLike, _LAW],
    *,
    order: Annotated[int, _ORDER] = 2,
    gauge: Annotated[str | None, choice(*GAUGES, letter="GAUGE").called(suffix="")] = None,
    map: Annotated[bool, FLAG] = False,  # noqa: A002 (the word of the command)
    start: Annotated[bool, FLAG] = False,
    phase: Annotated[Number | None, REAL.called(letter="PSI")] = None,
    engine: Annotated[str, choice("rings", "sympy", letter="ENGINE")] = "rings",
    digits: Annotated[int, digits(MAX_DIGITS)] = 30,
    max_seconds: Annotated[Number, SECONDS] = 60,
) -> Derived:
    """The classical multiple-scale derivation, order by order: equation, conditions, rates, solution.

      asymptotics multiple-scales --alpha 3 --order 4
      asymptotics multiple-scales --alpha 3/2 --order 2 --latex
      asymptotics multiple-scales --alpha symbolic
      asymptotics multiple-scales --law 1 --law 3 --order 3 --json
      asymptotics multiple-scales --law 1 --spring 3 --order 4
      asymptotics multiple-scales --law 1 --law 1,2 --order 4
      asymptotics multiple-scales --alpha 3/2 --spring pendulum
      asymptotics multiple-scales --alpha symbolic --spring 3
      asymptotics multiple-scales --alpha 5/2 --order 6 --phase 1 --digits 20
      asymptotics multiple-scales --alpha 2 --order 8
      asymptotics multiple-scales --alpha 3 --order 3 --gauge turning-point --map

    Scales T_n = epsilon^n tau, X = X_0 + epsilon X_1 + ..., X_0 = a cos psi, V_n = (X')_n.  Every law, any order:
    integer exponents exactly, with X_n polynomials in psi, sin psi, cos psi; others (and symbolic) with closed forms
    where there are any and named integrals beyond, to order 12.  Strengths stay symbols: epsilon_i of the losses, c_j
    of the springs, theta_0 of a pendulum (x in units of theta_0), in the order given; their values are told below the
    equations.

    Gauges: no-first-harmonic (a is the coefficient of cos psi; the default for polynomial forces |x|^M x'|x'|^(A-1), A
    odd and M even, x^P |x'|^Q, P odd and Q even) and turning-point (a is the turning amplitude, X_n on 0 < psi < pi and
    X(a, psi + pi) = -X(a, psi); the default for all other laws).  --map tells the exact map between them where both
    exist.  --phase: every X_n there (turning-point gauge), certified, the named integrals among them.
    In Python: ``asy.multiple_scales``, ``asy.any_start``, ``asy.map_of_gauges``, ``asy.waveforms``.

    Parameters
    ----------
    law
        an exponent, several, a law, or "symbolic"
    order
        the highest order
    gauge
        turning-point or no-first-harmonic (default: see above)
    map
        the exact map from no-first-harmonic to turning-point too
    start
        a(0), psi(0) of any start, in motion too
    phase
        the value of every X_n at this phase (rad), certified
    engine
        what expands: rings of exact rationals, or SymPy alone beside them (odd exponents to order 6, 2 to order 4)
    digits
        significant digits, correctly rounded
    max_seconds
        the time the request may take, in seconds

    Raises
    ------
    InputError
        for an order out of range, and a gauge that does not exist for the law
    LimitError
        for too much work
    """
    given: Any = law
    assert isinstance(given, TermsInUnits)
    scales = _scales(given, order, gauge)
    bare = None if isinstance(given.terms, str) else Law.from_terms(given.terms.terms)
    return Derived(
        scales,
        _strengths(given, scales),
        any_start(scales) if start else None,
        map_of_gauges(bare, order=order) if map and bare is not None else None,
        None if phase is None else _waves(given, scales, order, phase, digits),
        _by_sympy(given, scales, order) if engine == "sympy" else None,
    )


def _scales(given: TermsInUnits, order: int, gauge: str | None) -> MultipleScales:
    """The derivation; a symbolic exponent stands alone or beside springs."""
    if isinstance(given.terms, str):
        return symbolic_multiple_scales(given.springs, order, gauge)
    return multiple_scales(Law.from_terms(given.terms.terms, given.terms.notes), order=order, gauge=gauge)


def _by_sympy(given: TermsInUnits, scales: MultipleScales, order: int) -> Ansatz:
    """The ansatz solved by SymPy alone; InputError for another law or gauge."""
    terms = () if isinstance(given.terms, str) else given.terms.terms
    if len(terms) != 1 or not terms[0].is_power_of_velocity or not terms[0].velocity.is_integer:
        raise InputError("engine", "SymPy alone expands one power of the velocity", "an odd exponent, or 2")
    found = ansatz(int(terms[0].velocity.rational), order)
    if found.gauge != scales.gauge:
        raise InputError("engine", f"its gauge is {found.gauge}", f"the gauge {found.gauge}")
    return found


def _waves(given: TermsInUnits, scales: MultipleScales, order: int, phase: Any, digits: int) -> dict[str, str]:
    """x_k at a phase; InputError in the other gauge and without numbers."""
    if scales.gauge != TURNING_POINT:
        raise InputError("phase", f"the gauge is {scales.gauge}", f"the gauge {TURNING_POINT}")
    if order > MAX_OPEN_ORDER:
        raise InputError("order", f"{order} is out of range", f"an integer from 1 to {MAX_OPEN_ORDER}")
    assert isinstance(given.terms, GivenTerms)  # a symbolic exponent has no values: refused before
    # NumPy and splines: only values of waveforms need them.
    Waveforms = import_module("asymptotics.curves.waves").Waveforms
    # In the order of the symbols above, so that the indices of x_k are those of the strengths in the text.
    values = Waveforms(tuple(ordered(given.terms.terms, scales)), order).at(phase, digits=digits)
    return {str(k) if isinstance(k, int) else ",".join(str(part) for part in k): value for k, value in values.items()}


def _strengths(given: TermsInUnits, scales: MultipleScales) -> dict[str, str]:
    """The strengths that were given, by the letters of the derivation."""
    if isinstance(given.terms, str):
        return {} if given.epsilon is None else {"epsilon": str(given.epsilon)}
    return _strengths_given(given.terms, scales) if given.terms.known else {}


def _strengths_given(given: GivenTerms, scales: MultipleScales) -> dict[str, str]:
    told: dict[str, str] = {}
    for letter, sign in (("epsilon", -1), ("c", 1)):
        # A pendulum has the angle theta_0 for its letter, which no strength is told of.
        terms = [t for t in ordered(given.terms, scales) if t.sign == sign and not t.family]
        told |= {letter + (f"_{i}" if len(terms) > 1 else ""): str(t.strength) for i, t in enumerate(terms)}
    return told
